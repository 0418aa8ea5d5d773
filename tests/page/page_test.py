"""Opens the report of seeded errors in Chromium: its cause, its keys, and axe-core (npm).

Its JUnit file is read by two packages of npm.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import time

AXE = "axe-core@4.14.1"
JUNIT_READERS = ["junit2json@4.0.0", "test-results-parser@0.4.6"]
POLICY = re.compile(r'<meta\s+http-equiv="Content-Security-Policy"[^>]*>')


def replace(path, old, new):
    text = path.read_text()
    assert old in text, f"{path}: no {old}"
    path.write_text(text.replace(old, new, 1))


def seed_errors(graphs):
    """One of each kind: a value, an image, a cost, a baseline, a renamed output."""
    replace(graphs / "base_and_detail.json", '"amount": 0.5', '"amount": 1.8')
    shutil.copy(graphs / "textures/rivets_normal.png", graphs / "textures/weave_normal.png")
    replace(graphs / "rusty_steel.test.json", "{", '{"budget": {"alu": 200},')
    (graphs / "golden/marble.glsl").rename(graphs / "golden/marbles.glsl")
    replace(graphs / "rings.json", '"height": {', '"heights": {')


def dump(chromium, page, flags=()):
    """Returns the document after its scripts ran."""
    return subprocess.run(
        [chromium, "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1280,900",
         "--virtual-time-budget=10000", *flags, "--dump-dom", page.as_uri()],
        check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout


def with_script(html, script, page):
    """Runs a script after that of the page; its result is the title."""
    text = POLICY.sub("", html)
    page.write_text(text.replace("</body>", f"<script>{script}</script></body>"))
    return page


def title_of(dom):
    return re.search(r"<title>(.*?)</title>", dom, re.S).group(1)


KEYS = """addEventListener('load', () => setTimeout(() => {
  const press = (key) => document.activeElement.dispatchEvent(
      new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true}));
  const seen = [];
  press('j'); press('j');
  seen.push(checks.indexOf(current));
  press('a');
  seen.push(document.querySelector('#accept').textContent.includes(current.id));
  const pictured = document.querySelector('.images img').closest('details');
  select(pictured);
  setTimeout(() => {
    const view = viewers.get(pictured);
    const tabs = [...pictured.querySelectorAll('[role=tab]')];
    for (const key of ['2', '3', '4', '5', '6', '1']) {
      press(key);
      seen.push(tabs.findIndex((tab) => tab.getAttribute('aria-selected') === 'true'));
    }
    press('+');
    seen.push(view.zoom);
    press('f');
    seen.push(view.zoom);
    search.value = 'rusty_steel/budget';
    search.dispatchEvent(new Event('input'));
    seen.push(shown_checks().length);
    seen.push(location.hash.includes('rusty_steel'));
    document.title = JSON.stringify(seen);
  }, 100);
}, 100));"""

AXE_RUN = """addEventListener('load', () => setTimeout(async () => {
  for (const each of checks) each.open = true;
  await new Promise((done) => setTimeout(done, 500));
  const found = await axe.run({runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'best-practice']});
  document.title = 'axe ' + found.passes.length + ' ' + found.violations.map((each) =>
      each.id + ': ' + each.nodes.slice(0, 3).map((node) => node.html.slice(0, 150))).join('; ');
}, 300));"""


def check_accessibility(chromium, html, folder):
    install([AXE], folder)
    axe = (folder / "node_modules/axe-core/axe.min.js").read_text()
    page = folder / "axe.html"
    light = title_of(dump(chromium, with_script(html, axe + AXE_RUN, page)))
    dark = title_of(dump(chromium, page, ["--force-dark-mode"]))
    for found in (light, dark):
        assert re.fullmatch(r"axe [1-9]\d+ ", found), found
    seeded = html.replace("--quiet: #545c69", "--quiet: #c5c5c5")
    seeded = seeded.replace('<html lang="en">', "<html>")
    found = title_of(dump(chromium, with_script(seeded, axe + AXE_RUN, page)))
    assert "html-has-lang" in found and "color-contrast" in found, "axe misses seeded errors"


READ_JUNIT = """import fs from 'fs';
import {parse} from 'junit2json';
import parser from 'test-results-parser';
const file = process.argv[2];
const first = await parse(fs.readFileSync(file, 'utf8'));
const second = parser.parse({type: 'junit', files: [file]});
console.log(JSON.stringify([
  [first.failures, first.errors, first.testsuite.length],
  [second.failed, second.errors, second.suites.length]]));
"""


def check_junit(folder):
    install(JUNIT_READERS, folder)
    (folder / "read.mjs").write_text(READ_JUNIT)
    read = json.loads(subprocess.run(["node", "read.mjs", "results.xml"], cwd=folder, check=True,
                                     stdout=subprocess.PIPE, text=True).stdout)
    results = json.loads((folder / "report/results.json").read_text())
    checks = results["checks"]
    count = {name: sum(check["status"] == name for check in checks)
             for name in ("failed", "new", "deleted", "error")}
    expected = [count["failed"] + count["new"] + count["deleted"], count["error"],
                len({check["test"] for check in checks})]
    assert read == [expected, expected], f"{read} {expected}"


def install(packages, folder):
    subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--silent", *packages],
                   cwd=folder, check=True)


def main():
    wrinkle, source, build, chromium = sys.argv[1:]
    folder = pathlib.Path(build) / "page"
    shutil.rmtree(folder / "graphs", ignore_errors=True)
    shutil.copytree(pathlib.Path(source) / "graphs", folder / "graphs")
    seed_errors(folder / "graphs")
    run = subprocess.run([wrinkle, "test", "graphs", "--ci", "--report", "report", "--junit",
                          "results.xml"], cwd=folder, stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE, text=True)
    assert run.returncode == 1, run.stdout
    page = folder / "report/index.html"
    html = page.read_text()
    for cause in ("output 'normal' (normal.normal)", "detail_texel.xy * 1.8",
                  "alu is 2", "most of it in", "no case reads this golden file",
                  "graphs/golden/marble.glsl does not exist yet", "the graph has no such output"):
        assert cause in html.replace("&quot;", '"'), cause
    start = time.monotonic()
    assert "Failed</h1>" in dump(chromium, page, ["--virtual-time-budget=1"])
    print(f"{page.stat().st_size / 1e6:.1f} MB, loaded in {time.monotonic() - start:.2f} s")
    keys = title_of(dump(chromium, with_script(html, KEYS, folder / "keys.html")))
    assert keys == "[1,true,1,2,3,4,5,0,2,1,1,true]", keys
    check_accessibility(chromium, html, folder)
    check_junit(folder)


main()
