#!/usr/bin/env python3
"""Draws four materials in Wrinkle and in the hosts with one mesh, camera and environment, side by
side: docs/images/hosts/NAME.png.

    tests/hosts/proof/images.py build/release/bin/wrinkle [NAME...]

It needs chromium, godot3, blender, node, npm, xvfb-run and oiiotool.
"""
import base64
import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

import judge

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
OUT = ROOT / "docs/images/hosts"
FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
MATERIALS = {"chipped_paint": "materials/chipped_paint", "car_paint": "materials/car_paint",
             "old_brick_wall": "materials/old_brick_wall", "velvet": "materials/velvet"}
DISPLACED = ["old_brick_wall"]
HOSTS = {"wrinkle": "Wrinkle", "three": "three.js", "gltf": "three.js, glTF",
         "godot3": "Godot 3", "blender": "Blender"}
SIDE = 216  # of an image
LARGE = 4 * SIDE  # of those that are drawn with one sample of the material a pixel
# A sphere of radius 1 as `wrinkle render` frames it: eye and field of view in radians.
YAW, PITCH, FIELD_OF_VIEW = 0.35, 0.3, 0.5
DISTANCE = 1.12 / math.sin(FIELD_OF_VIEW / 2)
EYE = [DISTANCE * x for x in (math.sin(YAW) * math.cos(PITCH), math.sin(PITCH),
                              math.cos(YAW) * math.cos(PITCH))]
# Softboxes: azimuth from +z to +x and elevation in degrees, half their size, radiance.
LIGHTS = [(-40, 42, 22, 14, 9.0), (75, 20, 12, 30, 3.0), (160, 35, 30, 12, 4.0)]


def radiance(azimuth, elevation):
    """Of the environment, in gray."""
    value = 0.35 + 0.25 * math.sin(math.radians(elevation))
    for a, e, width, height, light in LIGHTS:
        x = abs((azimuth - a + 180) % 360 - 180) / width
        y = abs(elevation - e) / height
        value += light * min(max((1 - max(x, y)) * 4, 0), 1)
    return value


def write_environment(path, azimuth_of_u):
    """A Radiance file, equirectangular, up at the top; azimuth_of_u is that of u in [0, 1]."""
    width, height = 512, 256
    data = bytearray(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n" % (height, width))
    for y in range(height):
        for x in range(width):
            value = radiance(azimuth_of_u((x + 0.5) / width), 90 - 180 * (y + 0.5) / height)
            mantissa, exponent = math.frexp(value)
            data += struct.pack("4B", *[int(mantissa * 256)] * 3, exponent + 128)
    path.write_bytes(data)


# Of the middle column and the direction of growing u: azimuths of each host's convention.
ENVIRONMENTS = {"wrinkle": lambda u: 180 - 360 * (u - 0.5), "three": lambda u: 90 - 360 * (u - 0.5),
                "godot3": lambda u: 180 - 360 * u, "blender": lambda u: 90 - 360 * (u - 0.5)}


def run(*command, **options):
    done = subprocess.run([str(each) for each in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, **options)
    assert done.returncode == 0, done.stdout
    return done.stdout


class Images:
    def __init__(self, wrinkle, work):
        self.wrinkle, self.work = wrinkle, work
        for host, azimuth_of_u in ENVIRONMENTS.items():
            write_environment(work / f"{host}.hdr", azimuth_of_u)

    def export(self, name, host):
        folder = self.work / host / name
        run(self.wrinkle, "export", ROOT / f"graphs/{MATERIALS[name]}.json", "--to", host, "--mesh",
            "sphere", "--size", 2048, "--name", name, "-o", folder)
        return folder

    def image(self, name, host):
        return self.work / f"{name}_{host}.png"

    def draw_wrinkle(self, name):
        run(self.wrinkle, "render", ROOT / f"graphs/{MATERIALS[name]}.json", "-o",
            self.image(name, "wrinkle"), "--mesh", "sphere", "--size", f"{2 * SIDE}x{2 * SIDE}",
            "--environment", self.work / "wrinkle.hdr", "--tone", "linear",
            *(["--displace"] if name in DISPLACED else []))

    def draw_three(self, names, chromium):
        for each in ("images.html", "read.mjs"):
            shutil.copy(HERE / each, self.work)
        judge.install(["three@0.187.0", "puppeteer-core@24.43.1"], self.work)
        jobs = [(host, name, LARGE, EYE, math.degrees(FIELD_OF_VIEW))
                for host in ("three", "gltf") for name in names]
        for host, name, *_ in jobs:
            self.export(name, host)
        for (host, name, *_), url in zip(jobs, judge.drawn("images.html", jobs, chromium,
                                                           self.work)):
            self.image(name, host).write_bytes(base64.b64decode(url.split(",")[1]))

    def draw_godot(self, name):
        folder = self.export(name, "godot3")
        shutil.copy(HERE / "images.gd", folder)
        (folder / "images.tscn").write_text(
            '[gd_scene load_steps=2 format=2]\n[ext_resource path="res://images.gd" type="Script" '
            'id=1]\n[node name="Images" type="Spatial"]\nscript = ExtResource( 1 )\n')
        (folder / "job.json").write_text(json.dumps({
            "material": f"res://{name}/{name}_material.tres", "eye": EYE,
            "environment": str(self.work / "godot3.hdr"), "out": str(self.image(name, "godot3")),
            "field_of_view": math.degrees(FIELD_OF_VIEW)}))
        log = run("timeout", 300, "xvfb-run", "-a", "-s", "-screen 0 1024x1024x24", "godot3", "--path",
                  folder, "--audio-driver", "Dummy", "--resolution", f"{LARGE}x{LARGE}",
                  "images.tscn", env=os.environ | {"HOME": str(folder)})
        assert "SHADER ERROR" not in log and "SCRIPT ERROR" not in log, log

    def draw_blender(self, name):
        folder = self.export(name, "blender")
        environment = os.environ | {"PATH": "/usr/bin:/bin"}
        start = ("blender", "-b", "--factory-startup", "--python-exit-code", 1)
        run(*start, "-P", folder / f"{name}.py", "--", "--save", folder / f"{name}.blend",
            env=environment)
        run(*start, folder / f"{name}.blend", "-P", HERE / "images_blender.py", "--",
            self.work / "blender.hdr", self.image(name, "blender"), 2 * SIDE, FIELD_OF_VIEW, *EYE,
            env=environment)

    def sheet(self, name):
        titled = []
        for host, title in HOSTS.items():
            image = self.image(name, host)
            out = image.with_suffix(".titled.png")
            run("oiiotool", "--nosoftwareattrib", image, "--ch", "R,G,B",
                "--resize:filter=box", f"{SIDE}x{SIDE}", "--cut",
                f"{SIDE}x{SIDE + 22}+0+0",
                f"--text:x={SIDE // 2}:y={SIDE + 16}:xalign=center:size=13:font={FONT}", title,
                "-o", out)
            titled.append(out)
        run("oiiotool", "--nosoftwareattrib", *titled, "--mosaic:pad=0", f"{len(titled)}x1",
            "--attrib", "png:compressionLevel", 9, "-o",
            OUT / f"{name}.png")


def main():
    wrinkle, names = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:] or list(MATERIALS)
    OUT.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=os.environ.get("KEEP")) as folder:
        images = Images(wrinkle, pathlib.Path(folder))
        images.draw_three(names, shutil.which("chromium"))
        for name in names:
            print(name)
            images.draw_wrinkle(name)
            images.draw_godot(name)
            images.draw_blender(name)
            images.sheet(name)


main()
