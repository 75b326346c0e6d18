# SPDX-License-Identifier: LGPL-2.1-or-later
"""Elastic bodies: fibres, and large rotations and strains."""

import fibres
import finite
from figures import OPTIONS, missing, picture, table


def spruce():
    """Sitka spruce pulled at an angle to its fibres in the L–T plane, E_L = 9050, E_T = 403
    (static), G_LT = 1095 MPa (ultrasound; both Acta Acustica 2025, aacus240113, table 5),
    ν_LT = 0.467 (Wood Handbook). Closed form: Lekhnitskii. Test: `verification/fibres`, to 10⁻⁶."""
    degrees = (0, 10, 20, 30, 45, 60, 90)
    found = [fibres.modulus(OPTIONS, a) for a in degrees]
    image = picture("spruce", "Modulus of spruce at an angle to its fibres", [
        ("closed form", range(91), [fibres.closed_form(a) for a in range(91)])],
        [("computed", degrees, found)], xlabel="angle to the fibres [degrees]",
        ylabel="modulus [MPa]", yscale="log")
    rows = [[f"{a}°", f"{fibres.closed_form(a):.2f}", f"{f:.2f}",
             f"{abs(f / fibres.closed_form(a) - 1):.0e}"] for a, f in zip(degrees, found)]
    softer = fibres.closed_form(10, .061 * fibres.ALONG)
    return "\n\n".join([image, table(["angle", "closed form [MPa]", "computed", "difference"],
                                     rows),
                        missing("Measured moduli at angles between 0 and 90°, of the "
                                "same wood as the constants: the static and the ultrasonic "
                                "ones differ by 7 % in E_L. With the Wood Handbook's ratio "
                                "G_LT = 0.061 E_L = 552 MPa the modulus at 10° is "
                                f"{softer:.0f} MPa.")])


def cantilever():
    """Sze, Liu and Lo (2004): a cantilever under a shear force at its end, L = 10, b = 1,
    h = 0.1, E = 1.2·10⁶, ν = 0; forces over the largest one, 4. Here 40 × 1 × 1 elements
    of 20 nodes, published: shells. Test: `verification/finite`."""
    parts = list(finite.BEAM)[1::2]
    found = [finite.beam(OPTIONS, "linear elastic", 40, part) for part in parts]
    image = picture("cantilever", "Cantilever of Sze, Liu and Lo", [
        ("+published", [u for v in finite.BEAM.values() for u in v],
         [part for part in finite.BEAM for _ in range(2)])],
        [(f"computed, {name}", [f[d] for f in found], parts)
         for d, name in enumerate(("shortening", "deflection"))],
        xlabel="displacement of the end", ylabel="force over the largest")
    rows = [[f"{part:.1f}", *finite.BEAM[part], *(f"{x:.3f}" for x in f)]
            for part, f in zip(parts, found)]
    return "\n\n".join([image, table(
        ["force", "published shortening", "deflection", "computed shortening", "deflection"],
        rows), missing("Nothing: published values have three decimals.")])


# Displacements of Pelteret and McBride's code gallery, u_y at (48, 52).
LINEAR = {2: 8.638, 4: 12.07, 8: 13.86, 16: 14.49, 32: 14.67, 64: 14.72}
QUADRATIC = {2: 14.30, 4: 14.65, 8: 14.71, 16: 14.73, 32: 14.74, 64: 14.74}


def membrane():
    """Cook's membrane under finite strain with the data of deal.II's code gallery (Pelteret
    and McBride, 10.5281/zenodo.1228964): deflection over elements along an edge. The 20-node
    element lies between their linear and their 27-node one. Test: `verification/finite`."""
    rows = {int(row.mesh.split()[0]): row.computed
            for row in finite.membrane_rows(OPTIONS) if "compressible" in row.quantity}
    image = picture("membrane", "Cook's membrane under finite strain", [
        ("published, 8 nodes", list(LINEAR), list(LINEAR.values())),
        ("published, 27 nodes", list(QUADRATIC), list(QUADRATIC.values()))],
        [("computed, 20 nodes", list(rows), list(rows.values()))],
        xlabel="elements along an edge", ylabel="deflection [mm]", xscale="log")
    return "\n\n".join([image, table(
        ["elements along an edge", "published, 8 nodes", "computed, 20 nodes",
         "published, 27 nodes"],
        [[n, LINEAR[n], f"{u:.4f}", QUADRATIC[n]] for n, u in rows.items()]),
        missing("Nothing but finer meshes.")])


def block():
    """SPP 1748's block, nearly incompressible (ν = 0.4984), under a dead pressure on a
    quarter of its top (Schröder et al. 2021): sinking of the middle on 4 × 4 × 4 elements of
    20 nodes, which is their trunk space of order 2. Test: `verification/finite`."""
    found = {row.quantity.split()[5]: row for row in finite.block_rows(OPTIONS)
             if row.quantity.startswith("block")}
    return "\n\n".join([table(
        ["part of the pressure", "published", "independent program", "computed [mm]"],
        [[part, "19.637" if part == "100%" else "", row.reference, f"{row.computed:.4f}"]
         for part, row in found.items()]),
        missing("The sinking at parts of the load is not published, and 20.00 is "
                "reached on finer meshes.")])
