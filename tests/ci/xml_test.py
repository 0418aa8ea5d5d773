"""Reads JUnit with Python's XML parser (expat), and SARIF as JSON."""
import json
import sys
import urllib.parse
import xml.etree.ElementTree

import reports


def check_junit(folder):
    root = xml.etree.ElementTree.parse(folder / "junit.xml").getroot()
    found = []
    for case in root.iter("testcase"):
        bad = [child for child in case if child.tag != "system-out"]
        assert len(bad) <= 1, case.attrib
        found.append((case.get("classname"), case.get("name"),
                      bad[0].tag if bad else "passed", bad[0].get("message") if bad else ""))
    assert found == reports.checks(folder), (found, reports.checks(folder))
    for element in [root, *root.iter("testsuite")]:
        cases = list(element.iter("testcase"))
        assert int(element.get("tests")) == len(cases)
        for kind, count in (("failure", "failures"), ("error", "errors"), ("skipped", "skipped")):
            assert int(element.get(count)) == sum(case.find(kind) is not None for case in cases)
    attached = [out.text for out in root.iter("system-out")]
    assert attached == ["[[ATTACHMENT|report/images/rings <&>.png]]"], attached
    return len(found)


def check_sarif(path):
    run, = json.loads(path.read_text())["runs"]
    rules = run["tool"]["driver"]["rules"]
    results = run["results"]
    assert results
    for result in results:
        assert rules[result["ruleIndex"]]["id"] == result["ruleId"]
        uri = result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
        assert urllib.parse.unquote(uri).endswith("bad #1 \u00e4.json"), uri
        assert "#" not in uri and " " not in uri, uri
    prints = [result["partialFingerprints"]["primaryLocationLineHash"] for result in results]
    assert len(set(prints)) == len(prints), prints
    said, = run["invocations"]
    assert not said["executionSuccessful"]
    assert said["toolExecutionNotifications"][0]["descriptor"]["id"] == "option"


def main():
    write_reports, wrinkle, build = sys.argv[1:]
    folder = reports.written(write_reports, build, "xml")
    print(check_junit(folder), "checks")
    check_sarif(reports.sarif(wrinkle, folder))


main()
