"""Line coverage per folder from an lcov file: table.py FILE [-v]. Exit code 1: a folder is below its goal.

Counts are unions over the programs. After a fork both sides go on with one count, so that some of clang's
derived counts fall below zero, which it prints as huge numbers: executed.
"""
import collections, os, sys

GOALS = {"graders/engine": 85.0, "graders/box": 85.0, "graders/judges": 85.0, "graders/library": 85.0}
OTHERS = ("bench/measure", "graders/report", "graders/commands", "reference/mesh", "reference/formats")


def read(path):
    """{file: {line: executed}}"""
    lines, file = collections.defaultdict(dict), ""
    for text in open(path):
        if text.startswith("SF:"):
            file = os.path.relpath(text[3:].strip())
        elif text.startswith("DA:"):
            number, count = text[3:].split(",")[:2]
            lines[file][int(number)] = lines[file].get(int(number), False) or int(count) != 0
    return lines


def ranges(numbers):
    """[3, 4, 5, 9] as "3-5 9"."""
    text, start, last = [], None, None
    for number in [*sorted(numbers), None]:
        if number is None or last is None or number != last + 1:
            if start is not None:
                text.append(str(start) if start == last else f"{start}-{last}")
            start = number
        last = number
    return " ".join(text)


def main():
    lines, good = read(sys.argv[1]), True
    print(f"{'folder':24} {'lines':>7} {'executed':>9}")
    for folder in (*GOALS, *OTHERS):
        mine = {f: l for f, l in lines.items() if f.startswith(folder + "/")}
        count = sum(len(l) for l in mine.values())
        share = 100 * sum(sum(l.values()) for l in mine.values()) / count if count else 0.0
        below = share < GOALS.get(folder, 0)
        good &= not below
        print(f"{folder:24} {count:7} {share:7.1f} %{'  below the goal of %g %%' % GOALS[folder] if below else ''}")
        for file, own in sorted(mine.items()) if "-v" in sys.argv else ():
            missed = [n for n, executed in own.items() if not executed]
            print(f"    {file:44} {100 * (1 - len(missed) / len(own)):6.1f} %  {ranges(missed)}")
    sys.exit(0 if good else 1)


main()
