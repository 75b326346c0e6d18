# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blades: speed, slicing, orthogonal cutting."""

import json
import math
import pathlib
import tempfile

import blade
import plane_cut
from figures import OPTIONS, ROOT, missing, picture, table
from problems import material, program

# 10 % gelatin: J/m², and mm/min.
TOUGHNESS, KNEE = 1.1, 10
# A modulus of another jelly of 10 %, and a strength that is assumed [kPa].
MODULUS, STRENGTH, FRICTION = 24, 2, .1
DIAMETERS = (.1, .2, .4)


def forte(speed):
    """The published toughness [J/m²] at a speed [mm/min]."""
    return TOUGHNESS * max(1, (speed / KNEE) ** .5)


def wire_force(speed, diameter):
    """The mean force for each width [N/m] of a wire whose edge alone is taken, in a block
    that is long beside toughness over modulus."""
    cut = plane_cut.Cut(OPTIONS, 16, 16, (100, 100), {
        **material(MODULUS, .3), "Material/Toughness": TOUGHNESS,
        "Material/Shear limit": STRENGTH / 2, "Blade/Edge radius": diameter / 2,
        "Blade/Friction": FRICTION, "Blade/Speed": speed, "Material/Rate exponent": .5,
        "Material/Rate speed": KNEE}, (25, 75))
    return cut.change("work") / cut.change("travel")


def intercept(speed):
    """Of the line through the forces over diameters, by least squares: how toughness is
    read off experiments with wires."""
    forces = [wire_force(speed, d) for d in DIAMETERS]
    mean_d, mean_f = (sum(values) / len(DIAMETERS) for values in (DIAMETERS, forces))
    slope = (sum((d - mean_d) * (f - mean_f) for d, f in zip(DIAMETERS, forces)) /
             sum((d - mean_d) ** 2 for d in DIAMETERS))
    return mean_f - slope * mean_d


def speed():
    """Gelatin of 10 % cut by wires (Forte et al. 2015, from their abstract): the toughness
    is 1.1 J/m² up to 10 mm/min and grows with the root of speed above. Computed as in the
    experiment: mean force over width with three diameters at six speeds, toughness is
    where the line through them meets the axis. `Material/Rate exponent` = 0.5 is the law
    R = R₀ (1 + (v/v₀)^½), which bends where Forte's has a corner. Test:
    `verification/blade`."""
    speeds = (.1, 1, 10, 100, 1e3, 1e4)
    found = [intercept(v) for v in speeds]
    fine = [10 ** (i / 10 - 1) for i in range(51)]
    image = picture("speed", "Toughness of gelatin against speed", [
        ("Forte et al.", fine, [forte(v) for v in fine]),
        ("law of the scene", fine, [TOUGHNESS * (1 + (v / KNEE) ** .5) for v in fine])],
        [("computed, from three wires", speeds, found)], xscale="log", yscale="log",
        xlabel="speed [mm/min]", ylabel="toughness [J/m²]")
    rows = [[f"{v:g}", f"{forte(v):.3g}", f"{TOUGHNESS * (1 + (v / KNEE) ** .5):.3g}",
             f"{f:.3g}"] for v, f in zip(speeds, found)]
    slopes = [math.log10((found[-1] - less) / (found[-2] - less)) /
              math.log10(speeds[-1] / speeds[-2]) for less in (0, TOUGHNESS)]
    return "\n\n".join([image, table(
        ["speed [mm/min]", "Forte et al.", "law of the scene [J/m²]", "computed"], rows),
        f"The slope between the two largest speeds is {slopes[0]:.3f}, and that of what "
        f"exceeds 1.1 J/m² {slopes[1]:.3f}; 1/2 is published.", missing(
            "The diameters of the wires, the stress that their slope gives, the "
            "modulus of that gelatin, and the measured points, of which the abstract has "
            "none. Here E = 24 kPa is another author's, σ_y = 2 kPa and a friction of 0.1 "
            "are assumed; a law with a corner is none that the program has.")])


# Of prm/studies/gel.prm [kPa], and the part of its shear modulus that does not relax.
GEL, GEL_RATIO, LASTING = 20, .4, .4


def gel_force(**settings):
    """The mean force [mN] of the wedge in prm/studies/gel.prm without friction."""
    with tempfile.TemporaryDirectory() as directory:
        program.run(OPTIONS, ROOT / "prm/studies/gel.prm", directory, [
            "Blade/Friction=0", "Output/Checkpoint=none",
            *(f"{name}={value}" for name, value in settings.items())])
        return json.loads((pathlib.Path(directory) / "summary.json").read_text())["mean_force"]


def relaxed():
    """The gel when its shear has relaxed: an elastic material."""
    shear = LASTING * GEL / (2 * (1 + GEL_RATIO))
    bulk = GEL / (3 * (1 - 2 * GEL_RATIO))
    return material(9 * bulk * shear / (3 * bulk + shear),
                    (3 * bulk - 2 * shear) / (2 * (3 * bulk + shear)))


