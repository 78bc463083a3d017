#!/usr/bin/env python3
"""lint.size ROOT: names what has grown large, and holds the root at 20 visible entries.

The length of a file and the number of files in a folder are a matter of judgement: the longest files
are listed, long files and full folders are warned of, and neither fails.
"""

import collections
import sys

import tree

LISTED = 10
WARNED_LINES = 400
WARNED_FILES = 32  # in one folder
ROOT_ENTRIES_AT_MOST = 20
HAND_WRITTEN_SUFFIXES = {".h", ".cpp", ".py", ".cmake", ".txt", ".md", ".vert", ".frag", ".bash", ".ui", ".qss", ""}
WHOLE_TEXTS = {"LICENSE", "CHANGELOG.md"}


def lengths_of(root):
    """(lines, path) of the hand-written files, longest first."""
    lengths = []
    for path in tree.files_of(root):
        if path.suffix in HAND_WRITTEN_SUFFIXES and path.name not in WHOLE_TEXTS:
            text = tree.text_of(root, path)
            lengths.append((len(text.splitlines()) if text is not None else 0, str(path)))
    return sorted(lengths, key=lambda each: (-each[0], each[1]))


def warnings_of(root):
    warnings = [f"{path}: {lines} lines: does it say one thing?"
                for lines, path in lengths_of(root) if lines >= WARNED_LINES]
    counts = collections.Counter(str(path.parent) for path in tree.files_of(root))
    warnings += [f"{folder}: {count} files: are there rooms in it?"
                 for folder, count in sorted(counts.items()) if count > WARNED_FILES]
    return warnings


def faults_of(root):
    entries = sorted({path.parts[0] for path in tree.files_of(root)
                      if not path.parts[0].startswith(".")})
    if len(entries) <= ROOT_ENTRIES_AT_MOST:
        return []
    return [f"root: {len(entries)} entries, and {ROOT_ENTRIES_AT_MOST} is the most: "
            + " ".join(entries)]


if __name__ == "__main__":
    print("The longest files:")
    for count, name in lengths_of(sys.argv[1])[:LISTED]:
        print(f"{count:5} {name}")
    for warning in warnings_of(sys.argv[1]):
        print(f"warning: {warning}")
    sys.exit(tree.report(faults_of(sys.argv[1])))
