# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two bars of unit width, one behind the other along z, for gmsh."""

TWO_BARS = """SetFactory("Built-in"); Mesh.ElementOrder = 2; Mesh.SecondOrderIncomplete = 1;
Point(1) = {0,0,0}; Point(2) = {1,0,0}; Point(3) = {1,1,0}; Point(4) = {0,1,0};
Line(1) = {1,2}; Line(2) = {2,3}; Line(3) = {3,4}; Line(4) = {4,1};
Curve Loop(1) = {1:4}; Plane Surface(1) = {1}; Transfinite Curve{1:4} = 2;
Transfinite Surface{1}; Recombine Surface{1};
a[] = Extrude {0,0,1} { Surface{1}; Layers{2}; Recombine; };
b[] = Extrude {0,0,1} { Surface{a[0]}; Layers{2}; Recombine; };
Physical Volume("hard") = {a[1]}; Physical Volume("soft") = {b[1]};
Physical Surface("bottom") = {1}; Physical Surface("top") = {b[0]};
Physical Surface("back") = {a[2], b[2]}; Physical Surface("side") = {a[5], b[5]};
"""
