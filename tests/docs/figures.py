#!/usr/bin/env python3
"""Re-runs the commands of a page of docs and compares their output with the figures on the page.

    tests/docs/figures.py BUILD PAGE...           PAGE as in figures/PAGE.json: patient
    tests/docs/figures.py --write BUILD PAGE...   writes what the commands give now into the page
    tests/docs/figures.py --uncovered             lists figures that no command holds
    tests/docs/figures.py --places                looks whether each page has the commands, words
                                                  and tables of its list; runs nothing

A table, figures/PAGE.json, has the page's path and a list of runs:

    command    as it stands in the page; `./carina lab` and `carina-lab` are the same
    with       options that replace or follow those of the command
    figures    a list of {"words", "at"}: the words of the page with {} for each figure, and where
               each stands in the output
    grid       instead of figures: {"header", "rows", "columns"}, the first line of a table of the
               page and what each row and column adds to "with"; "at" holds for every cell
    display    true for what draws
    data       the folder below the real data that it needs
    not_run    why the command is not run again; its words must stand in the page all the same

A place in the output is a path in its JSON (`cases[file=a.csv].ratio`, `levels[0]`), or a regular
expression between slashes with one group, of any line or of those that match another expression:
`/([\\d.]+) mm/ in /four landmarks/`. `max(...)` and `min(...)` take one value of several
(`max(levels[*].ml)`); `1000*` before a place converts the unit. A figure is compared at the
rounding at which the page quotes it.

Real data are below CARINA_TEST_DATA, or ../shared/data beside the project. A run whose data are
missing is named as skipped.
"""

import concurrent.futures
import contextlib
import decimal
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = pathlib.Path(__file__).resolve().parent / "figures"
FIGURE = r"[-+]?\d+(?:,\d{3})*(?:\.\d+)?(?:e-?\d+)?"
UNIT = re.compile(r"(?<![\w.])\d[\d.,]*(?:e-?\d+)? ?(?:%|°|(?:mm|cm|m|ml|l|L|ms|s|us|ns|min|deg|degrees|"
                  r"MB|MB/s|kbit/s|bytes/s|frames/s|cmH2O|ml/kg)\b)")
COMMAND = re.compile(r"carina[- ]lab|\./carina (?:lab|bench|demo|test)|build/release/|ctest ")
SKIPPED = 77


class Fault(Exception):
    """What does not agree between page, table and program."""


def load(page):
    return json.loads((TABLES / f"{page}.json").read_text(encoding="utf-8"))


def one_line(text):
    """A command continued over lines as one line."""
    return re.sub(r"\s*\\\n\s*", " ", text)


def said(command):
    return command.replace("./carina lab ", "carina-lab ")


def joined(command, *extras):
    """The command with options replaced, or appended where it does not have them."""
    words = shlex.split(command)
    for extra in extras:
        more = shlex.split(extra)
        while more:
            option = more.pop(0)
            value = [more.pop(0)] if more and not more[0].startswith("--") else []
            if option.startswith("--") and option in words:
                at = words.index(option) + 1
                has_value = at < len(words) and not words[at].startswith("--")
                words[at:at + has_value] = value
            else:
                words += [option, *value]
    return " ".join(map(shlex.quote, words))


# Where a figure stands

def find_words(text, words):
    """The figures that stand in place of {} in the words, and their places in the page."""
    pattern = f"({FIGURE})".join(re.escape(part) for part in words.split("{}"))
    matches = list(re.finditer(pattern, text))
    if len(matches) != 1:
        raise Fault(f"the page has these words {len(matches)} times, not once: {words}")
    match = matches[0]
    return [(match[i], match.span(i)) for i in range(1, match.re.groups + 1)]


def cells_of(text, header):
    """{(row, column): (text, offset)} of the table whose first line starts with the header."""
    begin = text.find("\n" + header)
    if begin < 0 or text.count("\n" + header) != 1:
        raise Fault(f"no single table of the page begins with: {header}")
    lines, offset, columns, cells = text[begin + 1:].split("\n\n")[0].split("\n"), begin + 1, [], {}
    for number, line in enumerate(lines):
        at, row = offset, []
        for part in line.split("|"):
            row.append((part.strip(), at + len(part) - len(part.lstrip())))
            at += len(part) + 1
        row = row[1:-1]
        if number == 0:
            columns = [name for name, _ in row]
        elif number > 1 and row:
            cells.update({(row[0][0], column): cell for column, cell in zip(columns, row)})
        offset += len(line) + 1
    return cells


