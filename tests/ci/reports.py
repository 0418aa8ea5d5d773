"""Reports with hostile texts, and the texts that a reader has to find in them."""
import json
import pathlib
import re
import subprocess

ANSI = re.compile("\x1b\\[[0-?]*[ -/]*[@-~]|\x1b\\].*?(?:\x07|\x1b\\\\)", re.S)
NOT_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")

GRAPH = """{ "wrinkle": 1,
  "nodes": {
    "a [x](y) \u00e4": { "type": "resolv" },
    "b": { "type": "gradient_scale", "in": { "amout": 1, "gradient": { "from": "q.x" } } } },
  "outputs": { "normal": { "from": "b.gradient" } } }
"""


def written(program, build, name):
    """Returns a folder with the files that write_reports makes."""
    folder = pathlib.Path(build) / name
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run([program, folder], check=True, cwd=folder)
    return folder


def in_xml(text):
    """Returns a text as JUnit has to hold it."""
    return NOT_XML.sub("\ufffd", ANSI.sub("", text))


def checks(folder):
    """Returns the checks as testcases: class, name, outcome and message."""
    results = json.loads((folder / "results.json").read_text())
    outcomes = {"passed": "passed", "failed": "failure", "error": "error", "new": "skipped",
                "deleted": "failure"}
    return [(in_xml(check["test"].replace("/", ".")), in_xml(check["name"]),
             outcomes[check["status"]], in_xml(check.get("message", "")))
            for check in results["checks"]]


def sarif(wrinkle, folder):
    """Writes w.sarif, of a graph with a name that needs escapes; returns its path."""
    (folder / "bad #1 \u00e4.json").write_text(GRAPH)
    path = folder / "w.sarif"
    with path.open("wb") as file:
        ran = subprocess.run([wrinkle, "check", "bad #1 \u00e4.json", "--set", "b.amount=x=y",
                              "--diagnostics", "sarif"], cwd=folder, stderr=file)
    assert ran.returncode == 1, ran
    return path
