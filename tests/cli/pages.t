#!/usr/bin/env python3
"""The pages of the sample class in headless Chromium: they load from file:// without an error, the 3D
views are not blank, and what students wrote stays text. Needs chromium; run from the top of the tree.

SAMPLE_REPORT names the program that writes the sample's report (default: the unit test, built here).
"""
import csv
import html.parser
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

PROGRAM = os.environ.get("SAMPLE_REPORT", "build/release/tests/unit/test_report_pages")
PNG = bytes.fromhex("89504e470d0a1a0a0000000d49484452000000010000000108020000009077" "53de0000000c4944415408d763"
                    "f8cfc000000301010018dd8db00000000049454e44ae426082")
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--enable-logging=stderr", "--virtual-time-budget=20000",
         "--window-size=1280,900"]

# Clicks like a person, and leaves what came of it on <html> for --dump-dom.
ACTIONS = """
"use strict";
window.addEventListener("load", function () {
  const root = document.documentElement;
  const headers = document.querySelectorAll("table.sortable thead th");
  const total = headers[headers.length - 1];
  const values = () => Array.from(document.querySelectorAll("table.sortable tbody tr"),
                                  (row) => row.cells[row.cells.length - 1].dataset.value).join(" ");
  total.querySelector("button").click();
  root.dataset.ascending = values();
  total.querySelector("button").click();
  root.dataset.descending = values();
  const shown = (language) => getComputedStyle(document.querySelector("h1 [lang=" + language + "]")).display !== "none";
  root.dataset.before = shown("en") + " " + shown("es");
  document.getElementById("language-es").click();
  root.dataset.after = shown("en") + " " + shown("es");
  root.dataset.label = document.querySelector(".scroll").getAttribute("aria-label");
});
"""

count = 0
failed = 0


def ok(passed, what, detail=""):
    global count, failed
    count += 1
    failed += not passed
    print("%sok %d - %s" % ("" if passed else "not ", count, what), flush=True)
    if not passed and detail:
        print("# " + str(detail)[:2000].replace("\n", "\n# "), flush=True)


class Page(html.parser.HTMLParser):
    """The elements of a page, each as (tag, {attribute: value}), and its text."""

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

    def root(self):
        return self.of("html")[0]


def browse(path, *flags):
    """The page after its scripts ran, and what the console said of errors."""
    with tempfile.TemporaryDirectory(prefix="meshgrade-chromium-") as profile:
        run = subprocess.run(["chromium", *FLAGS, *flags, "--user-data-dir=" + profile, "--dump-dom", "file://" + path],
                             stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=180, check=False)
    console = [line for line in run.stderr.decode(errors="replace").splitlines() if "CONSOLE" in line]
    errors = [line for line in console if "GL Driver Message" not in line and "deprecat" not in line.lower()]
    return Page(run.stdout.decode(errors="replace")), errors


def hostile_elements(page):
    """Elements that the report itself never writes."""
    ours = r"(\.\./|file:///\S*/)(assets|pictures)/[\w./-]+\.js|assets/page\.js"
    bad = [a for a in page.of("script") if not re.fullmatch(ours, a.get("src") or "")]
    bad += [a for tag, a in page.elements for name in a if name.startswith("on") or (name == "style" and tag != "canvas")]
    bad += [a for a in page.of("img") if not (a.get("src") or "").endswith(".png")]
    bad += [a for tag in ("iframe", "object", "embed", "form", "base") for a in page.of(tag)]
    return bad


def drawn(page):
    return [int(a["data-drawn"]) for tag, a in page.elements if "data-drawn" in a]


def look_at(path, what, *flags):
    page, errors = browse(path, *flags)
    ok(page.root().get("data-page") == "ready" and not errors, what + ": loads without console errors", errors)
    bad = hostile_elements(page)
    ok(not bad, what + ": what students wrote is no element", bad)
    return page


def test_class_page(out):
    page = look_at(out + "/index.html", "class page", "--accept-lang=en-GB")
    ok("<script>document.title=" in page.text and "owned" not in page.of("title"), "the hostile name is shown as text")
    ok(page.root().get("lang") == "en", "English by the browser's language")
    page, _ = browse(out + "/index.html", "--accept-lang=es-ES")
    ok(page.root().get("lang") == "es", "Spanish by the browser's language", page.root())


