#!/usr/bin/env python3
"""Renders the images of README and docs, all but far_highlight.png and report.png, with the
programs of a build.

usage: docs/images/make.py [--programs FOLDER] [NAME...]

Without names it renders all. It needs oiiotool, and xvfb-run for the image of the editor where
there is no display.
"""
import argparse
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

    def run(self, *command):
        subprocess.run([str(each) for each in command], check=True, cwd=ROOT,
                       stdout=subprocess.DEVNULL)

    def render(self, graph, name, size, *options):
        """An image twice as large, reduced: edges of meshes are smooth then."""
        large, small = self.folder / f"{name}.large.png", self.folder / f"{name}.png"
        width, height = size
        self.run(self.wrinkle, "render", graph, "-o", large, "--size", f"{2 * width}x{2 * height}",
                 *options)
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

    def woven_strap(self):
        self.single("woven_strap", "graphs/woven_strap.json", (480, 480))

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

    def editor_image(self):
        shot = [self.editor, "graphs/woven_strap.json", "--size", 1600, 900, "--state",
                self.folder / "state", "--shot", HERE / "editor.png"]
        self.run(*([] if os.environ.get("DISPLAY") else ["xvfb-run", "-a"]), *shot)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build/release/bin")
    parser.add_argument("names", nargs="*", metavar="NAME")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        maker = Maker(options.programs.resolve(), pathlib.Path(folder))
        images = {"woven_strap": maker.woven_strap, "everything": maker.everything,
                    "teapot": maker.teapot, "skinned_tube": maker.skinned_tube,
                    "baked_teapot": maker.baked_teapot, "gallery": maker.gallery,
                    "rebuilt": maker.rebuilt,
                    "procedural_heights": maker.procedural_heights,
                    "comparisons": maker.comparisons, "editor": maker.editor_image}
        for name in options.names or images:
            print(name)
            images[name]()


if __name__ == "__main__":
    main()
