#!/usr/bin/env python3
"""lint.words ROOT: no path of one machine, and no promise of later work, in any file; no number of
a station in a program, because stations follow from the session."""

import re
import sys

import tree

# Written with a class each, so that this file does not contain what it refuses.
REFUSED = [
    (re.compile(r"(?<![\w.])/(?:[h]ome|[r]oot|[w]ork|[U]sers)/[\w.]"), "a path of one machine"),
    (re.compile(r"\b[A-Z]:\\[U]sers\\"), "a path of one machine"),
    (re.compile(r"\b(?:[T]ODO|[F]IXME|[X]XX)\b"), "a promise of later work"),
]
OTHERS_TEXTS = {"LICENSE"}
STATION_NUMBER = (re.compile(r"\bStationId(?:\s+\w+)?\s*[({]\s*\d"), "the number of a station")
PROGRAMS = {"apps", "ui", "models", "evaluation"}


def refused_in(path):
    is_program = path.parts[0] in PROGRAMS or path.parts[:2] == ("engine", "net")
    return REFUSED + [STATION_NUMBER] if is_program else REFUSED


def faults_of(root):
    faults = []
    for path in tree.files_of(root):
        text = None if path.name in OTHERS_TEXTS else tree.text_of(root, path)
        for number, line in enumerate((text or "").splitlines(), start=1):
            faults += [f"{path}:{number}: {what}: {line.strip()}"
                       for pattern, what in refused_in(path) if pattern.search(line)]
    return faults


if __name__ == "__main__":
    sys.exit(tree.report(faults_of(sys.argv[1])))
