#!/usr/bin/env python3
"""lint.rich_text ROOT: no screen takes a text for rich text.

Qt shows a text in a label, a tooltip or a message box as rich text where it looks like that, and
loads the pictures that it names: a participant's name could end a program. So labels are PlainLabel,
in Designer files those with the text format PlainText, and a tooltip is a fixed text or goes through
shownAsIs, as does the text of a message box.
"""

import re
import sys
import xml.etree.ElementTree as xml

import tree

SCREENS = {"apps", "models", "ui", "widgets"}
PLAIN_LABEL = "widgets/plain_label.h"
LABEL = re.compile(r"\bnew QLabel\b|\bQLabel\s+\w+\s*[;{(]|:\s*public QLabel\b")
TIP = re.compile(r"\b(?:setToolTip|setWhatsThis|setInformativeText)\(")
BOX = re.compile(r"\bQMessageBox&?\s+(\w+)|\b(\w+)\s*=\s*new QMessageBox\b")
TIP_ROLE = re.compile(r"==\s*Qt::(?:ToolTip|WhatsThis)Role[^;{]*?\)\s*return\s+([^;]*);")
FIXED = r'tr\((?:\s*"(?:[^"\\]|\\.)*")+\s*\)'
PLAIN = re.compile(rf"^(?:[^?\"]*\?)?\s*(?:{FIXED}|shownAsIs\(.*\))(?:\s*:\s*(?:{FIXED}|shownAsIs\(.*\)))?$",
                   re.DOTALL)


def argument_at(text, start):
    """What stands between the parenthesis before `start` and the one that closes it."""
    depth, quoted, i = 1, False, start
    while i < len(text):
        if quoted:
            i += text[i] == "\\"
            quoted = text[min(i, len(text) - 1)] != '"' or text[i - 1] == "\\"
        elif text[i] == '"':
            quoted = True
        elif text[i] in "()":
            depth += 1 if text[i] == "(" else -1
            if depth == 0:
                return text[start:i].strip()
        i += 1
    return text[start:].strip()


def source_faults(path, text):
    found = [] if str(path) == PLAIN_LABEL else [
        (match.start(), "a QLabel, not a PlainLabel") for match in LABEL.finditer(text)]
    starts = [match for match in TIP.finditer(text)]
    for box in BOX.finditer(text):
        name = box.group(1) or box.group(2)
        starts += re.finditer(rf"\b{name}(?:\.|->)setText\(", text)
    found += [(match.start(), "a text that may be taken for rich text") for match in starts
              if not PLAIN.match(argument_at(text, match.end()))]
    found += [(match.start(), "a tooltip that may be taken for rich text")
              for match in TIP_ROLE.finditer(text) if not PLAIN.match(match.group(1).strip())]
    return [f"{path}:{text.count(chr(10), 0, at) + 1}: {what}" for at, what in sorted(set(found))]


def designer_faults(path, text):
    return [f"{path}: the label {label.get('name')} is not PlainText"
            for label in xml.fromstring(text).iter("widget")
            if label.get("class") == "QLabel"
            and label.findtext("property[@name='textFormat']/enum") != "Qt::PlainText"]


def faults_of(root):
    faults = []
    for path in tree.files_of(root):
        if path.parts[0] not in SCREENS:
            continue
        if path.suffix == ".ui":
            faults += designer_faults(path, tree.text_of(root, path))
        elif path.suffix in tree.SOURCE_SUFFIXES:
            faults += source_faults(path, tree.text_of(root, path))
    return faults


if __name__ == "__main__":
    sys.exit(tree.report(faults_of(sys.argv[1])))
