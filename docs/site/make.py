#!/usr/bin/env python3
"""make.py WRINKLE OUT: writes the documentation as a static site with search into OUT.

The pages are README.md, CHANGELOG.md, CONTRIBUTING.md and docs/*.md as they are, and a node reference
that the program WRINKLE prints. The site needs no server: index.html opens from the file system.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

TREE = Path(__file__).resolve().parents[2]
LINKED = ["graphs", "core"]  # folders with files that pages link
KINDS = ["Tutorials", "How to", "Reference", "Explanation"]  # headings of lists in README


def samples_by_type():
    """The samples that use a node type, those of graphs/nodes first."""
    samples = {}
    for folder in ["graphs/nodes", "graphs", "graphs/materials"]:
        for path in sorted((TREE / folder).glob("*.json")):
            if path.name.endswith(".test.json"):
                continue
            nodes = json.loads(path.read_text())["nodes"]
            for node_type in {node["type"] for node in nodes.values()}:
                samples.setdefault(node_type, []).append(path)
    return samples


def picture_of(sample):
    picture = sample.parent / "golden" / (sample.stem + ".png")
    return picture if picture.exists() else None


def lines_about_samples(node_type, samples):
    used = samples.get(node_type, [])
    used = sorted(used, key=lambda path: path.stem != node_type)[:3]
    lines = []
    pictures = [path for path in used if picture_of(path)]
    if pictures:
        name = pictures[0].relative_to(TREE)
        picture = picture_of(pictures[0]).relative_to(TREE)
        lines += [f"![{name}](../{picture})", ""]
    if used:
        links = [f"[{path.relative_to(TREE)}](../{path.relative_to(TREE)})" for path in used]
        lines += ["Used in " + ", ".join(links) + ".", ""]
    return lines


def write_node_pages(wrinkle, source):
    """One page for each category; returns their names in order."""
    text = subprocess.run([wrinkle, "nodes", "--markdown"], check=True, stdout=subprocess.PIPE,
                          text=True, env={**os.environ, "WRINKLE_NO_DEFAULT_PLUGINS": "1"}).stdout
    samples = samples_by_type()
    pages = []
    (source / "nodes").mkdir()
    for part in re.split(r"^## ", text, flags=re.M)[1:]:
        category = part.split("\n", 1)[0].strip()
        lines = []
        for line in ("# Nodes: " + part).split("\n"):
            heading = re.match(r"### .*\(`(.*)`\)$", line)
            lines.append(line[1:] if heading else line)
            if heading:
                lines += ["", *lines_about_samples(heading.group(1), samples)]
        name = re.sub(r"\W+", "_", category)
        (source / "nodes" / (name + ".md")).write_text("\n".join(lines))
        pages.append("nodes/" + name)
    return pages


def lists_of_readme(readme):
    """The pages below each heading of KINDS, in order of their links."""
    lists = {}
    for kind in KINDS:
        found = re.search(rf"^{kind}:\n\n((?:\* .*\n)+)", readme, re.M)
        if not found:
            sys.exit(f"make.py: README.md has no list '{kind}:'")
        pages = re.findall(r"\]\(([\w/-]+)\.md\)", found.group(1))
        lists[kind] = list(dict.fromkeys(pages))
    return lists


def check_all_are_listed(lists):
    listed = {page for pages in lists.values() for page in pages}
    missing = [path.stem for path in (TREE / "docs").glob("*.md") if f"docs/{path.stem}" not in listed]
    if missing:
        sys.exit(f"make.py: no list of README.md names {', '.join(sorted(missing))}")


def write_sources(wrinkle, source):
    readme = (TREE / "README.md").read_text()
    lists = lists_of_readme(readme)
    check_all_are_listed(lists)
    lists["Nodes"] = write_node_pages(wrinkle, source)
    for kind, pages in lists.items():
        readme += f"\n```{{toctree}}\n:hidden:\n:caption: {kind}\n\n" + "\n".join(pages) + "\n```\n"
    (source / "README.md").write_text(readme)
    for name in ["CHANGELOG.md", "CONTRIBUTING.md", "LICENSE"]:
        shutil.copy(TREE / name, source)
    shutil.copytree(TREE / "docs", source / "docs", ignore=shutil.ignore_patterns("site", "*.py"))
    for name in LINKED:
        (source / name).symlink_to(TREE / name)
    shutil.copy(TREE / "docs/site/conf.py", source)
    shutil.copy(TREE / "cmake/package/wrinkle.svg", source)


def main():
    wrinkle, out = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "source"
        source.mkdir()
        write_sources(wrinkle, source)
        ran = subprocess.run(["sphinx-build", "-q", "-W", "--keep-going", "-b", "html", source, out])
        if ran.returncode != 0:
            sys.exit("make.py: sphinx-build warns")
    shutil.copy(Path(out) / "README.html", Path(out) / "index.html")


if __name__ == "__main__":
    main()
