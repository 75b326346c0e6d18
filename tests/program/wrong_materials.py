# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values of materials that are not allowed: see wrong_values.py."""

# What deal.II says about its patterns.
PATTERN = ""
E = "Material/Young's modulus"
NU = "Material/Poisson's ratio"
LAW = "Material/Law"
FINITE = {"Deformation/Strain": "finite"}

WRONG_MATERIALS = [
    (NU, "0.5", "greater than -1 and less than 0.5"),
    (NU, "0.6", "greater than -1 and less than 0.5"),
    (NU, "-1", "greater than -1 and less than 0.5"),
    (NU, "-1.5", "greater than -1 and less than 0.5"),
    (NU, "nan", PATTERN),
    (NU, "0,2", PATTERN),
    (E, "0", "greater than 0"),
    (E, "-5", "greater than 0"),
    (E, "nan", PATTERN),
    (E, "inf", PATTERN),
    (E, "1e400", PATTERN),
    # Smaller than the smallest number of full precision.
    (E, "1e-320", PATTERN),
    (E, "", PATTERN),
    (E, "5.0 kPa", PATTERN),
    ("Deformation/Strain", "large", "finite"),
    (LAW, "rubber", "neo-Hooke"),
    (LAW, "neo-Hooke; top : Ogden", "groups of elements, and 'top' is none"),
    (LAW, "neo-Hooke; cream : Ogden", "and 'cream' is none of them"),
    (LAW, "Ogden", "Ogden with Material/Ogden terms", FINITE),
    (LAW, "neo-Hooke", "isochoric neo-Hooke", {**FINITE, NU: "0.49"}),
    (LAW, "linear elastic", "mixed formulation",
     {**FINITE, "Material/Formulation": "mixed"}),
    ("Material/Volumetric energy", "Hencky", "logarithmic"),
    ("Material/Mooney-Rivlin share", "1.5", "from 0 to 1"),
    ("Material/Mooney-Rivlin share", "nan", PATTERN),
    ("Material/Ogden terms", "1", "'modulus : exponent'"),
    ("Material/Ogden terms", "1 : 0", "not 0"),
    ("Material/Ogden terms", "1 : -2; 0.1 : 2", "positive sum"),
    ("Division/Solve", "condensed", "every row anew", FINITE),
    ("Division/Split rows", "wedged", "opened or free", FINITE),
    ("Accuracy/Estimate", "true", "false where", FINITE),
    ("Accuracy/Target", "0.01", "0 where", FINITE),
    ("Board/Plane", "0, 0, 0; 0, 0, 1", "nothing", FINITE),
    ("Output/CalculiX decks", "true", "isochoric neo-Hooke, Mooney-Rivlin", FINITE),
    ("Output/CalculiX decks", "true", "Volumetric energy = quadratic",
     {**FINITE, LAW: "Mooney-Rivlin"}),
    ("Output/CalculiX decks", "true", "up to four terms",
     {**FINITE, LAW: "Ogden", "Material/Volumetric energy": "quadratic",
      "Material/Ogden terms": "1 : 1; 1 : 2; 1 : 3; 1 : 4; 1 : 5"}),
    ("Output/CalculiX decks", "true", "the law neo-Hooke",
     {"Deformation/Strain": "auto"}),
    ("Load/Pressures", "top : 1", "a free rim",
     {**FINITE, "Yield/Criterion": "energy release"}),
    ("Material/Shear limit", "0", "greater than 0"),
    ("Material/Toughness", "0", "greater than 0"),
    ("Material/Toughness", "-1", "greater than 0"),
    ("Material/Formulation", "hybrid", "mixed"),
    ("Material/Shear limit", "-1", "greater than 0"),
    ("Material/Linear range", "0", "greater than 0"),
    ("Material/Linear range", "1", "less than 1", {"Deformation/Strain": "auto"}),
    ("Division/Split rows", "wedged", "Strain is auto", {"Deformation/Strain": "auto"}),
    (E, "5; cream : 0.5", "and 'cream' is none of them"),
    (E, "5; top : 0.5", "groups of elements, and 'top' is none"),
    (E, "top : 0.5", "groups of elements, and 'top' is none"),
    (E, "5; 6", "one number without a group"),
]
