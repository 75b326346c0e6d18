// A slice of a round cake on the plane z = 0, with its tip at the origin and
// the middle of its outside on the x axis: crumb, cream, and crumb again. Each
// half of the sector is divided into three quadrilaterals, so that the elements
// at the tip are hexahedra as elsewhere. Left and right are as seen from the
// tip.

radius = 10;           // [length]
angle = 50 * Pi / 180; // [rad]
crumb_height = 2.5;    // of each of the two layers [length]
cream_height = 1;      // [length]
tip = 0.45;            // length of the block at the tip, over the radius
n_quarter = 2;         // elements along a quarter of the outside
n_radial = 4;          // elements from the block at the tip to the outside
n_crumb = 2;           // elements along the height of each layer of crumb
n_cream = 1;           // elements along the height of the cream

Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

// The ground: half of the slice on each side of the x axis, which is so a line
// of the mesh; a half is a block at the tip and two towards the outside.
Point(1) = {0, 0, 0};
Point(2) = {tip * radius, 0, 0};
Point(3) = {radius, 0, 0};
For side In {0:1}
  sign = 2 * side - 1;
  p = 10 * (side + 1);
  c = Cos(angle / 2);
  s = sign * Sin(angle / 2);
  c_half = Cos(angle / 4);
  s_half = sign * Sin(angle / 4);
  Point(p + 1) = {1.2 * tip * radius * c_half, 1.2 * tip * radius * s_half, 0};
  Point(p + 2) = {tip * radius * c, tip * radius * s, 0};
  Point(p + 3) = {radius * c_half, radius * s_half, 0};
  Point(p + 4) = {radius * c, radius * s, 0};
EndFor
Line(1) = {1, 2};
Line(2) = {2, 3};
For side In {0:1}
  p = 10 * (side + 1);
  Line(p + 1) = {2, p + 1};
  Line(p + 2) = {p + 1, p + 2};
  Line(p + 3) = {p + 2, 1};
  Line(p + 4) = {p + 1, p + 3};
  Line(p + 5) = {p + 2, p + 4};
  Circle(p + 6) = {3, 1, p + 3};
  Circle(p + 7) = {p + 3, 1, p + 4};
  Transfinite Curve{1, p + 1, p + 2, p + 3, p + 6, p + 7} = n_quarter + 1;
  Transfinite Curve{2, p + 4, p + 5} = n_radial + 1;
  Curve Loop(p + 1) = {1, p + 1, p + 2, p + 3};
  Curve Loop(p + 2) = {2, p + 6, -(p + 4), -(p + 1)};
  Curve Loop(p + 3) = {p + 4, p + 7, -(p + 5), -(p + 2)};
  Plane Surface(p + 1) = {p + 1};
  Plane Surface(p + 2) = {p + 2};
  Plane Surface(p + 3) = {p + 3};
EndFor
ground[] = {11, 12, 13, 21, 22, 23};
Transfinite Surface{ground[]};
Recombine Surface{ground[]};

heights[] = {crumb_height, cream_height, crumb_height};
numbers[] = {n_crumb, n_cream, n_crumb};
floor[] = ground[];
For layer In {0:2}
  // For each surface: its copy above, the volume, and the four sides, in the
  // order of the loop.
  e[] = Extrude {0, 0, heights[layer]} {
    Surface{floor[]}; Layers{numbers[layer]}; Recombine;
  };
  For i In {0:5}
    volumes[] += {e[6 * i + 1]};
  EndFor
  right[] += {e[5], e[16]};
  left[] += {e[23], e[34]};
  outer[] += {e[9], e[15], e[27], e[33]};
  floor[] = {e[0], e[6], e[12], e[18], e[24], e[30]};
EndFor

Physical Volume("crumb") = {volumes[{0:5}], volumes[{12:17}]};
Physical Volume("cream") = {volumes[{6:11}]};
Physical Surface("bottom") = {ground[]};
Physical Surface("top") = {floor[]};
Physical Surface("outer") = {outer[]};
Physical Surface("left") = {left[]};
Physical Surface("right") = {right[]};
