"""Compiles every sample's WGSL, functions and pairs, in naga (npm package web-naga)."""
import pathlib
import subprocess
import sys

from samples import compiled

SCRIPT = """import fs from 'fs';
const naga = await import('web-naga');
const wasm = new URL('web_naga_bg.wasm', import.meta.resolve('web-naga'));
await naga.default({module_or_path: fs.readFileSync(wasm)});
for (const path of process.argv.slice(2)) {
  try {
    naga.WgslFrontend.new().parse(fs.readFileSync(path, 'utf8')).to_wgsl();
  } catch (error) {
    console.log(path + ': ' + error);
  }
}
"""


def errors_of(paths, folder):
    """Returns naga's messages, a line each."""
    (folder / "check.mjs").write_text(SCRIPT)
    return subprocess.run(["node", "check.mjs", *paths], cwd=folder, check=True,
                          stdout=subprocess.PIPE, text=True).stdout


def main():
    wrinkle, graphs, build = sys.argv[1:]
    folder = pathlib.Path(build) / "wgsl"
    folder.mkdir(parents=True, exist_ok=True)
    subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--silent", "web-naga@1.0.1"],
                   cwd=folder, check=True)
    texts = [str(path) for path, _ in compiled(wrinkle, graphs, folder, "wgsl", "function")]
    for path, _ in compiled(wrinkle, graphs, folder, "wgsl", "shader"):
        texts += [f"{path}.vert.wgsl", f"{path}.frag.wgsl"]
    seeded = folder / "seeded.wgsl"
    seeded.write_text(pathlib.Path(texts[0]).read_text().replace("normalize(", "normalise("))
    assert errors_of([seeded], folder), "naga does not report the seeded error"
    refused = errors_of(texts, folder)
    assert not refused, refused
    print(f"{len(texts)} texts")


main()
