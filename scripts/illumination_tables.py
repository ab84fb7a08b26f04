#!/usr/bin/env python3
"""Prints the tables of docs/illumination.md: what each illumination model does with light in all.

illumination_tables.py BUILD    white furnace and share of a lamp's light by angle, reciprocity; for one material
"""
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(sys.argv[1]).resolve() / "python"))
import aktina  # noqa: E402

# The same material throughout: all that is not diffuse is highlight, so that a model which keeps energy gives 1.
MATERIAL = {"ka": 0, "kd": 0.5, "ks": 0.5, "exponent": 20, "base_colour": [1] * 3, "metallic": 1, "roughness": 0.5}
ANGLES = [0, 30, 45, 60, 75, 85]


def table(title, function):
    print(f"\n{title}\n\n| model | " + " | ".join(f"{a}\N{DEGREE SIGN}" for a in ANGLES) + " |")
    print("|---|" + "---|" * len(ANGLES))
    for method in aktina.methods("illumination"):
        values = function(method["id"], MATERIAL, np.cos(np.radians(ANGLES)))[:, 0]
        print(f"| `{method['id']}` | " + " | ".join(f"{v:.3f}" for v in values) + " |")


def main():
    table("White furnace by the viewer's angle", aktina.albedo)
    table("Share of a lamp's light by its angle", aktina.reflected_share)
    print("\nReciprocity\n\n| model | error | a | b |\n|---|---|---|---|")
    for method in aktina.methods("illumination"):
        error, a, b = aktina.reciprocity(method["id"], MATERIAL)
        angle = [f"{np.degrees(np.arccos(min(v[2], 1))):.0f}\N{DEGREE SIGN}" for v in (a, b)]
        print(f"| `{method['id']}` | {error:.2g} | {angle[0]} | {angle[1]} |")


if __name__ == "__main__":
    main()
