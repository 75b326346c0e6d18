# SPDX-License-Identifier: LGPL-2.1-or-later
"""Bodies that flow."""

import math

import cylinder
import indentation
import sphere
from figures import OPTIONS, ROOT, missing, picture, table

# sigma_xx, yy and zz of the path's points, with 2000 steps to each, by an independent
# program.
EXACT = ((7.5, 2.5, 2.5), (11.6667, 6.6667, 6.6667), (14.1667, 14.1667, 9.1667),
         (16.3175, 19.7121, 13.9704), (9.8257, 15.5603, 12.1140),
         (5.0976, 10.6445, 9.2579), (2.5976, 3.1445, 6.7579), (.2349, -2.9970, 2.7621))


def path():
    """NAFEMS's element in plane strain, E = 250 GPa, ν = 0.25, yield stress 5 MPa, without
    hardening, along the strains (ε_x, ε_y) / 10⁻⁴ = (.25, 0), (.5, 0), (.5, .25), (.5, .5),
    (.25, .5), (0, .5), (0, .25), (0, 0). Radial return with one step to each point, and
    with more of them. Exact: 2000 steps, by an independent program. Numbers are those of the
    test `tests/material/j2_plasticity`."""
    computed = {}
    for line in (ROOT / "tests/material/j2_plasticity.output").read_text().splitlines():
        if line.startswith("path "):
            n, point, *stresses = line.split()[1:]
            computed.setdefault(int(n), []).append([float(s) for s in stresses])
    points = range(1, 9)
    image = picture("path", "Stresses along the path [MPa]", [
        (f"exact, σ_{'xyz'[d]}{'xyz'[d]}", points, [s[d] for s in EXACT]) for d in range(3)
    ], [(f"{n} step{'s' * (n > 1)} to a point", list(points) * 3,
         [s[d] for d in range(3) for s in computed[n]]) for n in (1, 10, 1000)],
        xlabel="point of the path", ylabel="stress [MPa]")
    rows = [[f"{point}", *(", ".join(f"{s:.4f}" for s in stresses[point - 1])
                           for stresses in (EXACT, computed[1000], computed[1]))]
            for point in points]
    errors = [[n, f"{max(math.dist(s, e) for s, e in zip(stresses, EXACT)):.2g}"]
              for n, stresses in computed.items()]
    return "\n\n".join([image, table(
        ["point", "exact σ_xx, σ_yy, σ_zz [MPa]", "1000 steps", "one step"], rows),
        table(["steps to a point", "largest distance from the exact stress [MPa]"], errors),
        missing("The path turns in strain space, which one `Time/Load factor` cannot do: "
                "the law is driven without the program around it. NAFEMS's own printed "
                "stresses were not at hand.")])


def wedge():
    """A rigid wedge without friction presses on rigid and perfectly plastic ground in plane
    strain (Hill, Lee and Tupper 1947). The computed body has the groove and the lips of
    their solution, E/k = 1000, ν = 0.49 and small strain; it is pushed further by 3 % of the
    depth c, where the force has levelled off. Test: `verification/indentation`."""
    angles = [a / 2 for a in range(10, 121)]
    curve = [indentation.slip_lines(math.radians(a))[2] for a in angles]
    degrees = (15, 20, 30, 45)
    found = {n: [indentation.force(OPTIONS, a, n) for a in degrees] for n in (6, 12)}
    image = picture("wedge", "Wedge in plastic ground, no friction", [
        ("Hill, Lee and Tupper", angles, curve)],
        [(f"{n} elements along a flank", degrees, f) for n, f in found.items()],
        xlabel="half angle of the wedge [degrees]", ylabel="force / (2 k c)", yscale="log")
    rows = []
    for i, a in enumerate(degrees):
        exact = indentation.slip_lines(math.radians(a))[2]
        rows.append([f"{a}°", f"{exact:.4f}", *(f"{f[i]:.4f} ({f[i] / exact - 1:+.1%})"
                                              for f in found.values())])
    return "\n\n".join([image, table(
        ["half angle", "P/(2 k c)", *(f"{n} elements along a flank" for n in found)], rows),
        "The excess falls with the elements: a hat at the rim of the contact is touched whole "
        "or not at all. 16 elements are within 3 % ([verification.md](verification.md)). The force "
        "has no sharp limit: pushed by 4.5 % it is 0.3 to 0.9 % more, by 6 % up to 2.7 % more "
        "(20°, 6 and 16 elements; 30°, 16 elements, by 4.5 % only).",
        missing(
            "The lips are given, not found: from flat ground the surface under the edge "
            "must part, new surface slides up the flanks, and the mesh folds there under "
            "finite strain. At 10° the flanks of the groove are so steep that the program does "
            "not count them among the outer faces that a blade meets. Green's photographs of plasticine (1951) have no numbers.")])


def pressure():
    """Plastic flow in a thick cylinder (radii 3 and 9, plane strain) and a thick sphere
    (radii 1 and 2), incompressible and without hardening, up to a radius c. Tests:
    `verification/cylinder`, `verification/sphere`."""
    results = [*cylinder.plastic_rows(OPTIONS), *sphere.plastic_rows(OPTIONS)]
    rows = [[r.quantity, r.mesh, f"{r.reference:.6g}", f"{r.computed:.6g}",
             f"{r.ratio - 1:+.2%}"] for r in results]
    return table(["quantity", "elements", "closed form", "computed", "difference"], rows)