def checks_of(table, text):
    """(run, command, words, [(figure, span)], places) for everything that the table lists."""
    for run in table["runs"]:
        if said(run["command"]) not in said(one_line(text)):
            raise Fault(f"the page does not have the command: {run['command']}")
        extra = run.get("with", "")
        if not run.get("figures") and "grid" not in run:
            yield run, joined(run["command"], extra), "", [], []
        for entry in run.get("figures", []):
            found, at = find_words(text, entry["words"]), entry.get("at", [])
            at = [at] if isinstance(at, str) else at
            if len(at) != len(found) and "not_run" not in run:
                raise Fault(f"{len(found)} figures but {len(at)} places of output: {entry['words']}")
            yield {**run, **entry}, joined(run["command"], extra), entry["words"], found, at
        if "grid" in run:
            yield from checks_of_grid(run, extra, text)


def checks_of_grid(run, extra, text):
    grid, places = run["grid"], run.get("at", [])
    cells = cells_of(text, grid["header"])
    for row, by_row in grid["rows"].items():
        for column, by_column in grid["columns"].items():
            if (row, column) not in cells:
                raise Fault(f"the table has no row {row} with a column {column}: {grid['header']}")
            cell, offset = cells[row, column]
            found = [(m[0], (offset + m.start(), offset + m.end())) for m in re.finditer(FIGURE, cell)]
            if len(found) != len(places) and "not_run" not in run:
                raise Fault(f"{len(found)} figures but {len(places)} places of output: {row}, {column}")
            yield (run, joined(run["command"], extra, by_row, by_column),
                   f"{row}, column {column}: {cell}", found, places)


# What the command gives

def values_in(value, path):
    """All values at a path of a JSON document."""
    if not path:
        return [value]
    step = re.match(r"\.?([^.\[\]]+)|\[\*\]|\[(-?\d+)\]|\[([^\]=]+=[^\]]*)\]", path)
    if not step:
        raise Fault(f"no path: {path}")
    rest, (key, index, selection) = path[step.end():], step.groups()
    try:
        if key is not None:
            next_values = [value[key]]
        elif index is not None:
            next_values = [value[int(index)]]
        elif selection is not None:
            wanted = [pair.split("=", 1) for pair in selection.split(",")]
            next_values = [item for item in value
                           if all(str(item.get(name)) == is_value for name, is_value in wanted)]
        else:
            next_values = list(value.values() if isinstance(value, dict) else value)
    except (KeyError, IndexError, TypeError):
        raise Fault(f"the output has no {path}") from None
    return [found for item in next_values for found in values_in(item, rest)]


def value_at(output, place):
    """The number at a place of the output, in the unit of the page."""
    factor, inner = re.fullmatch(r"(?:([-\d.e]+)\*)?(.*)", place).groups("1")
    choice = re.fullmatch(r"(max|min)\((.*)\)", inner)
    path = choice[2] if choice else inner
    if path.startswith("/"):
        figure, _, line = path[1:-1].partition("/ in /")
        found = [value for text in output.splitlines() if re.search(line, text)
                 for value in re.findall(figure, text)]
    else:
        found = values_in(json.loads(output), path)
    if not found or (len(found) > 1 and not choice):
        raise Fault(f"the output has {len(found)} values at {place}")
    numbers = [float(value) for value in found]
    return float(factor) * {"max": max, "min": min}.get(choice and choice[1], max)(numbers)


def agrees(quoted, value):
    """Whether the value rounds to what is quoted."""
    number = decimal.Decimal(quoted.replace(",", ""))
    half = decimal.Decimal(1).scaleb(number.as_tuple().exponent) / 2
    return abs(float(number) - value) <= float(half) * (1 + 1e-9) + 1e-12