def test_clicks(out):
    with open(out + "/index.html", encoding="utf-8") as file:
        source = file.read()
    with open(out + "/acted.html", "w", encoding="utf-8") as file:
        file.write(source.replace("</head>", '<script src="assets/actions.js" defer></script></head>'))
    with open(out + "/assets/actions.js", "w", encoding="utf-8") as file:
        file.write(ACTIONS)
    page, errors = browse(out + "/acted.html", "--accept-lang=en-GB")
    root = page.root()
    ascending = [float(v) for v in root.get("data-ascending", "").split()]
    descending = [float(v) for v in root.get("data-descending", "").split()]
    ok(len(ascending) == 8 and ascending == sorted(ascending) and descending == sorted(ascending, reverse=True),
       "the table sorts by total, both ways", root)
    ok(root.get("data-before") == "true false" and root.get("data-after") == "false true",
       "the switch shows one language at a time", root)
    ok(root.get("data-label") == "Tabla de notas" and not errors, "and translates labels", (root, errors))


def test_views(out):
    page = look_at(out + "/students/bruno-conti.html#edge-table-any.disc", "mesh")
    ok(len(drawn(page)) >= 1 and min(drawn(page)) > 5000, "the 3D view of a mesh is not blank", drawn(page))
    page = look_at(out + "/students/ulises_ortega.html#memory-strips.strips-4x6", "strips")
    ok(len(drawn(page)) >= 1 and min(drawn(page)) > 5000, "the 3D view of strips is not blank", drawn(page))
    page = look_at(out + "/students/s3.html#memory-strips.voxels-12", "voxels")
    ok(len(drawn(page)) >= 1 and min(drawn(page)) > 5000, "the 3D view of voxels is not blank", drawn(page))
    ok(not [a for tag, a in page.elements if "data-failed" in a], "no view failed")


def test_hostile_student(out):
    page = look_at(out + "/students/s5.html", "the hostile student's page")
    ok("\x1b" not in page.text and "\u202e" not in page.text and "\\x1b[2J" in page.text, "their output is visible and inert")


def test_view_on_demand(out):
    """With a picture, a view opens only when it is asked for."""
    picture = out + "/pictures/ana-garcia/edge-table-any/disc.png"
    with open(picture, "wb") as file:
        file.write(PNG)
    shutil.copyfile(picture, picture.replace("disc", "grid-hole"))
    subprocess.run([PROGRAM, out], check=True)
    page, _ = browse(out + "/students/ana-garcia.html")
    ok(not drawn(page) and len(page.of("img")) == 2, "beside a picture no view opens by itself", drawn(page))
    page, _ = browse(out + "/students/ana-garcia.html#edge-table-any.disc")
    ok(len(drawn(page)) == 1 and drawn(page)[0] > 5000, "the page's address opens it", drawn(page))


def test_without_library(out):
    os.unlink(out + "/assets/three.min.js")
    page, _ = browse(out + "/students/bruno-conti.html#edge-table-any.disc")
    ok("The 3D view could not be shown here" in page.text, "without three.js the page says so and stays readable")


def test_exports(out):
    root = xml.etree.ElementTree.parse(out + "/junit").getroot()
    suites = root.findall("testsuite")
    right = all(int(suite.get(kind)) == len(suite.findall("testcase/" + tag)) for suite in suites
                for kind, tag in (("failures", "failure"), ("errors", "error"), ("skipped", "skipped")))
    right = right and all(int(suite.get("tests")) == len(suite.findall("testcase")) for suite in suites)
    ok(len(suites) == 22 and right, "junit is XML and counts right")
    with open(out + "/gradescope", encoding="utf-8") as file:
        ok(len(json.load(file)) == 8, "gradescope is JSON")
    with open(out + "/grades.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.reader(file, strict=True))
    ok(len(rows) == 9 and all(len(row) == 5 for row in rows), "grades.csv is CSV")


def main():
    if not shutil.which("chromium"):
        print("1..0 # SKIP chromium is not installed")
        return 0
    if not os.path.exists(PROGRAM):
        subprocess.run(["make", "-s", PROGRAM], check=True, stdout=sys.stderr)
    with tempfile.TemporaryDirectory(prefix="meshgrade-pages-") as out:
        for part in ("results", "pictures"):
            shutil.copytree("tests/unit/data/" + part, out + "/" + part)
        subprocess.run([PROGRAM, out], check=True)
        has_three = os.path.exists(out + "/assets/three.min.js")
        test_class_page(out)
        test_clicks(out)
        test_hostile_student(out)
        if has_three:
            test_views(out)
            test_view_on_demand(out)
            test_without_library(out)
        else:
            print("ok %d # SKIP libjs-three is not installed" % (count + 1))
        test_exports(out)
    print("1..%d" % (count if has_three else count + 1))
    return failed > 0


sys.exit(main())
