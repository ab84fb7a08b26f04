#!/usr/bin/env python3
"""Holds the catalogue, the files, the sources, the tests and the documentation together.

check_catalogue.py BUILD fails unless, for each family of `aktina methods --json`,
 - the files of its folder that define a row are the rows of its table, and a row's id is its file's stem;
 - its source is in docs/references.bib;
 - a test under tests/ at the same place names it;
 - its picture is in docs/pictures/ (but for accelerators, which all give the same one);
 - a benchmark names it, or runs its family's whole table;
 - docs/methods/ is what scripts/generate_docs.py writes.
"""
import json
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent


def camel(identifier):
    return "".join(part.capitalize() for part in identifier.split("_"))


def table_of(family):
    """Name of the function that gives a family's table."""
    return {"illumination": "illumination_models", "shading": "shading_methods", "normals": "normals",
            "radiosity": "solvers",
            "specular": "specular_methods"}.get(family["id"], family["id"] + "s")


def check_family(family, keys):
    folder = root / "src/aktina" / family["folder"]
    row = re.compile(rf"\bextern constinit const \w+(?:<[^;=]*>)?\s+(\w+)_{family['id']}\s*=")
    in_files = {path.stem: row.findall(path.read_text()) for path in folder.glob("*.cpp")}
    in_files = {stem: names for stem, names in in_files.items() if names}
    for stem, names in in_files.items():
        if names != [stem]:
            yield f"{folder.name}/{stem}.cpp defines {names}: one row, called as the file is"
    in_table = {method["id"] for method in family["methods"]}
    for stem in in_files.keys() - in_table:
        yield f"{family['folder']}/{stem}.cpp is not in the family's table"
    for identifier in in_table - in_files.keys():
        yield f"{family['folder']}/{identifier}.cpp does not define {identifier}_{family['id']}"

    benchmarks = " ".join(path.read_text() for path in (root / "bench").glob("*.cpp"))
    tests = " ".join(path.read_text() for path in (root / "tests" / family["folder"]).glob("**/*.cpp"))
    for method in family["methods"]:
        name = f"{family['id']}/{method['id']}"
        if method["cite"] not in keys:
            yield f"{name}: its source '{method['cite']}' is not in docs/references.bib"
        if not re.search(rf"\b{method['id']}\b|\b{camel(method['id'])}|\b{method['id']}_{family['id']}\b", tests):
            yield f"{name}: no test below tests/{family['folder']}/ names it"
        if family["id"] != "accelerator" and not (root / f"docs/pictures/{name}.png").exists():
            yield f"{name}: no picture docs/pictures/{name}.png (make docs)"
        if not re.search(rf"\b{method['id']}\b|\b{table_of(family)}\(\)", benchmarks):
            yield f"{name}: no benchmark in bench/ names it"


def main():
    build = sys.argv[1]
    program = str(pathlib.Path(build) / "aktina")
    catalogue = json.loads(subprocess.run([program, "methods", "--json"], capture_output=True, check=True).stdout)
    keys = set(re.findall(r"^@\w+\{([^,]+),", (root / "docs/references.bib").read_text(), re.M))
    faults = [fault for family in catalogue["families"] for fault in check_family(family, keys)]
    for fault in faults:
        print(fault)
    stale = subprocess.run([sys.executable, str(root / "scripts/generate_docs.py"), build, "--check"]).returncode
    count = sum(len(family["methods"]) for family in catalogue["families"])
    print(f"catalogue: {len(catalogue['families'])} families, {count} methods, {len(faults)} faults")
    return 1 if faults or stale else 0


if __name__ == "__main__":
    sys.exit(main())
