#!/usr/bin/env python3
"""Writes docs/methods/ from the catalogue (`aktina methods --json`) and docs/references.bib.

generate_docs.py BUILD           writes the pages
generate_docs.py BUILD --check   fails where a page is not what would be written
"""
import json
import pathlib
import re
import subprocess
import sys

root = pathlib.Path(__file__).resolve().parent.parent


def read_references():
    """{key: "P. Author, Title, Venue, year"} of docs/references.bib."""
    references = {}
    text = (root / "docs/references.bib").read_text()
    for entry in re.split(r"\n@", text)[1:]:
        key = re.match(r"\w+\{([^,]+),", entry).group(1)
        fields = dict(re.findall(r"(\w+)\s*=\s*\{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}", entry))
        fields = {name: plain(value) for name, value in fields.items()}
        venue = next((fields[name] for name in ("journal", "booktitle", "publisher", "howpublished", "address") if name in fields), "")
        authors = fields.get("author", fields.get("editor", "")).replace(" and ", ", ")
        parts = [authors, f"*{fields['title']}*", venue, fields["year"]]
        references[key] = ", ".join(part for part in parts if part)
    return references


def plain(bibtex):
    """Accents and braces of BibTeX as plain text."""
    accents = {'"': "\u0308", "'": "\u0301", "`": "\u0300", "~": "\u0303", "^": "\u0302"}
    import unicodedata

    text = bibtex.replace(r"{\AA}", "Å").replace(r"{\o}", "ø")
    text = re.sub(r"\{\\([\"'`~^])\{?(\w)\}?\}", lambda m: unicodedata.normalize("NFC", m[2] + accents[m[1]]), text)
    return text.replace("{", "").replace("}", "").replace("--", "–")


def number(value):
    return f"{value:.10g}"


def method_section(family, method, references):
    lines = [f"## `{method['id']}`: {method['title']}", "", method["summary"], ""]
    picture = f"pictures/{family['id']}/{method['id']}.png"
    if (root / "docs" / picture).exists():
        lines += [f"![{method['title']}](../{picture})", ""]
    if method["parameters"]:
        lines += ["| parameter | meaning | unit | default | accepted |", "|---|---|---|---|---|"]
        for p in method["parameters"]:
            accepted = f"{number(p['minimum'])} .. {number(p['maximum'])}{', whole' if p['whole'] else ''}"
            lines.append(f"| `{p['id']}` | {p['help']} | {p['unit']} | {number(p['default'])} | {accepted} |")
        lines.append("")
    source = f"src/aktina/{family['folder']}/{method['id']}.cpp"
    lines += [f"Source: {references[method['cite']]}. Code: [`{source}`](../../{source}).", ""]
    return lines


def family_page(family, references):
    lines = [f"# {family['title']}", "", family["summary"], "", "| method | |", "|---|---|"]
    lines += [f"| [`{m['id']}`](#{m['id']}-{anchor(m['title'])}) | {m['title']} |" for m in family["methods"]]
    lines.append("")
    for method in family["methods"]:
        lines += method_section(family, method, references)
    return "\n".join(lines[:-1]) + "\n"


def anchor(title):
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def index_page(families):
    lines = ["# Methods", "", "Generated from the catalogue that the program itself reads: `aktina methods`.", ""]
    for family in families:
        names = ", ".join(f"`{m['id']}`" for m in family["methods"])
        lines.append(f"- [{family['title']}]({family['id']}.md): {names}")
    return "\n".join(lines) + "\n"


def pages(program):
    catalogue = json.loads(subprocess.run([program, "methods", "--json"], capture_output=True, check=True).stdout)
    references = read_references()
    result = {"README.md": index_page(catalogue["families"])}
    for family in catalogue["families"]:
        result[f"{family['id']}.md"] = family_page(family, references)
    return result


def main():
    folder = root / "docs/methods"
    wanted = pages(str(pathlib.Path(sys.argv[1]) / "aktina"))
    if "--check" in sys.argv:
        stale = [name for name, text in wanted.items() if not (folder / name).exists() or (folder / name).read_text() != text]
        stale += [path.name for path in folder.glob("*.md") if path.name not in wanted]
        for name in stale:
            print(f"docs/methods/{name} is out of date: make docs")
        return 1 if stale else 0
    folder.mkdir(exist_ok=True)
    for path in folder.glob("*.md"):
        if path.name not in wanted:
            path.unlink()
    for name, text in wanted.items():
        (folder / name).write_text(text)
    print(f"wrote {len(wanted)} pages to docs/methods/")
    return 0


if __name__ == "__main__":
    sys.exit(main())
