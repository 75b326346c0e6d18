// A sausage: a round cylinder that lies along y, at the height of its radius: a
// square core, and four blocks around it, of hexahedra with 20 nodes.

n = 2; // elements through the blocks, and half the others
radius = 10;  // [length]
length = 50;  // [length]
core = 0.5;   // half the diagonal of the core, over the radius

Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

Point(9) = {0, 0, radius};
For i In {0:3}
  angle = (2 * i + 1) * Pi / 4;
  Point(1 + i) = {core * radius * Cos(angle), 0, radius + core * radius * Sin(angle)};
  Point(5 + i) = {radius * Cos(angle), 0, radius + radius * Sin(angle)};
EndFor

// Lines of the core, arcs of the outside, and spokes between them.
For i In {0:3}
  j = (i + 1) % 4;
  Line(1 + i) = {1 + i, 1 + j};
  Circle(5 + i) = {5 + i, 9, 5 + j};
  Line(9 + i) = {1 + i, 5 + i};
EndFor
Transfinite Curve{1:8} = 2 * n + 1;
Transfinite Curve{9:12} = n + 1;

Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
For i In {0:3}
  j = (i + 1) % 4;
  Curve Loop(2 + i) = {5 + i, -(9 + j), -(1 + i), 9 + i};
  Plane Surface(2 + i) = {2 + i};
EndFor
Transfinite Surface{1:5};
Recombine Surface{1:5};

// For each surface: its copy at the end, the volume, and the four sides.
e[] = Extrude {0, length, 0} { Surface{1:5}; Layers{10}; Recombine; };

Physical Volume("body") = {e[1], e[7], e[13], e[19], e[25]};
Physical Surface("below") = {e[20]};
Physical Surface("outer") = {e[8], e[14], e[26]};
Physical Surface("ends") = {1:5, e[0], e[6], e[12], e[18], e[24]};
