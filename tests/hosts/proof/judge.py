"""Compares values that a host drew with those of `wrinkle eval`."""
import csv
import json
import math
import pathlib
import subprocess

RECORDED = 8  # points of a graph and object
SHARES = {"median": 0.5, "p90": 0.9, "p99": 0.99, "max": 1}


def evaluated(wrinkle, graph, options, columns, rows, work):
    """The outputs of the graph at the points, a dictionary of texts each; names of files in the
    options are relative to `work`."""
    with open(work / "points.csv", "w", newline="") as file:
        csv.writer(file).writerows([columns, *rows])
    subprocess.run([pathlib.Path(wrinkle).resolve(), "eval", graph.resolve(), *options, "--at",
                    "points.csv", "-o", "values.csv"], cwd=work, check=True)
    with open(work / "values.csv", newline="") as file:
        return list(csv.DictReader(file))


def vector(values, output):
    return [float(values[output + "." + axis]) for axis in "xyz"]


def degrees(a, b):
    cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    angle = math.degrees(math.atan2(math.hypot(*cross), sum(x * y for x, y in zip(a, b))))
    return angle if any(a) and any(b) else 180


def row(graph, host, object_name, unit, errors):
    errors = sorted(errors)
    made = {"graph": graph, "host": host, "object": object_name, "unit": unit,
            "points": len(errors)}
    for name, share in SHARES.items():
        made[name] = round(errors[min(int(share * len(errors)), len(errors) - 1)], 4)
    return made


def errors_of(point, value):
    """By unit: how far a drawn point, {"normal": ..., "color": ..., "roughness": [...]} or a part
    of these, is from the outputs at it."""
    errors = {"degrees": degrees(point["normal"], vector(value, "normal"))}
    for output, keys in (("color", ["color." + axis for axis in "xyz"]),
                         ("roughness", ["roughness"])):
        if output in point and keys[0] in value:
            errors[output + ", 1/255"] = 255 * max(
                abs(drawn - float(value[key])) for drawn, key in zip(point[output], keys))
    return errors


def within_all(errors):
    return all(error <= (0.5 if unit == "degrees" else 2) for unit, error in errors.items())


class Proof:
    """Rows of a test: `wrinkle` is the program, `graphs` the folder of the graphs."""

    def __init__(self, wrinkle, graphs, work):
        self.wrinkle, self.graphs, self.work = wrinkle, graphs, work
        self.rows, self.samples = [], []

    def compare(self, graph, host, object_name, options, columns, rows, points,
                fault=""):
        """Compares drawn points with the outputs at `rows`, the points' values of `columns`; `fault`
        names one of the host's in normals."""
        values = evaluated(self.wrinkle, self.graphs / (graph + ".json"), options, columns, rows,
                           self.work)
        errors = [errors_of(point, value) for point, value in zip(points, values)]
        name = pathlib.Path(graph).name
        for unit in errors[0]:
            made = row(name, host, object_name, unit, [each[unit] for each in errors])
            self.rows.append(made | ({"fault": fault} if fault and unit == "degrees" else {}))
        if object_name in ("plain", "back"):
            good = [i for i, each in enumerate(errors) if within_all(each)]
            self.samples.append({
                "graph": graph, "host": host, "options": options, "columns": columns,
                "points": [rounded(rows[i]) + [{key: rounded(x) for key, x in points[i].items()}]
                           for i in good[::max(len(good) // RECORDED, 1)][:RECORDED]]})


def rounded(numbers):
    return [float(f"{number:.7g}") for number in numbers]


def shader_limits(made):
    if made["unit"] != "degrees":
        return {"max": 2}
    if made["object"] == "no tangents":  # the tangents of `eval` are smooth, these are triangles'
        return {"median": 0.1, "max": 2}
    # Parallax finds another layer at few pixels, where two depths are nearly equal.
    return {"median": 0.01, "p99" if made["graph"].startswith("parallax") else "max": 0.5}


def map_limits(bits):
    return {"median": 0.15 if bits == 8 else 0.05, "p90": 0.5}


def install(packages, work):
    subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--silent", *packages], cwd=work,
                   check=True)


def drawn(page, jobs, chromium, work):
    """The results of run() of the page for the arguments of each job."""
    (work / "jobs.json").write_text(json.dumps(jobs))
    return json.loads(subprocess.run(["node", "read.mjs", chromium, page, "jobs.json"], cwd=work,
                                     check=True, stdout=subprocess.PIPE).stdout)


def check_of(made, limits, file):
    """A check of the form of `wrinkle test`, for its reports."""
    message = made.get("fault", "")
    if not message and not within(made, limits):
        message = "over the limits of this host"
    return {"test": f"hosts/{made['host']}/{made['graph']}",
            "name": f"{made['object']}, {made['unit']}",
            "status": "failed" if message else "passed", "kind": "point", "file": file,
            "message": message,
            "measured": [{"name": name, "actual": str(made[name]), "value": made[name],
                          "limit": limits.get(name, 360), "unit": made["unit"]}
                         for name in SHARES]}


def within(made, limits):
    return all(made[name] <= limit for name, limit in limits.items())


def end(proof, limits_of, name, test, build):
    """Writes below the build folder NAME.json, NAME_recorded.json and a report that `wrinkle test
    --merge` reads; returns the number of rows that are over their limits and have no named fault."""
    (build / f"{name}.json").write_text(json.dumps(proof.rows, indent=1) + "\n")
    (build / f"{name}_recorded.json").write_text(
        "[" + ",\n".join(json.dumps(sample) for sample in proof.samples) + "]\n")
    report = build / "reports" / f"hosts_{name}"
    report.mkdir(parents=True, exist_ok=True)
    checks = [check_of(made, limits_of(made), test) for made in proof.rows]
    (report / "results.json").write_text(
        json.dumps({"version": 1, "wrinkle": "", "seconds": 0, "checks": checks}) + "\n")
    failed = 0
    for made in proof.rows:
        passed = within(made, limits_of(made))
        print(made, "" if passed else "over the limits")
        failed += not passed and "fault" not in made
    return failed
