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
         "--virtual-time-budget=10000", *flags, "--dump-dom",
         page if isinstance(page, str) else page.as_uri()],
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
  const pictured = checks.find((check) => check.id === 'graphs/base_and_detail/render');
  select(pictured);
  setTimeout(() => {
    const view = viewers.get(pictured);
    const tabs = [...pictured.querySelectorAll('[role=tab]')];
    for (const key of ['2', '3', '4', '5', '6']) {
      press(key);
      seen.push(tabs.findIndex((tab) => tab.getAttribute('aria-selected') === 'true'));
    }
    seen.push(location.hash.includes('v=map'));
    press('1');
    press('+');
    seen.push(view.zoom);
    view.panel.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowRight', bubbles: true}));
    seen.push(view.pan[0]);
    seen.push(new Set(view.images.map((image) => image.style.transform)).size);
    press('f');
    seen.push(view.zoom);
    tabs[0].focus();
    press('ArrowLeft');
    seen.push(view.view, document.activeElement === tabs[5]);
    seen.push(view.text_at(64, 64).split('   ').map((text) => text.split(' ')[0]).join());
    seen.push(pictured.querySelector('.scale p').textContent.includes('degrees'));
    has_keys.checked = false;
    press('1');
    seen.push(view.view);
    has_keys.checked = true;
    search.value = 'rusty_steel/budget';
    search.dispatchEvent(new Event('input'));
    seen.push(shown_checks().length);
    seen.push(location.hash.includes('rusty_steel'));
    select(shown_checks()[0]);
    press('a');
    seen.push(accept.textContent.includes('budget'));
    search.value = '!graphs';
    search.dispatchEvent(new Event('input'));
    seen.push(shown_checks().length, document.querySelector('#none').hidden);
    document.title = JSON.stringify(seen);
  }, 500);
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


def check_without_script(chromium, html, folder):
    """Messages, lines and images are elements without scripts too: in a frame that has none."""
    count = """const frame = document.querySelector('iframe');
        frame.onload = () => document.title = ['.source', '.frame img', 'mark'].map(
            (part) => frame.contentDocument.querySelectorAll('noscript ' + part).length > 0);
        frame.srcdoc = TEXT;""".replace("TEXT", json.dumps(html).replace("<", "\\u003c"))
    page = folder / "frame.html"
    page.write_text(f"<iframe sandbox='allow-same-origin'></iframe><script>{count}</script>")
    dom = dump(chromium, page)
    assert title_of(dom) == "true,true,true", title_of(dom)


def check_link(chromium, page):
    """A link shows a check in a view, and the filters."""
    link = page.as_uri() + "#q=weave&s=failed&c=graphs/base_and_detail/render&v=swipe"
    dom = dump(chromium, link)
    check = re.search(r'<details [^>]*id="graphs/base_and_detail/render"[^>]*>', dom).group(0)
    assert " open=" in check and "current" in check, check
    assert re.search(r'aria-selected="true"[^>]*>Swipe<', dom)
    assert re.search(r'data-status="deleted" aria-pressed="false"', dom)


def multiplied(folder, name, count, kind=None):
    """Returns the folder of a report with that many checks which are not passed."""
    results = json.loads((folder / "report/results.json").read_text())
    checks = [check for check in results["checks"]
              if check["status"] != "passed" and kind in (None, check["kind"])]
    results["checks"] = [dict(checks[i % len(checks)], test=f"case_{i // 2}", name=f"check_{i}")
                         for i in range(count)]
    shutil.rmtree(folder / name, ignore_errors=True)
    shutil.copytree(folder / "report", folder / name)
    (folder / name / "results.json").write_text(json.dumps(results))
    return folder / name


LOADED = """addEventListener('load', () => setTimeout(() => {
  const time = performance.getEntriesByType('navigation')[0].loadEventEnd;
  const start = performance.now();
  search.value = 'check_1';
  search.dispatchEvent(new Event('input'));
  document.body.offsetHeight;
  const filtered = performance.now();
  select(shown_checks().at(-1));
  document.body.offsetHeight;
  document.title = [checks.length, shown_checks().length > 0, viewers.size < 3, current !== null,
      Math.round(time), Math.round(filtered - start), Math.round(performance.now() - filtered)].join();
}, 100));"""


def check_sizes(chromium, wrinkle, folder):
    """Large reports are within the size, and checks are elements only where they are seen."""
    for name, count, kind in (("images", 300, "image"), ("many", 10000, None)):
        shard = multiplied(folder, name, count, kind)
        subprocess.run([wrinkle, "test", "--merge", shard, "--report", folder / (name + "_merged")],
                       stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        page = folder / (name + "_merged") / "index.html"
        size = page.stat().st_size
        assert size <= 32 << 20, size
        html = page.read_text()
        found = title_of(dump(chromium, with_script(html, LOADED, folder / "large.html")))
        assert found.startswith(f"{count},true,true,true,"), found
        load, search, select = found.split(",")[4:]
        print(f"{count} checks, {size / 1e6:.1f} MB: loaded in {load} ms, "
              f"search {search} ms, next {select} ms")


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
    assert keys == ('[1,true,1,2,3,4,5,true,2,40,1,1,5,true,"64,,expected,actual,about,map",true,5,'
                    '1,true,false,0,false]'), keys
    check_without_script(chromium, html, folder)
    check_link(chromium, page)
    check_sizes(chromium, wrinkle, folder)
    check_accessibility(chromium, html, folder)
    check_junit(folder)


main()
