#!/usr/bin/env python3
"""Runs the benchmark programs, prints one table, writes BUILD/bench.json: a list of {id, what, value, unit, goal, met}.

bench.py BUILD [NAME...]   all of BUILD/bench/bench_*, or those named
"""
import json
import os
import pathlib
import subprocess
import sys


def rows_of(program):
    """Rows that a program prints, one JSON object a line; its other words go to stderr as they are."""
    finished = subprocess.run([str(program)], stdout=subprocess.PIPE, text=True)
    if finished.returncode != 0:
        sys.exit(f"bench: {program.name} failed with exit code {finished.returncode}")
    return [json.loads(line) for line in finished.stdout.splitlines()]


def print_table(rows):
    names = max(len(row["id"]) for row in rows)
    for row in rows:
        goal = "" if row["goal"] is None else f"goal {row['goal']:<6g} {'met' if row['met'] else 'MISSED'}"
        value = f"{row['value']:.4g} {row['unit']}"
        print(f"{row['id']:<{names}}  {value:>14}  {goal:<19}  {row['what']}", flush=True)


def main():
    build = pathlib.Path(sys.argv[1])
    names = sys.argv[2:]
    programs = sorted(p for p in (build / "bench").glob("bench_*") if os.access(p, os.X_OK) and p.is_file())
    if names:
        programs = [p for p in programs if p.name.removeprefix("bench_") in names]
    rows = []
    for program in programs:
        print(f"bench: {program.name}", file=sys.stderr, flush=True)
        rows += rows_of(program)
    if not rows:
        sys.exit("bench: no benchmark program is built: make")
    print_table(rows)
    (build / "bench.json").write_text(json.dumps(rows, indent=1) + "\n")
    missed = sum(not row["met"] for row in rows)
    print(f"bench: {len(rows)} rows, {missed} goals missed; {build / 'bench.json'}")


if __name__ == "__main__":
    main()
