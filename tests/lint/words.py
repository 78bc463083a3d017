#!/usr/bin/env python3
"""lint.words ROOT: no path of one machine, and no promise of later work, in any file."""

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


def faults_of(root):
    faults = []
    for path in tree.files_of(root):
        text = None if path.name in OTHERS_TEXTS else tree.text_of(root, path)
        for number, line in enumerate((text or "").splitlines(), start=1):
            faults += [f"{path}:{number}: {what}: {line.strip()}"
                       for pattern, what in REFUSED if pattern.search(line)]
    return faults


if __name__ == "__main__":
    sys.exit(tree.report(faults_of(sys.argv[1])))
