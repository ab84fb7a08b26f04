#!/usr/bin/python3
"""Holds Aktina to reference values: every case of every JSON file in a folder, by every method that computes its kind.

    tests/run_reference.py DIR [--family F] [--kind K] [--json] [--build BUILD] [--or-skip]

A value passes where |x - expected| <= abs + rel |expected|, element by element. Exit status: 0 all that is computed
passes, 1 something failed, 2 nothing to compare or a file that cannot be read; 77 the folder is absent, with --or-skip.
"""
import argparse
import json
import math
import pathlib
import sys

FAILED, NOTHING, SKIPPED = 1, 2, 77  # exit statuses
ROOT = pathlib.Path(__file__).resolve().parent.parent


def import_from(build):
    """Makes the module of the build folder and what computes cases importable."""
    sys.path[:0] = [str(build / "python"), str(ROOT / "tests" / "python")]
    try:
        import aktina  # noqa: F401
    except ImportError as error:
        give_up(f"{error}: build first, or name the build folder by --build")


def give_up(why):
    print(f"run_reference: {why}", file=sys.stderr)
    sys.exit(NOTHING)


def read_cases(folder):
    """All cases below `folder`, and notes about files that hold none."""
    from reference.cases import Case
    cases, notes = [], []
    for path in sorted(folder.rglob("*.json")):
        try:
            document = json.loads(path.read_text(encoding="utf-8"))
            listed = document["cases"] if isinstance(document, dict) else None
        except KeyError:
            listed = None
        except (OSError, ValueError) as error:
            give_up(f"{path}: {error}")
        if listed is None:
            notes.append(f"{path.name}: not a file of cases")
            continue
        header = {name: value for name, value in document.items() if name != "cases"}
        others = {case.get("id"): case for case in listed if isinstance(case, dict)}
        for case in listed:
            try:
                cases.append((header.get("family", path.stem), Case(
                    case["id"], case["kind"], case["inputs"], case["expected"], case["tolerance"],
                    case.get("tolerance_sampled"), header, others)))
            except (KeyError, TypeError) as error:
                give_up(f"{path}: not a case ({error}): {str(case)[:100]}")
    return cases, notes


class Result:
    """One method on the cases of one kind."""

    def __init__(self, accuracy):
        self.accuracy = accuracy
        self.passed = self.compared = 0
        self.failures = []
        self.worst = 0.0
        self.keys = set()

    def judge(self, case, method):
        from reference.cases import error_over_tolerance, tolerance_of
        try:
            values = method.compute(case)
        except Exception as error:  # a method that throws has failed the case, whatever it throws
            self.failures.append((case.id, f"{type(error).__name__}: {error}"))
            return
        tolerance = tolerance_of(case, method.accuracy)
        keys = sorted(set(values) & set(case.expected))
        errors = {key: error_over_tolerance(values[key], case.expected[key], tolerance) for key in keys}
        self.keys.update(keys)
        self.compared += len(keys)
        self.worst = max([self.worst, *errors.values()])
        bad = [f"{key} is {errors[key]:.3g} times the tolerance off" for key in keys if not errors[key] <= 1]
        if not keys:
            bad = [f"computed {sorted(values)}, none of which is expected"]
        if bad:
            self.failures.append((case.id, "; ".join(bad)))
        else:
            self.passed += 1


class Kind:
    """All cases of one kind."""

    def __init__(self, family, kind):
        self.family, self.kind = family, kind
        self.cases = 0
        self.expected = set()
        self.results = {}

    @property
    def not_computed(self):
        return sorted(self.expected - set().union(*(result.keys for result in self.results.values())))


def judge_all(cases):
    from reference import KINDS
    kinds = {}
    for family, case in cases:
        kind = kinds.setdefault((family, case.kind), Kind(family, case.kind))
        kind.cases += 1
        kind.expected.update(case.expected)
        for method in KINDS.get(case.kind, []):
            if method.resolves(case):
                kind.results.setdefault(method.id, Result(method.accuracy)).judge(case, method)
    return list(kinds.values())


def print_table(kinds):
    line = "{:<22} {:<25} {:<18} {:<9} {:>7} {:>7} {:>10}"
    print(line.format("family", "kind", "method", "held to", "passed", "failed", "worst"))
    for kind in kinds:
        for method, result in kind.results.items():
            print(line.format(kind.family, kind.kind, method, result.accuracy, result.passed, len(result.failures),
                              f"{result.worst:.2g}"))
        if not kind.results:
            print(line.format(kind.family, kind.kind, "(none yet)", "", "", "", ""))
    print("\n'worst' is the largest error over its tolerance: up to 1 passes.")
    for kind in kinds:
        if kind.results and kind.not_computed:
            print(f"not yet computed: {kind.kind}: {', '.join(kind.not_computed)}")
    for kind in kinds:
        for method, result in kind.results.items():
            for case, why in result.failures[:10]:
                print(f"FAILED {kind.kind} {case} by {method}: {why}")
            if len(result.failures) > 10:
                print(f"FAILED {kind.kind} by {method}: {len(result.failures) - 10} more")


def report(kinds, notes):
    return {
        "schema_version": 1,
        "kinds": [{
            "family": kind.family, "kind": kind.kind, "cases": kind.cases, "not_computed": kind.not_computed,
            "methods": [{
                "method": method, "held_to": result.accuracy, "passed": result.passed, "failed": len(result.failures),
                "values_compared": result.compared, "worst": result.worst if math.isfinite(result.worst) else None,
                "failures": [{"case": case, "why": why} for case, why in result.failures],
            } for method, result in kind.results.items()],
        } for kind in kinds],
        "notes": notes,
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path, help="of JSON files of reference values")
    parser.add_argument("--family", help="only this family")
    parser.add_argument("--kind", help="only this kind of case")
    parser.add_argument("--json", action="store_true", help="one JSON report on standard output")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build", help="build folder that holds the module")
    parser.add_argument("--or-skip", action="store_true", help="exit status 77 where the folder is absent")
    arguments = parser.parse_args()

    import_from(arguments.build)
    if not arguments.folder.is_dir():
        print(f"run_reference: {arguments.folder}: no such folder", file=sys.stderr)
        return SKIPPED if arguments.or_skip else NOTHING
    cases, notes = read_cases(arguments.folder)
    cases = [(family, case) for family, case in cases
             if arguments.family in (None, family) and arguments.kind in (None, case.kind)]
    if not cases:
        give_up(f"no such cases in {arguments.folder}")

    kinds = judge_all(cases)
    without = [kind for kind in kinds if not kind.results]
    notes += [f"{kind.kind}: {kind.cases} cases not yet computed by any method" for kind in without]
    if arguments.json:
        print(json.dumps(report(kinds, notes), indent=2))
    else:
        print_table(kinds)
        for note in notes:
            print(f"note: {note}")
        passed = sum(result.passed for kind in kinds for result in kind.results.values())
        failed = sum(len(result.failures) for kind in kinds for result in kind.results.values())
        print(f"{len(cases)} cases; {passed} passes, {failed} failures; "
              f"{sum(kind.cases for kind in without)} cases not yet computed by any method")
    failed = any(result.failures for kind in kinds for result in kind.results.values())
    nothing = not any(result.compared for kind in kinds for result in kind.results.values())
    if nothing and not failed:
        give_up("nothing was compared")
    return FAILED if failed else 0


if __name__ == "__main__":
    sys.exit(main())
