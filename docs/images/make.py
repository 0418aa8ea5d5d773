#!/usr/bin/env python3
"""Makes the pictures of README and docs again, all but far_highlight.png, with the programs of a
build.

usage: docs/images/make.py [--programs FOLDER] [NAME...]

Without names it makes all. It needs oiiotool, and xvfb-run for the picture of the editor where
there is no display.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
MATERIALS = ["chipped_paint", "brushed_aluminium", "hammered_gold", "oxidised_copper", "car_paint",
             "scratched_plastic", "perforated_sheet", "varnished_oak", "leather", "old_brick_wall",
             "polished_marble", "terrazzo", "denim", "velvet", "snowy_rock",
             "wet_cobbles", "carbon_fibre", "crackle_ceramic", "skin", "lava"]
REBUILT = ["rusted_metal", "clinker_bricks", "deck_planks", "veined_marble", "tartan_wool",
           "crazy_paving", "forged_carbon", "scifi_panels"]
HEIGHTS = ["gradient_noise", "simplex_noise", "value_noise", "worley_noise", "fbm", "turbulence",
           "ridged", "dents", "waves", "scratches", "checker", "brick", "hexagons", "pyramids",
           "domes", "weave"]
COMPARED = [("blends", None), ("blends", "naive"), ("blends", "overlay"), ("blends", "rnm"),
            ("mirrored_uvs", None), ("mirrored_uvs", "naive"),
            ("volume_gradient", None), ("volume_gradient", "naive")]


class Maker:
    def __init__(self, programs, folder):
        self.wrinkle, self.editor = programs / "wrinkle", programs / "wrinkle-editor"
        self.folder = folder

    def run(self, *command):
        subprocess.run([str(each) for each in command], check=True, cwd=ROOT,
                       stdout=subprocess.DEVNULL)

    def render(self, graph, name, size, *options):
        """A picture twice as large, reduced: edges of meshes are smooth then."""
        large, small = self.folder / f"{name}.large.png", self.folder / f"{name}.png"
        width, height = size
        self.run(self.wrinkle, "render", graph, "-o", large, "--size", f"{2 * width}x{2 * height}",
                 *options)
        self.run("oiiotool", "--nosoftwareattrib", large, "--ch", "R,G,B", "--resize:filter=box",
                 f"{width}x{height}", "-o", small)
        return small

    def sheet(self, pictures, columns, out, *options):
        rows = (len(pictures) + columns - 1) // columns
        self.run("oiiotool", "--nosoftwareattrib", *pictures, "--mosaic:pad=0",
                 f"{columns}x{rows}", *options, "-o", out)

    def titled(self, picture, title, width):
        out = picture.with_suffix(".titled.png")
        self.run("oiiotool", "--nosoftwareattrib", picture, "--cut",
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
        pictures = [self.render(f"graphs/materials/{each}.json", each, (320, 320), "--mesh",
                                "torus") for each in MATERIALS]
        self.sheet(pictures, 5, HERE / "gallery.jpg", "--compression", "jpeg:88")

    def rebuilt(self):
        pictures = [self.render(f"graphs/rebuilt/{each}.json", each, (300, 300))
                    for each in REBUILT]
        self.sheet(pictures, 4, HERE / "rebuilt.jpg", "--compression", "jpeg:88")

    def procedural_heights(self):
        pictures = [self.render(f"graphs/nodes/{each}.json", each, (130, 130), "--mesh",
                                "sphere" if i < 8 else "plane", "--background", "plain")
                    for i, each in enumerate(HEIGHTS)]
        self.sheet(pictures, 8, HERE / "procedural_heights.png")

    def comparisons(self):
        pictures = []
        for graph, against in COMPARED:
            view = ["--view", "difference", "--against", against] if against else []
            name = f"{graph}-{against}" if against else graph
            picture = self.render(f"graphs/compare/{graph}.json", name, (184, 184), "--background",
                                  "plain", *view)
            pictures.append(self.titled(picture, name, 184))
        self.sheet(pictures, 4, HERE / "comparisons.png")

    def editor_picture(self):
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
        pictures = {"woven_strap": maker.woven_strap, "everything": maker.everything,
                    "teapot": maker.teapot, "skinned_tube": maker.skinned_tube,
                    "baked_teapot": maker.baked_teapot, "gallery": maker.gallery,
                    "rebuilt": maker.rebuilt,
                    "procedural_heights": maker.procedural_heights,
                    "comparisons": maker.comparisons, "editor": maker.editor_picture}
        for name in options.names or pictures:
            print(name)
            pictures[name]()


if __name__ == "__main__":
    main()
