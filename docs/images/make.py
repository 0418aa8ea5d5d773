#!/usr/bin/env python3
"""Renders the images of README and docs, all but far_highlight.png and report.png, with the
programs of a build.

usage: docs/images/make.py [--programs FOLDER] [NAME...]

Without names it renders all. It needs oiiotool, and xvfb-run for the image of the editor where
there is no display.
"""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
COMPARED = [("blends", None), ("blends", "naive"), ("blends", "overlay"), ("blends", "rnm"),
            ("mirrored_uvs", None), ("mirrored_uvs", "naive"),
            ("volume_gradient", None), ("volume_gradient", "naive")]


def graphs_of(page, folder):
    """The graphs of a folder that a page names, in its order."""
    names = dict.fromkeys(re.findall(r"`(\w+)`", (ROOT / "docs" / page).read_text()))
    return [name for name in names if (ROOT / "graphs" / folder / f"{name}.json").exists()]


class Maker:
    def __init__(self, programs, folder):
        self.wrinkle, self.editor = programs / "wrinkle", programs / "wrinkle-editor"
        self.folder = folder

    def run(self, *command, input=None):
        subprocess.run([str(each) for each in command], check=True, input=input, text=True,
                       cwd=ROOT / "graphs/compare" if input else ROOT,
                       stdout=subprocess.DEVNULL)

    def render(self, graph, name, size, *options):
        """An image twice as large, reduced: edges of meshes are smooth then. `graph` is a file, or
        the parsed text of one whose images are in graphs/compare."""
        large, small = self.folder / f"{name}.large.png", self.folder / f"{name}.png"
        width, height = size
        text = json.dumps(graph) if isinstance(graph, dict) else None
        self.run(self.wrinkle, "render", "-" if text else ROOT / graph, "-o", large, "--size",
                 f"{2 * width}x{2 * height}", *options, input=text)
        self.run("oiiotool", "--nosoftwareattrib", large, "--ch", "R,G,B", "--resize:filter=box",
                 f"{width}x{height}", "-o", small)
        return small

    def sheet(self, images, columns, out, *options):
        rows = (len(images) + columns - 1) // columns
        self.run("oiiotool", "--nosoftwareattrib", *images, "--mosaic:pad=0",
                 f"{columns}x{rows}", *options, "-o", out)

    def titled(self, image, title, width):
        out = image.with_suffix(".titled.png")
        self.run("oiiotool", "--nosoftwareattrib", image, "--cut",
                 f"{width}x{width + 24}+0+0",
                 f"--text:x={width // 2}:y={width + 17}:xalign=center:size=13:font={FONT}",
                 title, "-o", out)
        return out

    def single(self, name, graph, size, *options):
        shutil.copy(self.render(graph, name, size, *options), HERE / f"{name}.png")

    def layers(self):
        """The average of two normal maps, their sum, and the angle between both."""
        graph = json.loads((ROOT / "graphs/compare/blends.json").read_text())
        graph["outputs"] = {name: {"from": f"input.{name}"} for name in ("color", "roughness")}
        graph["outputs"] |= {"normal": {"from": "resolved.normal"},
                             "naive": {"from": "naive_resolved.normal"}}
        graph["inputs"] = {"color": {"type": "color", "default": [0.62, 0.25, 0.08]},
                           "roughness": {"type": "float", "default": 0.3}}
        average = graph | {"outputs": graph["outputs"] | {"normal": graph["outputs"]["naive"]}}
        difference = ["--view", "difference", "--against", "naive", "--background", "plain"]
        images = [self.render(average, "average", (480, 400)),
                  self.render(graph, "sum", (480, 400)),
                  self.render(graph, "angle", (480, 400), *difference)]
        self.sheet(images, 3, HERE / "layers.jpg", "--compression", "jpeg:90")

    def everything(self):
        self.single("everything", "graphs/everything.json", (480, 480))

    def teapot(self):
        self.single("teapot", "graphs/woven_strap.json", (480, 320), "--mesh", "teapot")

    def skinned_tube(self):
        self.single("skinned_tube", "graphs/compare/skinned_tube.json", (400, 400), "--mesh",
                    "graphs/compare/meshes/bent_cylinder.glb")

    def baked_teapot(self):
        baked = self.folder / "teapot_normal.png"
        self.run(self.wrinkle, "bake", "graphs/triplanar_rock.json", "--mesh", "teapot", "--size",
                 512, "-o", baked)
        self.run("oiiotool", "--nosoftwareattrib", baked, "--ch", "R,G,B", "--compression",
                 "jpeg:92", "-o", HERE / "baked_teapot.jpg")

    def gallery(self):
        images = [self.render(f"graphs/materials/{each}.json", each, (320, 320), "--mesh",
                                "torus") for each in graphs_of("gallery.md", "materials")]
        self.sheet(images, 5, HERE / "gallery.jpg", "--compression", "jpeg:88")

    def rebuilt(self):
        images = [self.render(f"graphs/rebuilt/{each}.json", each, (300, 300))
                    for each in graphs_of("gallery.md", "rebuilt")]
        self.sheet(images, 4, HERE / "rebuilt.jpg", "--compression", "jpeg:88")

    def procedural_heights(self):
        images = [self.render(f"graphs/nodes/{each}.json", each, (130, 130), "--mesh",
                                "sphere" if i < 8 else "plane", "--background", "plain")
                    for i, each in enumerate(graphs_of("procedural-heights.md", "nodes")[:16])]
        self.sheet(images, 8, HERE / "procedural_heights.png")

    def comparisons(self):
        images = []
        for graph, against in COMPARED:
            view = ["--view", "difference", "--against", against] if against else []
            name = f"{graph}-{against}" if against else graph
            image = self.render(f"graphs/compare/{graph}.json", name, (184, 184), "--background",
                                  "plain", *view)
            images.append(self.titled(image, name, 184))
        self.sheet(images, 4, HERE / "comparisons.png")

    def tutorial(self):
        """The graphs of docs/tutorial.md, the last one also with a preset."""
        page = (ROOT / "docs/tutorial.md").read_text()
        graphs = [json.loads(text)
                  for text in re.findall(r"```json wall.json\n(.*?)```", page, re.DOTALL)]
        yellow = ["--preset", "Yellow", "--set", "input.grain=2"]
        images = [self.render(graph, f"wall{i}", (360, 300)) for i, graph in enumerate(graphs)]
        images.append(self.render(graphs[-1], "yellow", (360, 300), *yellow))
        self.sheet(images, 4, HERE / "tutorial.png")

    def window(self, name, graph, *options):
        """An image of the editor."""
        shot = [self.editor, graph, "--size", 1600, 900, "--state", self.folder / "state",
                *(options or ["--shot", HERE / f"{name}.png"])]
        self.run(*([] if os.environ.get("DISPLAY") else ["xvfb-run", "-a"]), *shot)

    def editor_image(self):
        self.window("editor", "graphs/woven_strap.json")

    def tutorial_editor(self):
        """The second part of docs/tutorial.md, by its keys."""
        def add(title):
            return f"key Space\ntype {title}\nkey Enter\n"

        bump = add("bump from height")
        script = self.folder / "tutorial.txt"
        script.write_text(
            "click canvas+-300,-280\n" + add("bricks in bonds") + bump +
            "click canvas+-300,330\n" + add("gradient noise") + bump +
            "key Home\nstroke Shift left node:gradient_from_height node:gradient_from_height+1,0\n" +
            add("add bumps") + add("resolve") + "key Ctrl+L\nawait picture\n"
            f"shot {HERE / 'tutorial_editor.png'}\n")
        self.window("tutorial_editor", self.folder / "new.json", "--script", script)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("names", nargs="*", metavar="NAME")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        maker = Maker(options.programs.resolve(), pathlib.Path(folder))
        images = {"layers": maker.layers, "everything": maker.everything,
                    "teapot": maker.teapot, "skinned_tube": maker.skinned_tube,
                    "baked_teapot": maker.baked_teapot, "gallery": maker.gallery,
                    "rebuilt": maker.rebuilt,
                    "procedural_heights": maker.procedural_heights,
                    "comparisons": maker.comparisons, "editor": maker.editor_image, "tutorial": maker.tutorial,
                    "tutorial_editor": maker.tutorial_editor}
        for name in options.names or images:
            print(name)
            images[name]()


if __name__ == "__main__":
    main()
