// An upright round cylinder on the plane z = 0: a square core, and four blocks
// around it, of hexahedra with 20 nodes.

radius = 5;    // [length]
height = 8;    // [length]
core = 0.5;    // half the diagonal of the core, over the radius
n_quarter = 4; // elements along a quarter of the circumference
n_radial = 2;  // elements from the core to the outside
n_height = 6;  // elements along the axis

Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

Point(9) = {0, 0, 0};
For i In {0:3}
  angle = (2 * i + 1) * Pi / 4;
  Point(1 + i) = {core * radius * Cos(angle), core * radius * Sin(angle), 0};
  Point(5 + i) = {radius * Cos(angle), radius * Sin(angle), 0};
EndFor

// Lines of the core, arcs of the outside, and spokes between them.
For i In {0:3}
  j = (i + 1) % 4;
  Line(1 + i) = {1 + i, 1 + j};
  Circle(5 + i) = {5 + i, 9, 5 + j};
  Line(9 + i) = {1 + i, 5 + i};
EndFor
Transfinite Curve{1:8} = n_quarter + 1;
Transfinite Curve{9:12} = n_radial + 1;

Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
For i In {0:3}
  j = (i + 1) % 4;
  Curve Loop(2 + i) = {5 + i, -(9 + j), -(1 + i), 9 + i};
  Plane Surface(2 + i) = {2 + i};
EndFor
Transfinite Surface{1:5};
Recombine Surface{1:5};

// For each surface: its copy at the top, the volume, and the four sides.
e[] = Extrude {0, 0, height} { Surface{1:5}; Layers{n_height}; Recombine; };

Physical Volume("body") = {e[1], e[7], e[13], e[19], e[25]};
Physical Surface("bottom") = {1:5};
Physical Surface("top") = {e[0], e[6], e[12], e[18], e[24]};
Physical Surface("outer") = {e[8], e[14], e[20], e[26]};
