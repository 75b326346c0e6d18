// A ring in the plane, of quadrilaterals with 8 nodes: a body of 2 dimensions.

inner_radius = 4; // [length]
outer_radius = 6; // [length]
n_quarter = 6;    // elements along a quarter of the circumference
n_radial = 3;     // elements through the wall

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

Physical Surface("wall") = {1:4};
Physical Curve("outer") = {5:8};
Physical Curve("inner") = {1:4};