def viscous():
    """A wedge through a viscous gel (`prm/studies/gel.prm` without friction, six tenths of
    whose shear modulus relax within 1 s) whose toughness does not depend on speed: the
    force has a maximum where the gel relaxes while the front goes from row to row, and is
    that of an elastic gel at both ends. Many gels were measured to need more force the
    faster they are cut; this tells what viscosity of the whole body, without any of the
    front's, adds. Test: `scenes/viscous_otherwise`."""
    speeds = [10 ** (i / 2) for i in range(-4, 5)]
    found = [gel_force(**{"Material/Viscous": f"{1 - LASTING} : 1", "Blade/Speed": v})
             for v in speeds]
    ends = {"elastic, as at once": gel_force(), "elastic, relaxed": gel_force(**relaxed())}
    image = picture("viscous", "Wedge in a viscous gel", [
        (name, speeds, [force] * len(speeds)) for name, force in ends.items()],
        [("computed", speeds, found)], xscale="log", xlabel="speed [mm/s]",
        ylabel="mean force of 1 mm [mN]")
    return "\n\n".join([image, table(
        ["speed [mm/s]", "mean force [mN]"],
        [*([name, f"{force:.2f}"] for name, force in ends.items()),
         *([f"{v:.3g}", f"{f:.2f}"] for v, f in zip(speeds, found))]),
        "Toughness times width is 10 mN.",
        missing("A gel with a measured series of relaxation times and cutting forces at "
                "several speeds was not found. In the slow and middle runs strains exceed "
                "0.5: small strain is used beyond its range there.")])


def slicing():
    """A thin blade that moves ξ along its edge for each length that it is pushed (Atkins, Xu
    and Jeronimidis 2004): F_V = R w/(1 + ξ²), F_H = ξ F_V, without friction. Test:
    `verification/blade`."""
    ratios = (0, .25, .5, 1, 1.5, 2, 3, 4)
    fine = [i / 20 for i in range(81)]
    runs = [blade.sliced(OPTIONS, x)[1:] for x in ratios]
    push = [f / blade.SLICING_TOUGHNESS for f, _ in runs]
    along = [p * float(end["force_along"] or 0) / float(end["blade_force"])
             for p, (_, end) in zip(push, runs)]
    image = picture("slicing", "Slicing and pushing, no friction", [
        ("Atkins et al., push", fine, [1 / (1 + x * x) for x in fine]),
        ("Atkins et al., along the edge", fine, [x / (1 + x * x) for x in fine])],
        [("computed, push", ratios, push), ("computed, along the edge", ratios, along)],
        xlabel="slice-push ratio ξ", ylabel="force / (R w)")
    rows = [[f"{x:g}", f"{1 / (1 + x * x):.4f}", f"{p:.4f}", f"{x / (1 + x * x):.4f}",
             f"{a:.4f}"] for x, p, a in zip(ratios, push, along)]
    return "\n\n".join([image, table(["ξ", "F_V/(R w)", "computed", "F_H/(R w)", "computed"],
                                     rows),
                        "What exceeds the closed form is stored in the body.",
                        missing("Atkins' toughnesses of cheddar and salami and his points are "
                                "not in the readable part of the paper.")])


def shear_plane(rake, friction, toughness):
    """Model of orthogonal cutting with one shear plane: the least cutting force over b τ h,
    with the toughness over τ h, and angles in degrees."""
    a, b = math.radians(rake), math.radians(friction)

    def force(phi):
        rest = 1 - math.sin(b) * math.sin(phi) / (math.cos(b - a) * math.cos(phi - a))
        gamma = 1 / math.tan(phi) + math.tan(phi - a)
        return (gamma + toughness) / rest if rest > 0 else math.inf
    return min(force(math.radians(i / 100)) for i in range(500, 8900))


def orthogonal():
    """Orthogonal cutting: the shear plane model (Atkins, Williams), F_c/(b τ h) over
    Z = R/(τ h), at a rake of 20°, for friction angles of 0 and 30°. An off-cut that does not
    flow (Z without limit) leaves F_c = b R however it bends: that is computed, for a layer of
    1 and of 2 mm of an elastic block of 8 mm, by a wedge without friction. Test:
    `verification/blade`."""
    rows = [[z, *(f"{shear_plane(20, friction, z):.4f}" for friction in (0, 30))]
            for z in (0, .1, 1, 5)]
    found = [[layer, 1, f"{blade.off_cut(OPTIONS, layer):.4f}"] for layer in (1, 2)]
    return "\n\n".join([
        table(["Z", "F_c/(b τ h), no friction", "friction angle 30°"], rows),
        table(["layer [mm]", "F_c/(b R), closed form", "computed"], found), missing(
            "The rows of the first table need a chip that flows as it leaves: plastic flow "
            "with large strain along a cut that goes on steadily for many thicknesses of the "
            "chip, with contact on the rake face of what the cut has freed. The program has "
            "the parts, on elements that flow does not fold; a run that comes to a steady "
            "chip was not made. Published forces and chips of a material with its yield "
            "stress, toughness and friction are not at hand.")])
