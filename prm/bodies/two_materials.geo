// A soft block on the plane z = 0 with a hard round rod in its middle, upright:
// where they meet they have the same nodes.

width = 12;    // of the block along x and y [length]
height = 10;   // [length]
radius = 4;    // of the rod [length]
core = 0.5;    // half the diagonal of the rod's square core, over the radius
n_quarter = 2; // elements along a quarter of the rod, and along each side
n_rod = 1;     // elements from the rod's core to its outside
n_block = 2;   // elements from the rod to the outside of the block
n_height = 5;  // elements along the height

Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;

Point(13) = {0, 0, 0};
For i In {0:3}
  x = Cos((2 * i + 1) * Pi / 4);
  y = Sin((2 * i + 1) * Pi / 4);
  Point(1 + i) = {core * radius * x, core * radius * y, 0};
  Point(5 + i) = {radius * x, radius * y, 0};
  Point(9 + i) = {width / Sqrt(2) * x, width / Sqrt(2) * y, 0};
EndFor

// The core, the rod, the block, and the spokes between them.
For i In {0:3}
  j = (i + 1) % 4;
  Line(1 + i) = {1 + i, 1 + j};
  Circle(5 + i) = {5 + i, 13, 5 + j};
  Line(9 + i) = {9 + i, 9 + j};
  Line(13 + i) = {1 + i, 5 + i};
  Line(17 + i) = {5 + i, 9 + i};
EndFor
Transfinite Curve{1:12} = n_quarter + 1;
Transfinite Curve{13:16} = n_rod + 1;
Transfinite Curve{17:20} = n_block + 1;

Curve Loop(1) = {1:4};
Plane Surface(1) = {1};
For i In {0:3}
  j = (i + 1) % 4;
  Curve Loop(2 + i) = {5 + i, -(13 + j), -(1 + i), 13 + i};
  Plane Surface(2 + i) = {2 + i};
  Curve Loop(6 + i) = {9 + i, -(17 + j), -(5 + i), 17 + i};
  Plane Surface(6 + i) = {6 + i};
EndFor
Transfinite Surface{1:9};
Recombine Surface{1:9};

// For each surface: its copy at the top, the volume, and the four sides, that
// of the loop's first line first.
e[] = Extrude {0, 0, height} { Surface{1:9}; Layers{n_height}; Recombine; };

Physical Volume("hard") = {e[1], e[7], e[13], e[19], e[25]};
Physical Volume("soft") = {e[31], e[37], e[43], e[49]};
Physical Surface("bottom") = {1:9};
Physical Surface("top") =
  {e[0], e[6], e[12], e[18], e[24], e[30], e[36], e[42], e[48]};
Physical Surface("back") = {e[32]};
Physical Surface("left") = {e[38]};
Physical Surface("front") = {e[44]};
Physical Surface("right") = {e[50]};
Physical Surface("rod") = {e[8], e[14], e[20], e[26]};
