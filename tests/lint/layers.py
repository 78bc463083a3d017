#!/usr/bin/env python3
"""lint.layers ROOT QT_HEADERS: the include table of docs/architecture.md, held against the tree.

QT_HEADERS is the folder that holds QtCore, QtGui and so on: it tells which module a Qt header is of.
"""

import pathlib
import re
import sys

import tree

TABLE = "docs/architecture.md"
HEADING = "## Who may include whom"
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
GENERATED = re.compile(r"^(?:[\w/]+\.moc|moc_\w+\.cpp|ui_\w+\.h)$")
CPP_HEADERS = set("""algorithm any array atomic barrier bit bitset charconv chrono cinttypes climits
clocale cmath compare complex concepts condition_variable coroutine cstddef cstdint cstdio cstdlib
cstring ctime deque exception execution filesystem format forward_list fstream functional future
initializer_list iomanip ios iosfwd iostream istream iterator latch limits list locale map memory
memory_resource mutex new numbers numeric optional ostream queue random ranges ratio regex semaphore
set shared_mutex source_location span sstream stack stdexcept stop_token streambuf string string_view
system_error thread tuple type_traits typeindex typeinfo unordered_map unordered_set utility valarray
variant vector version cassert cctype cerrno cfenv cfloat csetjmp csignal cstdarg""".split())
LIBRARY_OF_PREFIX = [
    ("Eigen/", "Eigen"), ("unsupported/Eigen/", "Eigen"), ("tl/", "tl::expected"),
    ("openvdb/", "OpenVDB"), ("tbb/", "TBB"), ("oneapi/tbb/", "TBB"), ("assimp/", "assimp"),
    ("meshoptimizer.h", "meshoptimizer"), ("argon2.h", "libargon2"), ("sodium", "libsodium"), ("unicode/", "ICU"), ("opencv2/", "OpenCV"),
    ("GL/", "OpenGL"), ("benchmark/", "Google Benchmark"),
    ("qrencode.h", "libqrencode"), ("png.h", "libpng"), ("turbojpeg.h", "libjpeg-turbo"),
    ("arpa/", "POSIX"), ("netinet/", "POSIX"), ("termios.h", "POSIX"), ("sys/", "POSIX"), ("unistd.h", "POSIX"), ("fcntl.h", "POSIX"), ("time.h", "POSIX"),
    ("dlfcn.h", "POSIX"), ("signal.h", "POSIX"), ("poll.h", "POSIX"), ("pthread.h", "POSIX"),
    ("malloc.h", "glibc"), ("jemalloc/", "jemalloc"), ("linux/", "Linux"), ("seccomp.h", "libseccomp"),
    ("boost/circular_buffer", "Boost.CircularBuffer"),
]


class Row:
    """What the files of one folder may include; None stands for everything."""

    def __init__(self, folder, folders, libraries):
        self.folder, self.folders, self.libraries = folder, folders, libraries


def rows_of(text):
    """The rows of the table, in its order. A table that cannot be read is a ValueError."""
    section = text.partition(HEADING)[2].partition("\n## ")[0]
    rows, above = [], []
    for line in section.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        folders = re.findall(r"`([^`]+)`", cells[0])
        if not line.startswith("|") or not folders:
            continue
        if len(cells) != 3:
            raise ValueError(f"{TABLE}: a row with {len(cells)} cells: {line}")
        allowed = re.findall(r"`([^`]+)`", cells[1]) + (above if "all above" in cells[1] else [])
        libraries = [name.strip() for name in cells[2].split(",")]
        rows += [Row(folder, None if cells[1] == "all" else set(allowed),
                     None if cells[2] == "all" else set(libraries)) for folder in folders]
        above = above + folders
    if not rows:
        raise ValueError(f"{TABLE}: no table under '{HEADING}'")
    return rows


def is_under(path, folder):
    return path == folder or path.startswith(folder + "/")


def row_of(path, rows):
    """The row of the deepest folder that holds the file."""
    fitting = [row for row in rows if is_under(path, row.folder)]
    return max(fitting, key=lambda row: len(row.folder), default=None)


def qt_modules(folder):
    """Which library each Qt header name belongs to."""
    modules = {}
    for module in sorted(pathlib.Path(folder).glob("Qt*")):
        library = "Qt3D" if module.name.startswith("Qt3D") else "Qt " + module.name[2:]
        modules[module.name] = library
        modules.update({header.name: library for header in module.iterdir()})
    return modules


def library_of(header, modules):
    """The library of an angle-bracket include: "" for the language's own, None where unknown."""
    if header in CPP_HEADERS:
        return ""
    if header.split("/")[0] in modules:
        return modules[header.split("/")[0]]
    return next((name for prefix, name in LIBRARY_OF_PREFIX if header.startswith(prefix)), None)


def fault_of_include(root, row, bracket, header, rows, modules):
    """What is wrong with one include, or None."""
    if bracket == "<":
        library = library_of(header, modules)
        if library is None:
            return "is of a library that tests/lint/layers.py does not know"
        allowed = library == "" or row.libraries is None or library in row.libraries
        return None if allowed else f"is of {library}, and the row of {row.folder} does not name it"
    if GENERATED.match(header):
        return None
    if not (pathlib.Path(root) / header).is_file():
        return "is not a path from the root of the project"
    target = row_of(header, rows)
    if target is None:
        return f"has no row in {TABLE}"
    if row.folders is None or target.folder == row.folder or target.folder in row.folders:
        return None
    return f"is in {target.folder}, and the row of {row.folder} does not name it"


def faults_of(root, qt_headers):
    try:
        rows = rows_of((pathlib.Path(root) / TABLE).read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        return [str(error)]
    modules = qt_modules(qt_headers)
    faults = []
    for path in map(str, tree.sources_of(root)):
        row = row_of(path, rows)
        if row is None:
            faults.append(f"{path}: its folder has no row in {TABLE}")
            continue
        text = tree.text_of(root, path) or ""
        for match in INCLUDE.finditer(text):
            fault = fault_of_include(root, row, match[1], match[2], rows, modules)
            if fault:
                line = text.count("\n", 0, match.start(1)) + 1
                faults.append(f"{path}:{line}: {match[2]} {fault}")
    return faults


if __name__ == "__main__":
    sys.exit(tree.report(faults_of(*sys.argv[1:3])))
