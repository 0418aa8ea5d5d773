"""Compiles every sample graph for a target, with literals and with uniforms."""
import json
import pathlib
import subprocess


def compiled(wrinkle, graphs, folder, target, form):
    """Yields (path of the text, its reflection), the fragment stage's for a pair."""
    for graph in sorted(pathlib.Path(graphs).glob("*.json")):
        if graph.name.endswith(".test.json"):
            continue
        for numbers in ("baked", "uniform"):
            text = pathlib.Path(folder) / f"{graph.stem}_{numbers}"
            reflection = text.with_suffix(".json")
            subprocess.run([wrinkle, "compile", graph, "--target", target, "--form", form,
                            "--params", numbers, "-o", text, "--reflect", reflection], check=True)
            yield text, json.loads(reflection.read_text())
