"""Reads JUnit with two readers, TAP with one, and validates SARIF by its schema and by GitHub's
rules, all from npm."""
import json
import os
import pathlib
import subprocess
import sys

import reports

PACKAGES = ["junit2json@4.0.0", "test-results-parser@0.4.6", "tap-parser@18.3.4", "ajv@8.20.0",
            "@microsoft/sarif-multitool@5.7.0"]

SCRIPT = """import fs from 'fs';
import {parse} from 'junit2json';
import results from 'test-results-parser';
import {Parser} from 'tap-parser';
import Ajv from 'ajv/dist/2020.js';
const schema = 'node_modules/@microsoft/sarif-multitool-linux/sarif-2.1.0.json';
const read = file => fs.readFileSync(file, 'utf8');
const is_sarif = new Ajv({strict: false, validateFormats: false}).compile(JSON.parse(read(schema)));
const ajv = file => is_sarif(JSON.parse(read(file))) ? null : is_sarif.errors;
console.log(JSON.stringify({
  junit2json: await parse(read('junit.xml')),
  parser: results.parseV2({type: 'junit', files: ['junit.xml']}).result,
  tap: Parser.parse(read('results.tap')),
  sarif: ajv('w.sarif'),
  seeded: ajv('seeded.sarif'),
}));
"""


def check_junit2json(read, checks):
    found = []
    for suite in read["testsuite"]:
        for case in suite["testcase"]:
            kind = next((k for k in ("failure", "error", "skipped") if k in case), "passed")
            found.append((case["classname"], case["name"], kind,
                          case[kind][0]["message"] if kind != "passed" else ""))
    assert found == checks, found
    assert read["tests"] == len(checks)


def check_results_parser(read, checks):
    """It leaves character references such as &#10; as they are, and does not count skipped ones."""
    words = {"passed": "PASS", "failure": "FAIL", "error": "FAIL", "skipped": "SKIP"}
    cases = [case for suite in read["suites"] for case in suite["cases"]]
    assert [case["status"] for case in cases] == [words[check[2]] for check in checks], cases
    assert [case["name"] for case in cases[:-1]] == [check[1] for check in checks[:-1]]
    paths = [attached["path"] for case in cases for attached in case["attachments"]]
    assert paths == ["report/images/rings <&>.png"], paths


def check_tap(events, checks):
    points = [event[1] for event in events if event[0] == "assert"]
    assert [point["ok"] for point in points] == \
        [check[2] in ("passed", "skipped") for check in checks], points
    assert [bool(point.get("skip")) for point in points] == \
        [check[2] == "skipped" for check in checks]
    assert points[1]["diag"]["file"] == "graphs/rings.test.json", points[1]
    assert points[1]["diag"]["message"].startswith("differs: <a href=\"x\">'&amp;' ]]>")
    end, = [event[1] for event in events if event[0] == "complete"]
    assert end["count"] == len(checks) and not end["failures"][0].get("tapError"), end
    assert not any(event[0] == "extra" for event in events), events


def check_by_multitool(folder):
    """GitHub's rules (Ghas) and those of SARIF itself, but for notes of style and SARIF2005: the
    project has no page to which informationUri could lead."""
    tool = folder / "node_modules/@microsoft/sarif-multitool-linux/Sarif.Multitool"
    tool.chmod(0o755)
    subprocess.run([tool, "validate", "w.sarif", "--rule-kind", "Sarif;Ghas", "--level",
                    "Error;Warning", "--kind", "Fail", "--output", "found.sarif", "--log",
                    "ForceOverwrite"], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                   env=os.environ | {"DOTNET_SYSTEM_GLOBALIZATION_INVARIANT": "1"})
    run, = json.loads((folder / "found.sarif").read_text(encoding="utf-8-sig"))["runs"]
    found = [each for each in run.get("results", []) if each["ruleId"] != "SARIF2005"]
    assert not found, found


def main():
    write_reports, wrinkle, build = sys.argv[1:]
    folder = reports.written(write_reports, build, "npm")
    subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--silent", *PACKAGES],
                   cwd=folder, check=True)
    sarif = reports.sarif(wrinkle, folder)
    (folder / "seeded.sarif").write_text(sarif.read_text().replace('"level"', '"levels"'))
    (folder / "read.mjs").write_text(SCRIPT)
    read = json.loads(subprocess.run(["node", "read.mjs"], cwd=folder, check=True,
                                     stdout=subprocess.PIPE, text=True).stdout)
    checks = reports.checks(folder)
    check_junit2json(read["junit2json"], checks)
    check_results_parser(read["parser"], checks)
    check_tap(read["tap"], checks)
    assert read["sarif"] is None, read["sarif"]
    assert read["seeded"], "the schema does not find the seeded error"
    check_by_multitool(pathlib.Path(folder))
    print(f"{len(checks)} checks")


main()
