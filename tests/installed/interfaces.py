#!/usr/bin/env python3
"""The stable interfaces of docs/promises.md have everything that the last release had.

usage: interfaces.py SOURCE BUILD [--update]

tests/installed/interfaces.txt lists a line for each option of `wrinkle`, target, host, port of a
node, output, rule and function of the library. A line that the build lacks is an error; a port may
go if the version of its node is another. --update adds new lines, and is run for a release.
"""
import json
import os
import pathlib
import re
import subprocess
import sys


def printed(program, *arguments):
    return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout


def commands(wrinkle):
    for name in re.findall(r"^  ([a-z][a-z-]+) {2,}", printed(wrinkle, "--help"), re.MULTILINE):
        yield f"command {name}"
        for option in re.findall(r"--[a-z][a-z-]*", printed(wrinkle, name, "--help")):
            yield f"option {name} {option}"


def nodes(wrinkle):
    for node in json.loads(printed(wrinkle, "nodes", "--json"))["nodes"]:
        named = f"{node['id']} version {node['version']}"
        yield f"node {named}"
        for port in node["ports"]:
            yield f"port {named} {port['kind']} {port['name']} {port.get('type', '')}".rstrip()


def current(source, build):
    wrinkle = build / "bin/wrinkle"
    os.environ["WRINKLE_NO_DEFAULT_PLUGINS"] = "1"
    lines = {*commands(wrinkle), *nodes(wrinkle)}
    lines |= {f"target {each.split()[0]}"
              for each in printed(wrinkle, "compile", "--list-targets").splitlines()}
    lines |= {f"host {each.split()[0]}"
              for each in printed(wrinkle, "export", "--list").splitlines()}
    rules = (source / "docs/diagnostics.md").read_text().partition("## Rules")[2]
    lines |= {f"rule {each}" for each in re.findall(r"^\| `([a-z-]+)` \|", rules, re.MULTILINE)}
    outputs = (source / "docs/outputs.md").read_text()
    lines |= {f"output {each}" for each in re.findall(r"^\| `(\w+)` \|", outputs, re.MULTILINE)}
    shown = printed("nm", "-D", "-C", "--defined-only", build / "lib/libwrinkle.so")
    lines |= {f"function {each}" for each in re.findall(r" T (wrinkle_\w+)", shown)}
    return lines


def superseded(line, lines):
    """A node or port of a node that now has a higher version."""
    words = line.split()
    return words[0] in ("node", "port") and any(
        f"node {words[1]} version {version}" in lines
        for version in range(int(words[3]) + 1, int(words[3]) + 100))


def main():
    source, build = (pathlib.Path(each).resolve() for each in sys.argv[1:3])
    kept = source / "tests/installed/interfaces.txt"
    lines = current(source, build)
    if sys.argv[3:] == ["--update"]:
        lines |= set(kept.read_text().splitlines()) if kept.exists() else set()
        kept.write_text("\n".join(sorted(lines)) + "\n")
        return
    listed = kept.read_text().splitlines()
    missing = [each for each in listed if each not in lines and not superseded(each, lines)]
    for each in missing:
        print(f"docs/promises.md: the build lacks: {each}")
    print(f"{len(listed)} lines of interfaces")
    sys.exit(1 if missing else 0)


main()
