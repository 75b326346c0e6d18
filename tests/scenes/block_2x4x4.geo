// The cube of block_2x4x4.prm as a mesh of gmsh: the same elements with other
// numbers.
Mesh.ElementOrder = 2;
Mesh.SecondOrderIncomplete = 1;
Mesh.SecondOrderLinear = 1;
Point(1) = {0, 0, 0};
line[] = Extrude {0, 0, 10} { Point{1}; Layers{4}; Recombine; };
wall[] = Extrude {10, 0, 0} { Curve{line[1]}; Layers{2}; Recombine; };
block[] = Extrude {0, 10, 0} { Surface{wall[1]}; Layers{4}; Recombine; };
Physical Volume("block") = {block[1]};
bottom[] = Surface In BoundingBox {-1, -1, -1, 11, 11, 0.1};
Physical Surface("ground") = {bottom[]};
