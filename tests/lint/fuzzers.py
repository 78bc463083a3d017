#!/usr/bin/env python3
"""lint.fuzzers ROOT: each fuzzer begins with seeds of its own and gets as many inputs as the others.

CONTRIBUTING.md has a command for each of tests/fuzz/fuzz_NAME.cpp, with the seeds that
tests/fuzz/seeds.cpp writes for it.
"""

import pathlib
import re
import sys

import tree

RUNS = "10000000"
PAGE = pathlib.PurePosixPath("CONTRIBUTING.md")
SEEDS = pathlib.PurePosixPath("tests/fuzz/seeds.cpp")
COMMAND = re.compile(r"^    build/fuzz/tests/fuzz/fuzz_(\w+)(.*)$", re.MULTILINE)


def faults_of(root):
    names = {path.stem.removeprefix("fuzz_") for path in tree.files_of(root)
             if path.match("tests/fuzz/fuzz_*.cpp")}
    commands = dict(COMMAND.findall(tree.text_of(root, PAGE)))
    written = tree.text_of(root, SEEDS)
    faults = [f"{PAGE}: there is no fuzz_{name}" for name in sorted(commands.keys() - names)]
    for name in sorted(names):
        if name not in commands:
            faults.append(f"{PAGE}: fuzz_{name} has no command")
            continue
        words = commands[name].split()
        if f"-runs={RUNS}" not in words:
            faults.append(f"{PAGE}: fuzz_{name} has{commands[name]}, not -runs={RUNS}")
        if f"build/fuzz/seeds/{name}" not in words:
            faults.append(f"{PAGE}: fuzz_{name} does not begin with build/fuzz/seeds/{name}")
        elif f'folder / "{name}"' not in written:
            faults.append(f"{SEEDS}: nothing is written for fuzz_{name}")
    return faults


if __name__ == "__main__":
    sys.exit(tree.report(faults_of(sys.argv[1])))
