// Half a ball on the plane z = 0: a core, four blocks around it and one on top,
// of hexahedra with 20 nodes.

DefineConstant[ n = 1 ]; // elements through the blocks, and half the others
radius = 5;  // [length]
core = 0.5;  // of the blocks' corners inside, over those outside

Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

Point(20) = {0, 0, 0};
For i In {0:3}
  c = radius * Cos((2 * i + 1) * Pi / 4);
  s = radius * Sin((2 * i + 1) * Pi / 4);
  up = Sqrt(2 / 3);
  Point(1 + i) = {core * c, core * s, 0};
  Point(5 + i) = {c, s, 0};
  Point(11 + i) = {core * up * c, core * up * s, core * radius / Sqrt(3)};
  Point(15 + i) = {up * c, up * s, radius / Sqrt(3)};
EndFor
For i In {0:3}
  j = (i + 1) % 4;
  Line(1 + i) = {1 + i, 1 + j};
  Circle(5 + i) = {5 + i, 20, 5 + j};
  Line(9 + i) = {1 + i, 5 + i};
  Line(21 + i) = {11 + i, 11 + j};
  Circle(25 + i) = {15 + i, 20, 15 + j};
  Line(29 + i) = {11 + i, 15 + i};
  Line(31 + 2 + i) = {1 + i, 11 + i};
  Circle(37 + i) = {5 + i, 20, 15 + i};
EndFor
Transfinite Curve{1:8, 21:28, 33:40} = 2 * n + 1;
Transfinite Curve{9:12, 29:32} = n + 1;

Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
Curve Loop(2) = {21:24};
Plane Surface(2) = {2};
Curve Loop(3) = {25:28};
Surface(3) = {3} In Sphere {20};
For i In {0:3}
  j = (i + 1) % 4;
  // Below, inside, outside, between neighbours, and below the block on top.
  Curve Loop(10 + i) = {5 + i, -(9 + j), -(1 + i), 9 + i};
  Plane Surface(10 + i) = {10 + i};
  Curve Loop(20 + i) = {1 + i, 33 + j, -(21 + i), -(33 + i)};
  Plane Surface(20 + i) = {20 + i};
  Curve Loop(30 + i) = {5 + i, 37 + j, -(25 + i), -(37 + i)};
  Surface(30 + i) = {30 + i} In Sphere {20};
  Curve Loop(40 + i) = {9 + i, 37 + i, -(29 + i), -(33 + i)};
  Plane Surface(40 + i) = {40 + i};
  Curve Loop(50 + i) = {25 + i, -(29 + j), -(21 + i), 29 + i};
  Plane Surface(50 + i) = {50 + i};
EndFor
Surface Loop(1) = {1, 2, 20:23};
Volume(1) = {1};
Surface Loop(2) = {2, 3, 50:53};
Volume(2) = {2};
For i In {0:3}
  j = (i + 1) % 4;
  Surface Loop(3 + i) = {10 + i, 20 + i, 30 + i, 40 + i, 40 + j, 50 + i};
  Volume(3 + i) = {3 + i};
EndFor
Transfinite Surface{1:3, 10:13, 20:23, 30:33, 40:43, 50:53};
Recombine Surface{1:3, 10:13, 20:23, 30:33, 40:43, 50:53};
Transfinite Volume{1:6};

Physical Volume("body") = {1:6};
Physical Surface("below") = {1, 10:13};
Physical Surface("outer") = {3, 30:33};
