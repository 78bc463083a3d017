"""What every lint shares: the files of the tree, and how a fault is told."""

import pathlib
import subprocess
import sys

SOURCE_SUFFIXES = {".h", ".cpp"}
NOT_OURS = {".git", "build", "out"}


def files_of(root):
    """Paths relative to the root: what git tracks, or every file where there is no git."""
    root = pathlib.Path(root)
    if (root / ".git").exists():
        # In a container the tree may belong to another user, and git refuses to list it unasked.
        git = ["git", "-c", "safe.directory=*", "-C", str(root)]
        listed = subprocess.run([*git, "ls-files", "-z"], check=True, capture_output=True,
                                text=True).stdout.split("\0")
        paths = [pathlib.PurePosixPath(name) for name in listed if name]
    else:
        paths = [pathlib.PurePosixPath(path.relative_to(root).as_posix())
                 for path in sorted(root.rglob("*")) if path.is_file()]
        paths = [path for path in paths if path.parts[0] not in NOT_OURS]
    return [path for path in paths if (root / path).is_file()]


def sources_of(root):
    return [path for path in files_of(root) if path.suffix in SOURCE_SUFFIXES]


def text_of(root, path):
    """The file as text, or None where it is not text."""
    try:
        return (pathlib.Path(root) / path).read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return None


def report(faults):
    """Prints each fault on its line and returns the exit status."""
    for fault in faults:
        print(fault)
    if faults:
        print(f"{len(faults)} faults", file=sys.stderr)
    return 1 if faults else 0
