"""Writes the table of proof in docs/hosts.md from the rows of the tests of hosts, and the values
that recorded_test.py compares, recorded/NAME.json.

    tests/hosts/proof/table.py build/release DATE
"""
import json
import pathlib
import shutil
import sys

BEGIN, END = "<!-- proof: tests/hosts/proof/table.py -->\n", "<!-- end of proof -->\n"
MEASURES = ["median", "p90", "p99", "max"]


def number(value):
    return f"{value:.4f}" if value < 0.1 else f"{value:.2f}" if value < 10 else f"{value:.0f}"


def worst(rows):
    """The largest of each measure over the graphs, by host, object and unit."""
    merged = {}
    for row in rows:
        key = (row["host"], row["object"], row["unit"])
        found = merged.setdefault(key, {name: 0 for name in MEASURES} | {"fault": ""})
        found["fault"] = row.get("fault", "")
        for name in MEASURES:
            found[name] = max(found[name], row[name])
    return merged


def main():
    build, date = pathlib.Path(sys.argv[1]), sys.argv[2]
    rows = []
    recorded = pathlib.Path(__file__).parents[1] / "recorded"
    recorded.mkdir(exist_ok=True)
    for report in sorted(build.glob("reports/hosts_*")):
        name = report.name.removeprefix("hosts_")
        rows += json.loads((build / f"{name}.json").read_text())
        shutil.copy(build / f"{name}_recorded.json", recorded / f"{name}.json")
    text = f"Measured {date}; each number is the largest of six graphs.\n\n"
    text += "| host | object | unit | median | p90 | p99 | largest | fault |\n"
    text += "|---|---|---|---|---|---|---|---|\n"
    for (host, name, unit), found in worst(rows).items():
        numbers = " | ".join(number(found[measure]) for measure in MEASURES)
        text += f"| {host} | {name} | {unit} | {numbers} | {found['fault']} |\n"
    page = pathlib.Path(__file__).parents[3] / "docs/hosts.md"
    old = page.read_text()
    begin, end = old.index(BEGIN) + len(BEGIN), old.index(END)
    page.write_text(old[:begin] + text + old[end:])


main()
