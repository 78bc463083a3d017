#!/usr/bin/env python3
"""lint.links PROGRAM...: no program loads Qt 5 or opencv_highgui, and none misses a library."""

import re
import subprocess
import sys

import tree

REFUSED = re.compile(r"^\s*(libQt5\S*|libopencv_highgui\S*)", re.MULTILINE)
MISSING = re.compile(r"^\s*(\S+) => not found", re.MULTILINE)


def faults_in(program, listing):
    """Faults in what ldd says of a program."""
    faults = [f"{program}: loads {name}" for name in REFUSED.findall(listing)]
    return faults + [f"{program}: {name} is not there" for name in MISSING.findall(listing)]


def faults_of(program):
    run = subprocess.run(["ldd", program], capture_output=True, text=True)
    if run.returncode:
        return [f"{program}: ldd: {run.stderr.strip() or run.stdout.strip()}"]
    return faults_in(program, run.stdout)


if __name__ == "__main__":
    sys.exit(tree.report([fault for program in sys.argv[1:] for fault in faults_of(program)]))
