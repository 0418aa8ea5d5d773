#!/usr/bin/env python3
"""What generated shaders cost beside Mikkelsen's reference code, case by case.

usage: tests/cost/cost_table.py [--wrinkle PROGRAM] [--markdown] [--keep FOLDER] [--check FILE]
                                [CASE...]

Each case of cases.json is a graph; `wrinkle compile` writes its function, a wrapper hands it
interpolants and writes the normal, glslangValidator and `spirv-opt -O` make SPIR-V of it, and
spirv_count.py counts. The reference's figures were counted by the same rule on its own code with
the same interpolants, normal out, no lighting. A load from a table of numbers, which noise of the
reference does, is in no sum of numbers: it is taken as 16 of them.

`wrinkle compile --cost --json` counts by itself, from the GLSL 4.50 of the same graph: with --check
it must come to the same figures, and its nodes to the whole.

Below the table: the mean ratio over the cases whose code does the same on both sides (i to viii
and post, without noise), and which of them are above 1. Exits 1 when a case does not compile; with
--check also when the program counts otherwise, when a row is dearer than in the markdown table of
FILE, when that mean is above 0.85 or one of them above 1, and when one or two tangent normals on
vertex tangents are dearer than by hand or divide. Never for a cost without --check.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import spirv_count

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def run(command, **more):
    done = subprocess.run(command, capture_output=True, text=True, **more)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}{done.stderr}")
    return done.stdout


COMPARED = re.compile(r"(i|ii|iii|iv|v|vi|vii|viii|post)['x*]*$")
GREATEST_MEAN = 0.85
# What is known to be enough, division-free: case, numbers.
BY_HAND = {"i": 54, "ii'": 74}
OF_A_LOAD = 16


def is_known(wrinkle, case):
    """Whether every node of the case is there; a build may leave families out."""
    types = {node["type"] for node in case["nodes"].values()}
    return all(subprocess.run([wrinkle, "nodes", name], capture_output=True).returncode == 0
               for name in types)


def compile_graph(wrinkle, case, *options):
    graph = {"wrinkle": 1, "name": case["what"], "back_faces": "none", "nodes": case["nodes"],
             "outputs": {"normal": case["normal"]}}
    # Pictures are those of the samples; only their names matter.
    return run([wrinkle, "compile", "-", "--name", "material", *options], input=json.dumps(graph),
               cwd=ROOT / "graphs")


# By the names of spirv_count.py.
NAMES = {"alu": "alu", "trans": "transcendental", "div": "divisions", "tex": "texture_reads",
         "query": "texture_queries", "deriv": "derivatives", "deriv_lanes": "derivative_numbers",
         "branch": "branches", "loop": "loops"}


def other_counts(wrinkle, case, cost):
    """Where `wrinkle compile --cost` comes to something else, a sentence each."""
    counted = json.loads(compile_graph(wrinkle, case, "--cost", "--json"))["graphs"][0]["cost"]
    parts = [*counted["nodes"], counted["surface_point"]]
    found = []
    for ours, name in NAMES.items():
        total, sum_of_parts = counted["total"][name], sum(part[name] for part in parts)
        once = counted["loop_bodies_once"][name]
        if once != cost[ours]:
            found.append(f"{case['what']}: --cost counts {once} {name}, here {cost[ours]}")
        if total != sum_of_parts:
            found.append(f"{case['what']}: the nodes have {sum_of_parts} of {total} {name}")
    return found


def wrapped(text):
    """The function called with interpolants: `position_relative` and all others are varyings."""
    struct = re.search(r"struct WrinkleSurface_material \{(.*?)\};", text, re.S)
    members = re.findall(r"^\s*(\w+) (\w+);", struct.group(1), re.M) if struct else []
    varyings = "".join(f"layout(location = {i}) in {kind} v_{name};\n"
                       for i, (kind, name) in enumerate(members))
    fill = "".join(f"    s.{name} = v_{name};\n" for _, name in members)
    call = "wrinkle_material(s).normal" if struct else "wrinkle_material().normal"
    return ("#version 450\n" + varyings + "layout(location = 0) out vec3 result;\n" + text +
            "\nvoid main() {\n" + ("    WrinkleSurface_material s;\n" if struct else "") + fill +
            f"    result = {call};\n}}\n")


def cost_of(shader):
    with tempfile.TemporaryDirectory() as folder:
        source, raw, small = (os.path.join(folder, name) for name in ("s.frag", "s.spv", "o.spv"))
        pathlib.Path(source).write_text(shader)
        run(["glslangValidator", "-G", "--aml", "--amb", "-o", raw, source])
        run(["spirv-opt", "-O", raw, "-o", small])
        return spirv_count.count(run(["spirv-dis", small]))


def reference_of(case):
    """The reference's figures, or those of a shader that follows its published algorithm."""
    reference = case["reference"]
    if "shader" in reference:
        cost = cost_of((HERE / "reference" / reference["shader"]).read_text())
        reference = {**cost, "deriv": f"{cost['deriv']}/{cost['deriv_lanes']}"}
    loads = reference.get("table_loads", 0)
    return {**reference, "alu": reference["alu"] + OF_A_LOAD * loads}


