#!/usr/bin/env python3
"""docs.protocol: docs/protocol.md has the version and the records of the code.

    tests/docs/protocol.py ROOT
"""

import pathlib
import re
import sys

VERSION = r"kProtocolVersion = (\d+);"
KINDS = r"enum class RecordKind : std::uint8_t \{\n    (\w+) = 1,\n((?:    \w+,\n)*)\};"


def version_of(header):
    return int(re.search(VERSION, header)[1])


def records_of(source):
    """Their names, that of kind 1 first."""
    first, others = re.search(KINDS, source).groups()
    return [first, *re.findall(r"\w+", others)]


def faults_of(page, version, records):
    faults = []
    for what, pattern in (("the first paragraph", r"^What Carina programs say .*?, version (\d+)\."),
                          ("the header", r"^\| 2 \| version \| u8 \| (\d+) \|")):
        said = re.findall(pattern, page, re.MULTILINE)
        if said != [str(version)]:
            faults.append(f"{what} says version {' and '.join(said) or 'nothing'}, the code {version}")
    listed = re.findall(r"^\| (\d+) \| (\w+) \| (?:host|client|both) \|", page, re.MULTILINE)
    if listed != [(str(kind), name) for kind, name in enumerate(records, start=1)]:
        faults.append(f"the records are {', '.join(records)}; listed are {listed}")
    described = set()
    for first, last, names in re.findall(r"^### (\d+)(?: to (\d+))?(?: (\w+))?$", page, re.MULTILINE):
        described |= set(range(int(first), int(last or first) + 1))
        if names and records[int(first) - 1] != names:
            faults.append(f"the heading of {first} is of {names}")
    missing = set(range(1, len(records) + 1)) ^ described
    if missing:
        faults.append(f"headings and records differ in the kinds {sorted(missing)}")
    return faults


def main(root):
    wire = root / "engine/sync/wire"
    faults = faults_of((root / "docs/protocol.md").read_text(encoding="utf-8"),
                       version_of((wire / "datagram.h").read_text(encoding="utf-8")),
                       records_of((wire / "record_codec.cpp").read_text(encoding="utf-8")))
    for fault in faults:
        print(f"docs/protocol.md: {fault}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
