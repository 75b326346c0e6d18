// An L that stands on the plane z = 0: a leg with a foot in the direction of
// x, of the same depth along y. Its hexahedra have 8 nodes.

leg_width = 3;   // along x [length]
leg_height = 9;  // from the ground [length]
foot_length = 5; // from the leg [length]
foot_height = 3; // [length]
depth = 4;       // along y [length]
size = 1;        // of the elements, nearly [length]

Mesh.ElementOrder = 1;

// The lower edge along x, of the leg and of the foot.
Point(1) = {0, 0, 0};
a[] = Extrude {leg_width, 0, 0} { Point{1}; Layers{Ceil(leg_width / size)}; };
b[] = Extrude {foot_length, 0, 0} {
  Point{a[0]}; Layers{Ceil(foot_length / size)};
};

// The ground: for each line its copy, the surface, and the two ends.
g[] = Extrude {0, depth, 0} {
  Line{a[1], b[1]}; Layers{Ceil(depth / size)}; Recombine;
};

// The foot with the lower part of the leg, and the rest of the leg: for each
// surface its copy above, the volume, and the sides to the front, the right,
// the back and the left.
f[] = Extrude {0, 0, foot_height} {
  Surface{g[1], g[5]}; Layers{Ceil(foot_height / size)}; Recombine;
};
l[] = Extrude {0, 0, leg_height - foot_height} {
  Surface{f[0]}; Layers{Ceil((leg_height - foot_height) / size)}; Recombine;
};

Physical Volume("body") = {f[1], f[7], l[1]};
Physical Surface("bottom") = {g[1], g[5]};
Physical Surface("top") = {l[0]};
Physical Surface("foot") = {f[6]};
Physical Surface("toe") = {f[9]};
Physical Surface("heel") = {f[5], l[5]};
Physical Surface("front") = {f[2], f[8], l[2]};
Physical Surface("back") = {f[4], f[10], l[4]};
