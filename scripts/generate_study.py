#!/usr/bin/env python3
"""Runs the classic comparison and writes docs/study.md with its charts and pictures.

generate_study.py BUILD              runs `aktina study --paper` of that build
generate_study.py BUILD --from DIR   takes the report that is there
"""
import html
import json
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent
pictures = root / "docs/pictures/study"
SHEETS = ("strip", "teapot")  # scenes with a sheet of all pictures: one is more than a megabyte

INTRODUCTION = """# Which shading method is good enough?

This page is written by `scripts/generate_study.py` from `aktina study --paper`: the classic comparison on Aktina's own
scenes, a sphere, a torus, a strip bent like an S and Newell's teapot, each coarse, shiny, and before two lamps. The same
report of a scene of your own, as a page with sorted tables, a slider and maps of the differences:

    aktina study scene.glb -o report/

`--family` chooses whose methods are compared: `shading`, `illumination`, `normals`, `integrator`, `radiosity`, `formfactor`,
`mesher`, `specular`. `--methods` takes a few of them, with parameters; `--reference` says what they are held against.

## What the numbers mean

All pictures are exposed alike, so that 1 is white. The reference is per-pixel Phong with 16 samples a pixel, and so are the
pictures that are compared: what differs is the method, not the smoothing of outlines. Where light is traced the reference
is a path traced picture with sixteen times the samples. Phong on a coarse mesh is not the true surface: methods that
follow the surface better than Phong's normals do (`lee_jen`, `overveld_wyvill` on the strip) differ from it, and count as
wrong here. `--reference lee_jen` turns that round.

| number | |
|---|---|
| RMSE, largest | of the linear values, not clipped |
| PSNR, FLIP | of what a screen shows |
| in highlights | RMSE where lamps add more than 5 % of white to a matt picture of the scene |
| edge jump | step of the luminance where two triangles of a smooth surface meet, from parabolas through three pixels on each side; root of the mean square |
| Mach band | the same of the first derivative, per pixel |
| flicker | how much the error changes from frame to frame while the camera turns by half a degree: root of the mean square over three steps |
| frame | the least time of several, methods taken in turn, one sample a pixel; on one thread, and on all |
| set-up, pixels | its two halves: vertices and triangles; coverage, depth and shading of pixels |
| evaluations | of the illumination model, counted while the engine draws: vertices are shared, SIMD lanes without a pixel count too |
| operations | of the published form, a pixel of three channels: forward differences of the method's polynomials, one interpolation in perspective where the method asks for it; what a method on scanlines does for each lamp. Inside an evaluation only powers are counted |
| growth | slopes of log-log lines over finer meshes and larger pictures |

Times are of one machine at one moment and the smallest ones are noisy; their ratios are what to look at. Everything else
is the same on every machine. The times below were taken beside other work on two cores: a method can be disturbed in
every round, and a time that falls out of its family's line (tens of milliseconds) is such a case. Instructions are counted where the machine lets a program do so.

## Form factors, solvers and meshers

`--family formfactor`, `radiosity` and `mesher` draw no pictures: each method is run at several settings, from coarse to
fine, on one thread, until a run takes too long, and its error is held against an exact or converged answer.

| family | what runs | held against |
|---|---|---|
| `formfactor` | 24 rows of the scene's polygons (1,000 at most), each parameter of the method in steps | `hybrid` to 1e-6; root mean square and largest error of a factor |
| `radiosity` | solves from `draft` at tolerance 0.3 to `normal` at 0.001 | path traced illuminance at places all over the surfaces, and near contacts apart; the converged matrix solution |
| `mesher` | patches of five sizes, solved by the matrix | path traced illuminance |

The report shows error against time (of meshers, against patches) with every method's best settings joined by a line, and
judges each method's claim at equal time or size. A place's own noise limits what can be seen; the report says how much.

## The files

`report.html` is one page that needs nothing else. `report.json` (`schema_version` 1) has `columns`, each number's group, name,
unit and meaning, and `studies`: of each its scene, settings, provenance and `methods`, with `quality`, `cost`, `operations`,
`growth`, `energy` (of illumination models), `runs` (of the families above), `claims`, `pareto`, and `failure` where a method cannot draw the scene. What is
not known is null; an infinite PSNR too. `report.csv` has the same numbers, a line a method. Times are in ms, of one thread
(`frame_1`, `setup_1`, `pixels_1`) and of all (`frame_all`).

Edge measures need six pixels across an edge, three in each triangle: on fine meshes few or none qualify, and the number
is missing.
"""


def short(value):
    if value is None:
        return "–"
    return "0" if value == 0 else f"{value:.0f}" if abs(value) >= 1000 else f"{value:.3g}"


def table(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows] + [""]


def quality(study):
    names = ["rmse", "flip", "highlight_rmse", "edge_jump", "mach_band", "flicker"]
    heads = ["method", "RMSE", "FLIP", "in highlights", "edge jump", "Mach band", "flicker"]
    rows = [[mark(m), *(short(m["quality"][n]) for n in names)] for m in drawn(study)]
    reference = ["*reference*", "", "", "", short(study["reference_edge_jump"]), short(study["reference_mach_band"]), ""]
    return table(heads, rows + [reference])


def cost(study):
    names = ["frame_1", "setup_1", "pixels_1", "frame_all", "ns_per_triangle", "ns_per_pixel"]
    heads = ["method", "frame, ms", "set-up", "pixels", "all threads", "ns a triangle", "ns a pixel",
             "evaluations a triangle", "a pixel"]
    rows = [[mark(m), *(short(m["cost"][n]) for n in names),
             short(m["operations"]["evaluations_per_triangle"]), short(m["operations"]["evaluations_per_pixel"])]
            for m in drawn(study)]
    return table(heads, rows)


