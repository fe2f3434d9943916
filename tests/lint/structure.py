#!/usr/bin/env python3
"""Checks the structure that no compiler looks at; a part of `make lint`.

- A tag (struct, union, enum) is defined in one header only.
- Folders include each other in one direction: no circle, counted over all sources and headers.
- A file has at most 600 lines; new files count as those that git knows.
- Nothing under graders reads a folder by a pattern.

Prints a line a finding, with file and remedy, and exits 1 when there is any.
"""
import os
import re
import subprocess
import sys

FILE_LINES = 600
SOURCE = re.compile(r"\.(c|h|cpp|hpp)$")
# What students read or hand in, and programs that are meant to break rules.
NOT_OURS = re.compile(r"^(exercises|tests/submissions|tests/hostile|reference/answers)/")
TAG = re.compile(r"^\s*(?:typedef\s+)?(struct|union|enum(?:\s+class)?)\s+(\w+)\s*(?::\s*\w+\s*)?\{", re.M)
INCLUDE = re.compile(r'^#include "([^"]+)"', re.M)
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.S)
PATTERN_CALL = re.compile(r"\b(glob|wordexp)(64)?\s*\(")


def sources():
    """All C and C++ files of the tree, those that git does not know yet too."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], capture_output=True,
                            text=True, check=True).stdout.split("\n")
    return sorted(f for f in set(listed) if SOURCE.search(f) and os.path.exists(f) and not NOT_OURS.search(f))


def tag_findings(texts):
    homes = {}
    for path, text in texts.items():
        if path.endswith((".h", ".hpp")):
            language = "C++" if path.endswith(".hpp") else "C"
            for kind, tag in TAG.findall(COMMENT.sub("", text)):
                homes.setdefault((language, tag), []).append(path)
    for (language, tag), paths in sorted(homes.items()):
        if len(paths) > 1 and language == "C":
            yield f"{paths[1]}: tag '{tag}' is defined in {paths[0]} too: give one of them another name"


def room(path):
    """The folder of a file, as deep as it is split: graders/engine/run, bench/measure, ..."""
    return os.path.dirname(path)


def circle_findings(texts):
    arrows = {}
    for path, text in texts.items():
        for included in INCLUDE.findall(text):
            if included in texts and room(included) != room(path):
                arrows.setdefault(room(path), {}).setdefault(room(included), path)
    state, trail = {}, []

    def visit(at):
        state[at] = "open"
        trail.append(at)
        for to in sorted(arrows.get(at, {})):
            if state.get(to) == "open":
                ring = trail[trail.index(to):] + [to]
                found.append(" -> ".join(ring) + f": a circle of folders; {arrows[at][to]} closes it: "
                             "move what both need into a folder of its own")
            elif to not in state:
                visit(to)
        trail.pop()
        state[at] = "done"

    found = []
    for folder in sorted(arrows):
        if folder not in state:
            visit(folder)
    return found


def length_findings(texts):
    for path, text in texts.items():
        lines = text.count("\n")
        if lines > FILE_LINES:
            yield f"{path}: {lines} lines, {FILE_LINES} at most: is it more than one idea?"


def pattern_findings(texts):
    for path, text in texts.items():
        if path.startswith("graders/") and PATTERN_CALL.search(COMMENT.sub("", text)):
            yield f"{path}: a path is no pattern: read a folder by reference/base/listing.h"


def main():
    texts = {path: open(path, encoding="utf-8").read() for path in sources()}
    findings = [f for check in (tag_findings, circle_findings, length_findings, pattern_findings)
                for f in check(texts)]
    for finding in findings:
        print("structure:", finding, file=sys.stderr)
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
