#!/usr/bin/env python3
"""lint.format ROOT: every C++ file is as clang-format 14 writes it, and Python can read every Python
file.

Another version formats a few constructs in another way, so C++ is then skipped (status 77)."""

import pathlib
import re
import shutil
import subprocess
import sys

import tree

VERSION = "14"
SKIPPED = 77


def formatter():
    """The clang-format of that version, or None."""
    for name in (f"clang-format-{VERSION}", "clang-format"):
        program = shutil.which(name)
        if program is None:
            continue
        version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout
        if re.search(rf"version {VERSION}\.", version):
            return program
    return None


def faults_of(root, program):
    paths = [str(pathlib.Path(root) / path) for path in tree.sources_of(root)]
    if not paths:
        return []
    run = subprocess.run([program, "--dry-run", "-Werror", "--style=file", *paths],
                         capture_output=True, text=True)
    faulty = sorted(set(re.findall(r"^(\S+?):\d+:\d+: error", run.stderr, re.MULTILINE)))
    if run.returncode and not faulty:
        return [run.stderr.strip()]
    return [f"{path}: not formatted: clang-format -i {path}" for path in faulty]


def unreadable_of(root):
    """The Python files that Python cannot read."""
    faults = []
    for path in tree.files_of(root):
        text = tree.text_of(root, path) or "" if path.suffix in (".py", "") else ""
        if path.suffix != ".py" and not text.startswith("#!/usr/bin/env python3"):
            continue
        try:
            compile(text, str(path), "exec")
        except (SyntaxError, ValueError) as error:
            faults.append(f"{path}: Python cannot read it: {error}")
    return faults


if __name__ == "__main__":
    if unreadable := unreadable_of(sys.argv[1]):
        sys.exit(tree.report(unreadable))
    found = formatter()
    if found is None:
        print(f"skipped: there is no clang-format {VERSION} here")
        sys.exit(SKIPPED)
    sys.exit(tree.report(faults_of(sys.argv[1], found)))