def operations(study):
    names = ["additions", "multiplications", "divisions", "square_roots", "powers", "evaluations"]
    heads = ["method", "+", "×", "÷", "√", "pow", "evaluations"]
    rows = [[mark(m), *(short(m["operations"][n]) for n in names)] for m in drawn(study)]
    return table(heads, rows)


def growth(study):
    names = ["time_over_triangles", "error_over_triangles", "time_over_pixels"]
    heads = ["method", "time over triangles", "RMSE over triangles", "time over pixels"]
    return table(heads, [[mark(m), *(short(m["growth"][n]) for n in names)] for m in drawn(study)])


def claims(studies):
    """One row a claim, with its verdict on each scene."""
    words = {"holds": "yes", "fails": "**no**", "unknown": "–"}
    rows = {}
    for study in studies:
        for m in drawn(study):
            for c in m["claims"]:
                row = rows.setdefault((m["method"], c["claim"], c["cite"]), [])
                row.append(words[c["verdict"]])
                last = c["measured"]
                rows[(m["method"], c["claim"], c["cite"])] = row
                measured[(m["method"], c["claim"])] = last
    heads = ["method", "claim", *(s["scene"] for s in studies), f"measured on the {studies[-1]['scene']}"]
    return table(heads, [[method, f"{claim} [{cite}]", *row, measured[(method, claim)]]
                         for (method, claim, cite), row in rows.items()])


measured = {}


def drawn(study):
    return [m for m in study["methods"] if m["failure"] is None]


def mark(m):
    return f"**{m['method']}**" if m["pareto"] else m["method"]


def figures(section):
    """[(name, {kind: data URI}, caption)] of a section of the page."""
    found = []
    for name, body in re.findall(r"<figure data-name='([^']*)'>(.*?)</figure>", section, re.S):
        images = dict((kind, uri) for kind, uri in re.findall(r"class='(\w+)' alt='[^']*' src='([^']*)'", body))
        found.append((html.unescape(name), images))
    return found


def contact_sheet(section, width, height):
    """An SVG of all pictures with their names, the difference from the reference below each."""
    columns, wide = 5, 220
    high = wide * height // width
    cells = []
    for i, (name, images) in enumerate(figures(section)):
        x, y = i % columns * (wide + 8), i // columns * (2 * high + 34)
        cells.append(f'<text x="{x}" y="{y + 16}">{html.escape(name)}</text>')
        for k, kind in enumerate(("picture", "difference")):
            if kind in images:
                cells.append(f'<image x="{x}" y="{y + 22 + k * high}" width="{wide}" height="{high}" href="{images[kind]}"/>')
    rows = -(-len(figures(section)) // columns)
    size = (columns * (wide + 8), rows * (2 * high + 34))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {size[0]} {size[1]}" font-family="sans-serif" '
            f'font-size="14"><rect width="100%" height="100%" fill="#fcfcfb"/>{"".join(cells)}</svg>\n')


CHART_STYLE = """<style>text{font:12px sans-serif;fill:#5d5c58}.grid{stroke:#deddd8}.axis{stroke:#5d5c58}.lead{stroke:#deddd8}
g text{paint-order:stroke;stroke:#fcfcfb;stroke-width:3px}.front{fill:none;stroke:#2a62b8;stroke-width:2}circle{stroke:#fcfcfb;stroke-width:2;fill:#8d8b84}.best circle{fill:#2a62b8}
.best text{fill:#1b1b1a;font-weight:600}</style><rect width="100%" height="100%" fill="#fcfcfb"/>"""


def chart(section):
    svg = re.search(r"<svg viewBox.*?</svg>", section, re.S).group(0)
    head, body = svg.split(">", 1)
    return head.replace("<svg", "<svg xmlns='http://www.w3.org/2000/svg'") + ">" + CHART_STYLE + body + "\n"


def study_section(study, section):
    name = study["scene"]
    pictures.mkdir(parents=True, exist_ok=True)
    if name in SHEETS:
        (pictures / f"{name}.svg").write_text(contact_sheet(section, study["width"], study["height"]))
    (pictures / f"{name}_chart.svg").write_text(chart(section))
    lines = [f"## {name.capitalize()}", "",
             f"{study['triangles']} triangles, {study['width']} × {study['height']} pixels of which "
             f"{study['covered_pixels']} are covered. Methods in bold are on the Pareto front.", "",
             f"![Error against time](pictures/study/{name}_chart.svg)", ""]
    if name in SHEETS:
        lines += [f"![Pictures of all methods, and their differences from the reference](pictures/study/{name}.svg)", ""]
    return lines + quality(study) + cost(study) + growth(study)


def main():
    build = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(sys.argv[3]) if "--from" in sys.argv else pathlib.Path(scratch) / "report"
        if "--from" not in sys.argv:
            subprocess.run([build / "aktina", "study", "--paper", "-o", folder, "--quiet"], check=True)
        report = json.loads((folder / "report.json").read_text())
        sections = (folder / "report.html").read_text().split("<section")[1:]
    studies = report["studies"]
    lines = [INTRODUCTION, "## What the literature claims", "",
             "Whether each claim holds on each scene, on this machine with SIMD. The measured ratios are those of the last "
             "scene; the reports have them all.", ""] + claims(studies)
    lines += ["## Operations", "", "The same for every scene.", ""] + operations(studies[0])
    for study, section in zip(studies, sections):
        lines += study_section(study, section)
    lines += ["## In plain words", ""]
    for study in studies:
        lines += [f"{study['scene'].capitalize()}:", ""] + [f"- {remark}" for remark in study["remarks"]] + [""]
    (root / "docs/study.md").write_text("\n".join(lines).rstrip() + "\n")
    print("wrote docs/study.md and its pictures")


if __name__ == "__main__":
    main()
