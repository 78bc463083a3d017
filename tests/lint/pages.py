#!/usr/bin/env python3
"""lint.pages ROOT: a link of a page (*.md) leads to a file or folder of the tree, and its anchor to a
heading that stands there once."""

import collections
import pathlib
import posixpath
import re
import sys

import tree

LINK = re.compile(r"\[[^\]\[]*\]\(([^)\s]+)\)")
CODE = re.compile(r"`[^`]*`")
ELSEWHERE = re.compile(r"^[a-z]+:")
IN_HEADING = re.compile(r"\[([^\]]*)\]\([^)]*\)|[`*]")


def prose_of(text):
    """The lines of a page that are not code: (number, line)."""
    is_fenced = False
    for number, line in enumerate(text.splitlines(), start=1):
        if line.startswith("```"):
            is_fenced = not is_fenced
        elif not is_fenced and not line.startswith("    "):
            yield number, line


def anchor_of(heading):
    """As GitHub makes it of a heading."""
    words = IN_HEADING.sub(lambda match: match[1] or "", heading).strip().lower()
    return re.sub(r"[^\w\- ]", "", words).replace(" ", "-")


def anchors_of(text):
    """How often each anchor is that of a heading."""
    return collections.Counter(anchor_of(line.lstrip("#")) for _, line in prose_of(text)
                               if re.match(r"#{1,6} ", line))


def fault_of(link, page, files, anchors):
    """What is wrong with a link of a page, or None."""
    path, _, anchor = link.partition("#")
    target = posixpath.normpath(str(page.parent / path)) if path else str(page)
    if target not in files:
        return "no such file"
    if not anchor:
        return None
    if target not in anchors:
        return "an anchor in what is no page"
    count = anchors[target][anchor]
    return None if count == 1 else f"{count} headings have this anchor"


def faults_of(root):
    paths = tree.files_of(root)
    files = {str(path) for path in paths} | {str(folder) for path in paths for folder in path.parents}
    texts = {path: tree.text_of(root, path) for path in paths if path.suffix == ".md"}
    anchors = {str(path): anchors_of(text) for path, text in texts.items()}
    faults = []
    for page, text in texts.items():
        for number, line in prose_of(text):
            for link in LINK.findall(CODE.sub("", line)):
                fault = None if ELSEWHERE.match(link) else fault_of(link, pathlib.PurePosixPath(page),
                                                                    files, anchors)
                if fault:
                    faults.append(f"{page}:{number}: {link}: {fault}")
    return faults


if __name__ == "__main__":
    sys.exit(tree.report(faults_of(sys.argv[1])))
