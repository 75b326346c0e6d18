// A beam of three plies along x, of equal heights along z.

length = 60;     // [length]
width = 1;       // along y [length]
height = 1.5;    // of all plies [length]
n_length = 30;   // elements along the beam
n_ply = 1;       // elements through a ply

Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
Point(3) = {length, width, 0};
Point(4) = {0, width, 0};
Line(1) = {1, 2};
Line(2) = {2, 3};
Line(3) = {3, 4};
Line(4) = {4, 1};
Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Transfinite Curve{1, 3} = n_length + 1;
Transfinite Curve{2, 4} = 2;
Transfinite Surface{1};
Recombine Surface{1};

bottom[] = Extrude {0, 0, height / 3} { Surface{1}; Layers{n_ply}; Recombine; };
middle[] = Extrude {0, 0, height / 3} { Surface{bottom[0]}; Layers{n_ply}; Recombine; };
top[] = Extrude {0, 0, height / 3} { Surface{middle[0]}; Layers{n_ply}; Recombine; };

// The sides of each ply in the order of the lines: front, right, back, left.
Physical Volume("faces") = {bottom[1], top[1]};
Physical Volume("core") = {middle[1]};
Physical Surface("left") = {bottom[5], middle[5], top[5]};
Physical Surface("right") = {bottom[3], middle[3], top[3]};
Physical Surface("glue") = {bottom[0], middle[0]};
