#!/usr/bin/env python3
"""Fails where an #include goes against the table of docs/architecture.md, or a library is included out of its place."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parent.parent
text = (root / "docs/architecture.md").read_text()
rooms = []
uses = {}
for row in re.findall(r"^\| `(\w+)` \|[^|]*\|([^|]*)\|$", text, re.M):
    rooms.append(row[0])
    listed = [name.strip() for name in row[1].split(",") if name.strip()]
    uses[row[0]] = set(rooms[:-1]) if listed == ["all above"] else set(listed)

# Library headers and the places (prefixes of paths, or patterns) where they may be included.
libraries = {
    r"tbb/": [r"src/aktina/base/parallel\.cpp"],
    r"embree3/": [r"src/aktina/trace/accelerator/embree\.cpp", r"bench/"],
    r"hwy/": [r"src/aktina/\w+/.*_simd\.(cpp|h)", r"src/aktina/base/simd\.h"],
    r"(OpenEXR/|Imf|spng|turbojpeg|webp/)": [r"src/aktina/image/"],
    r"(draco/|meshoptimizer)": [r"src/aktina/import/"],
    r"assimp/": [r"src/aktina/import/assimp/\w+\.cpp"],
    r"nlohmann/": [r"src/aktina/(import|export|render)/", r"app/", r"tests/", r"python/"],
    r"CLI/": [r"app/"],
    r"hdf5": [r"src/aktina/export/hdf5_library\.h"],
    r"pybind11/": [r"python/"],
}

faults = []
for path in sorted([*root.glob("src/**/*.h"), *root.glob("src/**/*.cpp"), *root.glob("app/*"), *root.glob("python/*.cpp")]):
    if not path.is_file():
        continue
    name = path.relative_to(root).as_posix()
    room = name.split("/")[2] if name.startswith("src/aktina/") else None
    for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
        match = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
        if not match:
            continue
        header = match.group(1)
        if header.startswith("aktina/") and room:
            target = header.split("/")[1]
            if target != room and target in uses and target not in uses[room]:
                faults.append(f"{name}:{number}: {room} may not include {target}")
        for library, places in libraries.items():
            if re.match(library, header) and not any(re.match(place, name) for place in places):
                faults.append(f"{name}:{number}: {header} is included outside of {', '.join(places)}")
for fault in faults:
    print(fault)
print(f"layers: {len(rooms)} rooms, {len(faults)} faults")
sys.exit(1 if faults else 0)
