# SPDX-License-Identifier: LGPL-2.1-or-later
"""What small strain leaves out, and what finite strain costs."""

import pathlib
import resource
import tempfile

import measure
import runs

SCENE = pathlib.Path(__file__).resolve().parent / "strain.prm"
FINITE = {"Deformation/Strain": "finite"}
LOADS = (.05, .25, .5, 1)
DEPTHS = (0, 5)
QUANTITIES = {"displacement": "max_displacement", "stress": "cutting_stress",
              "energy": "strain_energy"}
FINER = {"Body/Elements": "4, 8, 8", "Cut/Surfaces": "y:4"}
# On a finer mesh the line load has no stable state beyond a smaller limit.
HALF = {"Blade/Edge loads": "uniform : 30", "Blade/Thickness": "0.25"}
# The element type and the mesh, each with small and with finite strain.
MESHES = {"linear": {"Body/Element type": "linear"}, "serendipity": {},
          "quadratic": {"Body/Element type": "quadratic"},
          "linear, h/2": {"Body/Element type": "linear", **FINER},
          "serendipity, h/2": FINER}
LAWS = {"neo-Hooke": {}, "neo-Hooke, U quadratic": {"Material/Volumetric energy": "quadratic"},
        "neo-Hooke, U logarithmic": {"Material/Volumetric energy": "logarithmic"},
        "isochoric neo-Hooke": {"Material/Law": "isochoric neo-Hooke"},
        "Mooney-Rivlin": {"Material/Law": "Mooney-Rivlin"},
        "Ogden": {"Material/Law": "Ogden",
                  "Material/Ogden terms": "0.63 : 1.3; 0.0012 : 5; -0.01 : -2"},
        "linear elastic": {"Material/Law": "linear elastic"}}
WAYS = {"small, one factorization": {},
        "small, every row anew": {"Division/Solve": "every row anew"},
        "auto, Linear range = 0.3": {"Deformation/Strain": "auto",
                                     "Material/Linear range": .3},
        "finite": FINITE,
        "finite, node rows": {**FINITE, "Division/Release": "node row"}}


def processor_seconds():
    """Of all programs that have been run: other work does not matter to them."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(values):
    """Seconds, and what is asked for in the first row and in the middle of the cut; the
    reason, where there is no such state."""
    with tempfile.TemporaryDirectory() as directory:
        scene = pathlib.Path(directory) / "scene.prm"
        scene.write_text(runs.scene_text(SCENE.stem, values))
        begin = processor_seconds()
        result = measure.program(scene, {})
        seconds = processor_seconds() - begin
    states = {float(line["depth"]): {name: float(line[name]) for name in
                                     ("max_strain", *QUANTITIES.values())}
              for line in result.events if line["event"] == "deform"}
    return {"seconds": seconds, "states": [states.get(d) for d in DEPTHS]}


def measured(name, values):
    return measure.remembered(f"strain, {name}", lambda: run(values), runs.STORE)


def both(name, values):
    """With small strain, and with finite."""
    return (measured(f"{name}, small", values),
            measured(f"{name}, finite", {**values, **FINITE}))


def differences(state, reference):
    """Of all quantities, as text."""
    if state is None or reference is None:
        return ["no stable state"] + [""] * (len(QUANTITIES) - 1)
    return [f"{100 * (state[name] / reference[name] - 1):+.1f} %"
            for name in QUANTITIES.values()]


def load_rows():
    for part in LOADS:
        small, finite = both(f"{part} of the load", {
            "Blade/Edge loads": f"uniform : {60 * part}",
            "Blade/Thickness": repr(.5 * part)})
        for depth, one, other in zip(DEPTHS, small["states"], finite["states"]):
            yield [f"{part:g}", f"{depth}", f"{one['max_strain']:.2g}",
                   *differences(one, other)]


def mesh_rows():
    reference = measured("half, quadratic, h/2, finite",
                         {**MESHES["quadratic"], **FINER, **HALF, **FINITE})["states"][1]
    for name, values in MESHES.items():
        for strain, result in zip(("small", "finite"), both(f"half, {name}",
                                                              {**values, **HALF})):
            yield [name, strain, *differences(result["states"][1], reference),
                   f"{result['seconds']:.2g} s"]


def law_rows():
    reference = measured("law neo-Hooke", FINITE)["states"]
    for name, values in LAWS.items():
        states = measured(f"law {name}", {**FINITE, **values})["states"]
        yield [name, *differences(states[0], reference[0]),
               *differences(states[1], reference[1])]


def way_rows():
    results = {name: measured(f"half, way {name}, h/2",
                              {**FINER, **HALF, **values}) for name, values in WAYS.items()}
    reference = results["finite"]
    for name, result in results.items():
        yield [name, f"{result['seconds'] / reference['seconds']:.2g}",
               *differences(result["states"][1], reference["states"][1])]


def section():
    comment = " ".join(line[2:] for line in SCENE.read_text().splitlines()
                       if line.startswith("# "))
    names = list(QUANTITIES)
    load, mesh, law, way = (list(rows()) for rows in
                            (load_rows, mesh_rows, law_rows, way_rows))
    return "\n".join([
        "## strain", "", comment + " The load is that with which its front goes down by "
        "about a sixth of its height; stress is `mean shear` over 2.5 cm. Depth 5 is the "
        "middle of the cut.", "",
        "Small strain less finite strain, on the same mesh, where load and blade are parts "
        "of these:", "",
        measure.table(["load", "depth", "largest strain", *names], load), "",
        "Types of element and meshes in the middle of the cut, under half of the load, "
        "against quadratic elements of "
        "half the size with finite strain:", "",
        measure.table(["element", "strain", *names, "processor time"], mesh), "",
        "Laws of finite strain against neo-Hooke, all with the same moduli at rest:", "",
        measure.table(["law", *(f"{n}, depth {d}" for d in DEPTHS for n in names)], law), "",
        "Ways to the middle of the cut under half of the load, on elements of half the size. "
        "Where the same load is reached in other steps, the "
        "state is the same:", "",
        measure.table(["", "processor time of the whole cut", *names], way), ""])
