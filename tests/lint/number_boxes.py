#!/usr/bin/env python3
"""lint.number_boxes ROOT: a number that is typed outside its range is refused, not changed.

QSpinBox and QDoubleSpinBox drop the digits that do not fit: 720 typed into a box that ends at 360
becomes 72. The screens take CheckedSpinBox and CheckedDoubleSpinBox.
"""

import re
import sys
import xml.etree.ElementTree as xml

import tree

PLAIN = {"QSpinBox", "QDoubleSpinBox"}
MADE = re.compile(r"\bnew Q(?:Double)?SpinBox\b|\bmake_unique<Q(?:Double)?SpinBox>"
                  r"|(?:^|[\s(,])Q(?:Double)?SpinBox\s+\w+\s*[;{(]", re.MULTILINE)


def faults_of(root):
    faults = []
    for path in tree.files_of(root):
        text = tree.text_of(root, path) if path.parts[0] == "ui" else None
        if text is None:
            continue
        if path.suffix == ".ui":
            faults += [f"{path}: {box.get('name')} is a {box.get('class')}, not a checked box"
                       for box in xml.fromstring(text).iter("widget") if box.get("class") in PLAIN]
        elif path.suffix in tree.SOURCE_SUFFIXES:
            faults += [f"{path}:{text.count(chr(10), 0, made.start()) + 1}: a box of Qt, not a checked one"
                       for made in MADE.finditer(text)]
    return faults


if __name__ == "__main__":
    sys.exit(tree.report(faults_of(sys.argv[1])))
