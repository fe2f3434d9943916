"""Writes one line a result with its marks, and one with its counts.

usage: stability_facts.py RESULTS MARKS COUNTS

A result is RESULTS/<student>/<exercise>.json. Its layers of protection are left out, which differ
between root and a plain user; everything else must not differ.
"""
import json
import pathlib
import sys

results, marks, counts = sys.argv[1:]
with open(marks, "w") as marks_file, open(counts, "w") as counts_file:
    for path in sorted(pathlib.Path(results).glob("*/*.json")):
        result = json.loads(path.read_text())
        result.pop("protections")
        name = "/".join(path.parts[-2:])
        measures = result.pop("measures")
        print(name, json.dumps(result, sort_keys=True), file=marks_file)
        print(name, json.dumps(measures, sort_keys=True), file=counts_file)
