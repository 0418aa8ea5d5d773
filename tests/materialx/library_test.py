"""MaterialX's own library (npm, WebAssembly) finds exported documents valid, and generates shaders
of them: of the documents of this folder after import and export, and of every sample."""
import json
import pathlib
import shutil
import subprocess
import sys

PACKAGE = "@needle-tools/materialx@1.4.6"  # MaterialX 1.39.4

SCRIPT = """import fs from 'fs';
import {createRequire} from 'module';
const load = createRequire(import.meta.url)('./JsMaterialXGenShader.cjs');
const mx = await load({locateFile: file => import.meta.dirname + '/' + file});
const generator = mx.EsslShaderGenerator.create();
const context = new mx.GenContext(generator);
const library = mx.loadStandardLibraries(context);

async function problem(file) {
  const document = mx.createDocument();
  document.setDataLibrary(library);
  await mx.readFromXmlString(document, fs.readFileSync(file, 'utf8'), '');
  if (!document.validate()) return 'is not valid';
  try {
    const element = mx.findRenderableElement(document);
    const shader = generator.generate('material', element, context);
    return shader.getSourceCode('pixel').length > 1000 ? '' : 'has no shader';
  } catch (error) {
    return String(typeof error === 'number' ? mx.getExceptionMessage(error) : error);
  }
}
const found = {};
for (const file of process.argv.slice(2)) found[file] = await problem(file);
console.log(JSON.stringify(found));
"""


def install(work):
    """Node takes the loader as a CommonJS module, without its last line."""
    subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--silent", "--ignore-scripts",
                    "--legacy-peer-deps", PACKAGE], cwd=work, check=True)
    binaries = work / "node_modules/@needle-tools/materialx/bin"
    name = "JsMaterialXGenShader"
    shutil.copy(binaries / (name + ".wasm"), work)
    shutil.copy(binaries / (name + ".data.txt"), work / (name + ".data"))
    lines = (binaries / (name + ".js")).read_text().splitlines(keepends=True)
    (work / (name + ".cjs")).write_text(
        "".join(line for line in lines if not line.startswith("export default")))
    (work / "check.mjs").write_text(SCRIPT)


def imported(wrinkle, source, work):
    """Graphs of the documents; their images only have to exist."""
    for name in ["color.png", "data.png", "normal.png"]:
        shutil.copy(source / "graphs/textures/weave_normal.png", work / name)
    graphs = []
    for document in sorted((source / "tests/materialx/documents").glob("*.mtlx")):
        shutil.copy(document, work)
        graphs.append(work / (document.stem + ".json"))
        subprocess.run([wrinkle, "import", work / document.name, "-o", graphs[-1]], check=True)
    return graphs


def exported(wrinkle, graph, work):
    """The document; samples of outputs that no host has are left out."""
    folder = work / "out" / graph.stem
    subprocess.run([wrinkle, "export", graph, "--to", "materialx", "--size", "16", "-o", folder],
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=True)
    return next(folder.glob("*.mtlx"))


def problems(files, work):
    return json.loads(subprocess.run(["node", "check.mjs", *files], cwd=work, check=True,
                                     stdout=subprocess.PIPE).stdout)


def main():
    wrinkle, source, build = map(pathlib.Path, sys.argv[1:])
    work = build / "library"
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    install(work)
    samples = [path for folder in ["graphs", "graphs/materials"]
               for path in sorted((source / folder).glob("*.json"))
               if not path.name.endswith(".test.json")]
    graphs = imported(wrinkle, source, work) + samples
    found = problems([exported(wrinkle, graph, work) for graph in graphs], work)
    assert not any(found.values()), {file: text for file, text in found.items() if text}
    seeded = work / "seeded.mtlx"
    text = (work / "out/arithmetic/arithmetic.mtlx").read_text()
    seeded.write_text(text.replace('"in1" type="vector3"', '"in1" type="vector2"'))
    assert problems([seeded], work)[str(seeded)], "the library does not find the seeded error"
    print(f"{len(found)} documents")


main()
