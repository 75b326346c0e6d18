// A block of three veneers, one upon the other, in plane strain.

width = 12;    // along x [length]
height = 6;    // of all veneers [length]
n_width = 12;  // elements along x
n_veneer = 4;  // elements through a veneer

Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

Point(1) = {0, 0, 0};
Point(2) = {width, 0, 0};
Line(1) = {1, 2};
Transfinite Curve{1} = n_width + 1;

// Each: its line at the top, the surface, and its sides.
lower[] = Extrude {0, height / 3, 0} { Line{1}; Layers{n_veneer}; Recombine; };
core[] = Extrude {0, height / 3, 0} { Line{lower[0]}; Layers{n_veneer}; Recombine; };
upper[] = Extrude {0, height / 3, 0} { Line{core[0]}; Layers{n_veneer}; Recombine; };

Physical Surface("faces") = {lower[1], upper[1]};
Physical Surface("core") = {core[1]};
Physical Curve("bottom") = {1};