def row(case, cost, reference, markdown):
    ours = [cost[c] for c in ("alu", "trans", "div", "tex", "query", "branch", "loop")]
    screen = f"{cost['deriv']}/{cost['deriv_lanes']}"
    ratio = f"{cost['alu'] / reference['alu']:.2f}"
    other = " ".join(str(reference.get(c, 0)) for c in ("trans", "div", "tex", "query"))
    other += f" {reference.get('deriv', '0/0')} {reference.get('branch', 0)}"
    mine = f"{' '.join(map(str, ours[1:5]))} {screen} {ours[5]}"
    cells = [case["case"], case["what"], str(ours[0]), str(reference["alu"]), ratio, mine, other]
    if markdown:
        return "| " + " | ".join(cells) + " |"
    return f"{cells[0]:7}{cells[1]:58}{cells[2]:>5}{cells[3]:>6}{cells[4]:>6}  {mine:22}{other}"


def is_compared(case):
    return COMPARED.match(case["case"]) and "table_loads" not in case["reference"]


def summary(done):
    """Of (case, cost, reference): the mean ratio and what is above 1, as text and as numbers."""
    ratios = [(cost["alu"] / reference["alu"], case) for case, cost, reference in done
              if is_compared(case)]
    if not ratios:
        return "", 0, []
    mean = sum(ratio for ratio, _ in ratios) / len(ratios)
    above = [case["what"] for ratio, case in ratios if ratio > 1]
    text = f"Mean ratio of the {len(ratios)} cases i to viii and post, without noise: {mean:.3f}; "
    return text + f"above 1: {', '.join(above) or 'none'}.", mean, above


def documented(text):
    """The numbers of each row of a markdown table, by case and graph."""
    rows = (line.strip("| ").split(" | ") for line in text.splitlines() if line.startswith("| "))
    return {(cells[0], cells[1]): int(cells[2]) for cells in rows
            if len(cells) == len(HEAD) and cells[2].isdigit()}


def findings(done, before):
    """What --check refuses, a sentence each."""
    found = []
    for case, cost, _ in done:
        name = f"{case['case']} {case['what']}"
        known = before.get((case["case"], case["what"]))
        if known is None:
            found.append(f"{name}: the document has no such row")
        elif cost["alu"] > known:
            found.append(f"{name}: {cost['alu']} numbers, in the document {known}")
        least = BY_HAND.get(case["case"])
        if least and (cost["alu"] > least or cost["div"]):
            found.append(f"{name}: {cost['alu']} numbers and {cost['div']} divisions; {least} and "
                         "none are enough")
    _, mean, above = summary(done)
    if mean > GREATEST_MEAN:
        found.append(f"the mean ratio is {mean:.3f}; at most {GREATEST_MEAN} is wanted")
    return found + [f"{what}: dearer than the reference" for what in above]


HEAD = ["case", "graph", "ALU", "reference", "ratio", "trans div tex query deriv branch",
        "the reference's"]


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="*")
    parser.add_argument("--wrinkle", default=str(ROOT / "build/release/bin/wrinkle"))
    parser.add_argument("--markdown", action="store_true")
    parser.add_argument("--keep", help="a folder for the shaders")
    parser.add_argument("--check", metavar="FILE", help="a document with the table as it was")
    options = parser.parse_args()
    if options.markdown:
        print("| " + " | ".join(HEAD) + " |\n|" + "---|" * len(HEAD))
    else:
        print(f"{'case':7}{'graph':58}{'ALU':>5}{'ref':>6}{'ratio':>6}  {HEAD[5]:22}")
    done, found = [], []
    for case in json.loads((HERE / "cases.json").read_text()):
        if options.cases and case["case"] not in options.cases:
            continue
        wrinkle = os.path.abspath(options.wrinkle)
        if not is_known(wrinkle, case):
            print(f"{case['what']}: its nodes are not in this build", file=sys.stderr)
            continue
        shader = wrapped(compile_graph(wrinkle, case))
        if options.keep:
            name = re.sub(r"\W+", "_", f"{case['case']} {case['what']}") + ".frag"
            (pathlib.Path(options.keep) / name).write_text(shader)
        done.append((case, cost_of(shader), reference_of(case)))
        if options.check:
            found += other_counts(wrinkle, case, done[-1][1])
        print(row(*done[-1], options.markdown), flush=True)
    print("\n" + summary(done)[0])
    if options.check:
        found += findings(done, documented(pathlib.Path(options.check).read_text()))
        for sentence in found:
            print(sentence, file=sys.stderr)
        sys.exit(1 if found or not done else 0)


if __name__ == "__main__":
    main()