def written(quoted, value):
    """The value at the rounding of what is quoted."""
    exponent = decimal.Decimal(quoted.replace(",", "")).as_tuple().exponent
    sign, comma = "+" if quoted.startswith("+") else "", "," if "," in quoted else ""
    if "e" in quoted:
        mantissa, _, tail = f"{value:{sign}.{len(quoted.split('e')[0].partition('.')[2])}e}".partition("e")
        return f"{mantissa}e{int(tail)}"
    return f"{value:{sign}{comma}.{max(0, -exponent)}f}"


def data_folder():
    return pathlib.Path(os.environ.get("CARINA_TEST_DATA", ROOT.parent / "shared/data")).resolve()


def command_line(command, build, scratch):
    """The words to start, with the programs of this build and the data of this computer."""
    text = said(command).replace("../shared/data", str(data_folder()))
    words = [word.replace("build/release", str(build)) for word in shlex.split(text)]
    words = [str(scratch) if word == "DIR" else word for word in words
             if not word.startswith("CARINA_TEST_DATA=")]
    if words[0] == "carina-lab":
        words[0] = str(build / "apps/lab/carina-lab")
    return words


def tests_of(words, build):
    """(command, environment) of what a ctest command runs. ctest itself is not run: it would write
    into the log of the ctest that runs this script."""
    pattern = words[words.index("-R") + 1]
    listed = run_of(["ctest", "--test-dir", str(build), "--show-only=json-v1", "-R", pattern], build)
    for test in json.loads(listed)["tests"]:
        properties = {item["name"]: item["value"] for item in test.get("properties", [])}
        yield test["command"], dict(pair.split("=", 1) for pair in properties.get("ENVIRONMENT", []))


def run_of(words, folder, environment=None):
    try:
        run = subprocess.run(words, cwd=folder, env={"QT_QPA_PLATFORM": "offscreen", **os.environ,
                                                     "CARINA_TEST_DATA": str(data_folder()),
                                                     **(environment or {})},
                             capture_output=True, text=True, check=False)
    except OSError as error:
        raise Fault(str(error)) from None
    if run.returncode != 0:
        raise Fault(f"ended with status {run.returncode}: {run.stderr.strip()[-300:] or run.stdout[-300:]}")
    return run.stdout


def output_of(command, display, build):
    with tempfile.TemporaryDirectory() as scratch:
        words = command_line(command, build, scratch)
        if words[0] == "ctest":
            return "".join(run_of(test, scratch, environment) for test, environment in tests_of(words, build))
        return run_of([str(ROOT / "tests/support/with_display")] * display + words, scratch)


def reason_against(run):
    """Why the command of a run is not run; None where it is."""
    missing = run.get("data") and not (data_folder() / run["data"]).exists()
    return run.get("not_run") or (f"CARINA_TEST_DATA has no {run['data']}" if missing else None)


def faults_of(table, text, outputs, tell=print, news=None):
    """Compares a page with what the commands give; outputs(command) gives the output of one. What
    should stand in the page instead is put into news, as {(begin, end): figure}."""
    page, faults, named = table["page"], [], set()
    try:
        checks = list(checks_of(table, text))
    except Fault as fault:
        return [f"{page}: {fault}"]
    for run, command, words, found, places in checks:
        reason = reason_against(run)
        if reason:
            line = (f"not re-run: {reason}: {run['command']}" if run.get("not_run")
                    else f"SKIP   : docs::figures({page}) {reason}")
            if line not in named:
                tell(line)
            named.add(line)
            continue
        try:
            output, differ = outputs(command, run.get("display", False)), []
            for (quoted, span), place in zip(found, places):
                value = value_at(output, place)
                if not agrees(quoted, value):
                    differ.append(f"    quotes {quoted}, now {value:.6g} ({place})\n")
                    if news is not None:
                        news[span] = written(quoted, value)
            if differ:
                faults.append(f"{page}: {words}\n{''.join(differ)}    {command}")
        except (Fault, ValueError) as fault:
            faults.append(f"{page}: {words}\n    {fault}\n    {command}")
    return faults


