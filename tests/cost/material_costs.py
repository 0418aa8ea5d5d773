#!/usr/bin/env python3
"""What the materials of graphs/materials cost, as a markdown table.

usage: tests/cost/material_costs.py [--wrinkle PROGRAM] [--check FILE]

With --check it exits 1 when a material costs more than its row in the markdown table of FILE, or
has no row there.
"""
import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HEAD = ["material", "ALU", "loop bodies once", "divisions", "branches"]


def cells_of(entry):
    total, once = entry["cost"]["total"], entry["cost"]["loop_bodies_once"]
    return [f"`{pathlib.Path(entry['file']).stem}`", str(total["alu"]), str(once["alu"]),
            str(total["divisions"]), str(total["branches"])]


def line(cells):
    return "| " + " | ".join(cells) + " |"


def findings(rows, document):
    """What --check refuses, a sentence each."""
    known = [text.strip("| ").split(" | ") for text in document.splitlines()]
    before = {cells[0]: cells for cells in known if len(cells) == len(HEAD)}
    for cells in rows:
        row = before.get(cells[0])
        if row is None:
            yield f"{cells[0]}: the document has no such row"
        elif any(int(now) > int(then) for now, then in zip(cells[1:], row[1:])):
            yield f"{cells[0]}: costs more than in the document: {line(cells)}"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--wrinkle", default=str(ROOT / "build/release/bin/wrinkle"))
    parser.add_argument("--check", metavar="FILE", help="a document with the table as it was")
    options = parser.parse_args()
    graphs = [path for path in sorted((ROOT / "graphs/materials").glob("*.json"))
              if not path.name.endswith((".test.json", ".preset.json"))]
    done = subprocess.run([options.wrinkle, "compile", *graphs, "--cost", "--json"], check=True,
                          capture_output=True, text=True)
    rows = [cells_of(entry) for entry in json.loads(done.stdout)["graphs"]]
    print("\n".join([line(HEAD), "|---" * len(HEAD) + "|", *map(line, rows)]))
    if options.check:
        found = list(findings(rows, pathlib.Path(options.check).read_text()))
        print("\n".join(found), file=sys.stderr)
        sys.exit(1 if found or not rows else 0)


if __name__ == "__main__":
    main()
