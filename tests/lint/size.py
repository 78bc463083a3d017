#!/usr/bin/env python3
"""lint.size ROOT: hand-written files stay below 300 lines, the root at 20 visible entries."""

import sys

import tree

LINES_BELOW = 300
ROOT_ENTRIES_AT_MOST = 20
HAND_WRITTEN_SUFFIXES = {".h", ".cpp", ".py", ".cmake", ".txt", ".md", ".vert", ".frag", ".sh", ""}
WHOLE_TEXTS = {"LICENSE", "CHANGELOG.md"}


def faults_of(root):
    faults = []
    files = tree.files_of(root)
    for path in files:
        if path.suffix not in HAND_WRITTEN_SUFFIXES or path.name in WHOLE_TEXTS:
            continue
        text = tree.text_of(root, path)
        lines = len(text.splitlines()) if text is not None else 0
        if lines >= LINES_BELOW:
            faults.append(f"{path}: {lines} lines, and below {LINES_BELOW} is the rule")
    entries = sorted({path.parts[0] for path in files if not path.parts[0].startswith(".")})
    if len(entries) > ROOT_ENTRIES_AT_MOST:
        faults.append(f"root: {len(entries)} entries, and {ROOT_ENTRIES_AT_MOST} is the most: "
                      + " ".join(entries))
    return faults


if __name__ == "__main__":
    sys.exit(tree.report(faults_of(sys.argv[1])))
