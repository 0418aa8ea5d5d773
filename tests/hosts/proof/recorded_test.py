"""Values that hosts drew (recorded/*.json, written by table.py) are still those of `wrinkle eval`.

usage: recorded_test.py WRINKLE SOURCE
"""
import json
import pathlib
import sys
import tempfile

import judge
import pixels


def failures(wrinkle, folder, sample, work):
    """Descriptions of the points that are too far off."""
    rows = [point[:-1] for point in sample["points"]]
    values = judge.evaluated(wrinkle, folder / (sample["graph"] + ".json"), sample["options"],
                             sample["columns"], rows, work)
    found = [judge.errors_of(point[-1], value) for point, value in zip(sample["points"], values)]
    return [(sample["host"], sample["graph"], errors) for errors in found
            if not judge.within_all(errors)]


def turned(sample):
    """The sample with one normal negated, an error that must be seen."""
    *rest, drawn = sample["points"][0]
    wrong = drawn | {"normal": [-x for x in drawn["normal"]]}
    return sample | {"points": [[*rest, wrong], *sample["points"][1:]]}


def main():
    wrinkle, source = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    files = sorted((source / "tests/hosts/recorded").glob("*.json"))
    assert files
    with tempfile.TemporaryDirectory() as name:
        work = pathlib.Path(name)
        pixels.write_torus(work / "torus.glb")
        samples = [sample for file in files for sample in json.loads(file.read_text())]
        assert len(failures(wrinkle, source / "graphs", turned(samples[0]), work)) == 1
        found = [each for sample in samples
                 for each in failures(wrinkle, source / "graphs", sample, work)]
    print(*found, sep="\n")
    sys.exit(1 if found else 0)


main()
