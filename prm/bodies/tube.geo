// A short hollow cylinder that stands on the plane z = 0, of hexahedra with 20
// nodes.

inner_radius = 4; // [length]
outer_radius = 6; // [length]
height = 5;       // [length]
n_quarter = 4;    // elements along a quarter of the circumference
n_radial = 2;     // elements through the wall
n_height = 3;     // elements along the axis

Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

Point(9) = {0, 0, 0};
For i In {0:3}
  angle = i * Pi / 2;
  Point(1 + i) = {inner_radius * Cos(angle), inner_radius * Sin(angle), 0};
  Point(5 + i) = {outer_radius * Cos(angle), outer_radius * Sin(angle), 0};
EndFor
For i In {0:3}
  j = (i + 1) % 4;
  Circle(1 + i) = {1 + i, 9, 1 + j};
  Circle(5 + i) = {5 + i, 9, 5 + j};
  Line(9 + i) = {1 + i, 5 + i};
EndFor
Transfinite Curve{1:8} = n_quarter + 1;
Transfinite Curve{9:12} = n_radial + 1;
For i In {0:3}
  j = (i + 1) % 4;
  Curve Loop(1 + i) = {5 + i, -(9 + j), -(1 + i), 9 + i};
  Plane Surface(1 + i) = {1 + i};
EndFor
Transfinite Surface{1:4};
Recombine Surface{1:4};

// For each surface: its copy at the top, the volume, and the four sides, in the
// order of the loop.
e[] = Extrude {0, 0, height} { Surface{1:4}; Layers{n_height}; Recombine; };

Physical Volume("wall") = {e[1], e[7], e[13], e[19]};
Physical Surface("bottom") = {1:4};
Physical Surface("top") = {e[0], e[6], e[12], e[18]};
Physical Surface("outer") = {e[2], e[8], e[14], e[20]};
Physical Surface("inner") = {e[4], e[10], e[16], e[22]};
