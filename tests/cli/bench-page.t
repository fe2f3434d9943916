#!/usr/bin/env python3
"""The page of a benchmark run in headless Chromium: it loads from file:// without an error, shows its
pictures, and texts of bench.json stay text. Needs chromium and the renderer; run from the top of the tree.
"""
import html.parser
import json
import os
import shutil
import subprocess
import sys
import tempfile

PROGRAM = os.environ.get("MESHGRADE", "build/meshgrade")
HOSTILE = "<script>document.title='owned'</script>\x1b[2J" + "long " * 400
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--enable-logging=stderr", "--virtual-time-budget=8000", "--window-size=1100,900"]
# What a person would see of each picture: whether it has loaded.
PROBE = """<script>window.addEventListener("load", function () {
  document.documentElement.dataset.loaded = Array.from(document.images).filter((i) => i.naturalWidth > 400).length;
  document.documentElement.dataset.wide = document.documentElement.scrollWidth;
});</script></head>"""

count = 0
failed = 0


def ok(passed, what, detail=""):
    global count, failed
    count += 1
    failed += not passed
    print("%sok %d - %s" % ("" if passed else "not ", count, what), flush=True)
    if not passed and detail:
        print("# " + str(detail)[:2000].replace("\n", "\n# "), flush=True)


def row(what, kind, subject, operation, mesh, triangles, ns, **more):
    spread = {"median": ns, "low": ns * .95, "high": ns * 1.05, "least": ns * .94}
    return {"what": what, "kind": kind, "subject": subject, "title": subject, "variant": "plain" if kind == "kernel" else "",
            "threads": 1, "operation": operation, "mesh": mesh, "mesh_kind": mesh.split("-")[0], "order": "generated",
            "triangles": triangles, "vertices": triangles // 2, "ns_per_triangle": spread, "blocks": 6, **more}


def run_of():
    """A made-up run that has something for every chart."""
    rows = []
    for size, triangles in (("10k", 10000), ("1M", 1000000)):
        mesh = "torus-%s-generated" % size
        for s, subject in enumerate(("half-edge", "winged-edge", HOSTILE)):
            for o, operation in enumerate(("build", "area", "edges")):
                rows.append(row("representations", "representation", subject, operation, mesh, triangles, 2 + s + 3 * o))
            rows.append(row("representations", "representation", subject, "bytes", mesh, triangles, 1,
                            bytes_per_triangle={"formula": 60, "measured": 60 + s}))
        rows.append(row("kernels", "kernel", "twins", "twins", mesh, triangles, 5,
                        limit={"bytes_per_triangle": 24, "gigabytes_per_second": 20, "fraction": .3}))
        rows.append(row("kernels", "peer", "CGAL", "twins", mesh, triangles, 50,
                        ratio={"to": "plain", "median": 10, "low": 9, "high": 11, "confidence": .97, "blocks": 6}))
    return {"schema": "meshgrade-bench-1", "version": "0.3", "date": "2026-11-22T12:00:00+0000", "mode": "full",
            "complete": True, "machine": {"cpu": HOSTILE, "cores": 2}, "noise": {"samples": 100, "dropped": 1},
            "meshes": [], "rows": rows,
            "claims": [{"name": "n", "source": "000", "claim": HOSTILE, "mesh": "m", "claimed": 2, "measured": 1.9, "holds": True}],
            "accesses": [{"subject": "a", "title": HOSTILE, "query": "is-edge", "claim": HOSTILE, "growth": "n", "holds": False,
                          "by_size": [{"triangles": 2048, "accesses": 13.5}, {"triangles": 8192, "accesses": 54}],
                          "by_valence": [{"valence": 4, "accesses": 9}, {"valence": 256, "accesses": 513}]}]}


class Page(html.parser.HTMLParser):
    def __init__(self, source):
        super().__init__()
        self.elements, self.text = [], ""
        self.feed(source)

    def handle_starttag(self, tag, attributes):
        self.elements.append((tag, dict(attributes)))

    def handle_data(self, data):
        self.text += data

    def of(self, tag):
        return [attributes for name, attributes in self.elements if name == tag]


def browse(path):
    with tempfile.TemporaryDirectory(prefix="meshgrade-chromium-") as profile:
        run = subprocess.run(["chromium", *FLAGS, "--user-data-dir=" + profile, "--dump-dom", "file://" + path],
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=180, check=False)
    console = [line for line in run.stderr.decode(errors="replace").splitlines() if "CONSOLE" in line]
    return Page(run.stdout.decode(errors="replace")), console


def look_at(out, has_pictures):
    with open(out + "/index.html", encoding="utf-8") as file:
        source = file.read()
    with open(out + "/probed.html", "w", encoding="utf-8") as file:
        file.write(source.replace("</head>", PROBE))
    page, console = browse(out + "/probed.html")
    root = page.of("html")[0]
    ok(not console and page.of("h1"), "the page loads without console errors", console)
    ok("<script>document.title=" in page.text and not [a for a in page.of("script") if a] and len(page.of("script")) == 1,
       "hostile texts of the run are text")
    ok(float(root.get("data-wide", "9999")) <= 1100, "and do not stretch the page", root)
    outside = [a for tag, a in page.elements for key in ("src", "href") if ":" in (a.get(key) or "")]
    ok(not outside, "nothing is loaded from elsewhere", outside)
    if has_pictures:
        ok(int(root.get("data-loaded", "0")) == len(page.of("img")) == 12, "all twelve pictures are shown", root)


def main():
    if not shutil.which("chromium"):
        print("1..0 # SKIP chromium is not installed")
        return 0
    with tempfile.TemporaryDirectory(prefix="meshgrade-bench-page-") as out:
        with open(out + "/bench.json", "w", encoding="utf-8") as file:
            json.dump(run_of(), file)
        run = subprocess.run([PROGRAM, "bench", "--page", out], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        said = run.stderr.decode()
        ok(run.returncode == 0 and "index.html" in said, "bench --page writes the page", said)
        look_at(out, "pictures were not drawn" not in said)
        with open(out + "/bench.json", "w", encoding="utf-8") as file:
            json.dump({"schema": "other"}, file)
        run = subprocess.run([PROGRAM, "bench", "--page", out], stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False)
        ok(run.returncode == 2 and b"no results of a bench run" in run.stderr, "other JSON is refused", run.stderr)
    print("1..%d" % count)
    return failed > 0


sys.exit(main())