def check(build, page, write=False, tell=print):
    """Status of one page, as ctest takes it."""
    table, given, news = load(page), {}, {}
    text = (ROOT / table["page"]).read_text(encoding="utf-8")
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:

        def outputs(command, display):
            if command not in given:
                given[command] = pool.submit(output_of, command, display, build)
            return given[command]

        with contextlib.suppress(Fault):  # which faults_of tells of
            for run, command, *_ in checks_of(table, text):
                if not reason_against(run):
                    outputs(command, run.get("display", False))  # all are under way
        faults = faults_of(table, text, lambda *words: outputs(*words).result(), tell, news)
    for fault in faults:
        tell(fault)
    if not given and not faults:
        reasons = sorted({reason_against(run) for run in table["runs"]})
        tell(f"SKIP   : docs::figures({table['page']}) {'; '.join(reasons)}")
    tell(f"{table['page']}: {len(given)} commands run; faults: {len(faults)}")
    if write and news:
        for (begin, end), figure in sorted(news.items(), reverse=True):
            text = text[:begin] + figure + text[end:]
        (ROOT / table["page"]).write_text(text, encoding="utf-8")
    return 1 if faults else 0 if given or not table["runs"] else SKIPPED


def blocks_of(text):
    """Paragraphs, tables, headings and commands: (offset, number of the first line, lines)."""
    offset, number, begin, lines = 0, 0, None, []
    for line in [*text.split("\n"), ""]:
        number += 1
        if line.strip():
            begin = begin or (offset, number)
            lines.append(line)
        elif lines:
            yield (*begin, lines)
            begin, lines = None, []
        offset += len(line) + 1


def figures_in(line, at, covered):
    """Spans of what a line quotes: what has a unit, and in a row of a table every figure behind the
    first that is compared; those before it are its label."""
    first = min((a - at for a, _ in covered if at <= a < at + len(line)), default=None)
    if first is None or not line.startswith("|"):
        return [(at + m.start(), at + m.end()) for m in UNIT.finditer(line)]
    return [(at + m.start(), at + m.end()) for m in re.finditer(FIGURE, line) if m.start() > first]


def uncovered_in(text, covered):
    """Lines with a figure that nothing holds: (line number, line). A command holds the figures of
    its own paragraph, of the next one and of the table that this introduces, unless some of a
    paragraph or table are in the list of what is compared: then the others there are told."""
    found, has_command, was_command = [], False, False
    for offset, first, lines in blocks_of(text):
        is_table, is_command = lines[0].startswith("|"), lines[0].startswith("    ")
        own = any(COMMAND.search(line) for line in lines)
        has_command = not lines[0].startswith("#") and (own or was_command or (is_table and has_command))
        was_command = is_command and (own or was_command)
        end = offset + sum(len(line) + 1 for line in lines)
        is_listed = any(offset <= a < end for a, _ in covered)
        for number, line in enumerate(lines, start=first):
            spans = figures_in(line, offset, covered)
            if not is_command and not (has_command and not is_listed) and any(
                    not any(a < d and c < b for c, d in covered) for a, b in spans):
                found.append((number, line))
            offset += len(line) + 1
    return found


def check_places(tell=print):
    """Status of all pages, without the commands."""
    status = 0
    for path in sorted(TABLES.glob("*.json")):
        table = load(path.stem)
        try:
            list(checks_of(table, (ROOT / table["page"]).read_text(encoding="utf-8")))
        except Fault as fault:
            tell(f"{table['page']}: {fault}")
            status = 1
    return status


def list_uncovered():
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]:
        text, covered = path.read_text(encoding="utf-8"), []
        if (TABLES / f"{path.stem}.json").exists():
            for _, _, _, found, _ in checks_of(load(path.stem), text):
                covered += [span for _, span in found]
        for number, line in uncovered_in(text, covered):
            print(f"{path.relative_to(ROOT)}:{number}: {line[:160]}")


def main():
    if sys.argv[1:] == ["--uncovered"]:
        list_uncovered()
        return 0
    if sys.argv[1:] == ["--places"]:
        return check_places()
    write = sys.argv[1] == "--write"
    build, *pages = sys.argv[1 + write:]
    statuses = [check(pathlib.Path(build).resolve(), page, write) for page in pages]
    return max((s for s in statuses if s != SKIPPED), default=SKIPPED)


if __name__ == "__main__":
    sys.exit(main())
