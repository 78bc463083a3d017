"""Pages and tables that agree or do not, and a command that prints what the test says."""

import json
import os
import pathlib
import re
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import figures

PAGE = """# Drops

    carina-lab drop --height-m 2 \\
                    --mass-kg 1

A drop takes 0.639 s, and 1,250 drops -6e-7 of a day.

| air | still | wind |
|---|---|---|
| thin | 1.0 / 2 | 1.5 / 3 |
| thick | 2.0 / 4 | 2.5 / 5 |
"""
COMMAND = "carina-lab drop --height-m 2 --mass-kg 1"
OUTPUT = json.dumps({"time_s": 0.63855, "drops": [{"air": "thin", "ms": 1}, {"air": "thick", "ms": 2}]})


def table(*entries, **keys):
    return {"page": "docs/drops.md",
            "runs": [{"command": COMMAND, "figures": list(entries), **keys}]}


def faults(a_table, output=OUTPUT, page=PAGE, news=None):
    return figures.faults_of(a_table, page, lambda command, display: output, lambda line: None, news)


class Compared(unittest.TestCase):
    def test_takes_a_figure_that_rounds_to_what_is_quoted(self):
        self.assertEqual([], faults(table({"words": "A drop takes {} s", "at": "time_s"})))

    def test_names_page_words_and_what_the_command_gives(self):
        found = faults(table({"words": "A drop takes {} s", "at": "time_s"}), '{"time_s": 0.64}')
        self.assertEqual(1, len(found))
        for words in ("docs/drops.md", "A drop takes {} s", "quotes 0.639, now 0.64", COMMAND):
            self.assertIn(words, found[0])

    def test_refuses_a_page_that_was_edited_without_the_table(self):
        edited = PAGE.replace("A drop takes", "One drop takes")
        self.assertIn("0 times", faults(table({"words": "A drop takes {} s", "at": "time_s"}), page=edited)[0])

    def test_refuses_a_command_that_is_not_in_the_page(self):
        edited = PAGE.replace("--mass-kg 1", "--mass-kg 2")
        self.assertIn("command", faults(table({"words": "A drop takes {} s", "at": "time_s"}), page=edited)[0])

    def test_refuses_words_that_stand_twice(self):
        self.assertIn("2 times", faults(table({"words": "A drop takes {} s", "at": "time_s"}), page=PAGE * 2)[0])

    def test_says_that_the_output_lacks_a_value(self):
        self.assertIn("no time_h", faults(table({"words": "A drop takes {} s", "at": "time_h"}))[0])

    def test_names_what_is_not_run(self):
        told = []
        figures.faults_of(table({"words": "A drop takes {} s"}, not_run="takes 4 min"), PAGE, None, told.append)
        self.assertEqual([f"not re-run: takes 4 min: {COMMAND}"], told)

    def test_names_what_lacks_its_data_as_skipped(self):
        told = []
        with mock.patch.dict(os.environ, CARINA_TEST_DATA="nowhere"):
            figures.faults_of(table({"words": "A drop takes {} s", "at": "time_s"}, data="drops"), PAGE, None,
                              told.append)
        self.assertRegex(told[0], r"^SKIP   : docs::figures\(docs/drops.md\) .*drops$")

    def test_runs_a_command_for_each_cell_of_a_grid(self):
        grid = table(grid={"header": "| air |", "rows": {"thin": "--air thin", "thick": "--air thick"},
                           "columns": {"still": "", "wind": "--height-m 3"}}, at=["a", "b"])
        del grid["runs"][0]["figures"]
        given = {"thin --height-m 2": (1, 2), "thin --height-m 3": (1.5, 3), "thick --height-m 2": (2, 4),
                 "thick --height-m 3": (2.5, 5.6)}

        def output(command, _):
            words = command.split()
            a, b = given[f"{words[-1]} --height-m {words[words.index('--height-m') + 1]}"]
            return json.dumps({"a": a, "b": b})

        found = figures.faults_of(grid, PAGE, output, lambda line: None)
        self.assertEqual(1, len(found))
        self.assertIn("thick, column wind: 2.5 / 5", found[0])
        self.assertIn("quotes 5, now 5.6", found[0])

    def test_tells_where_the_new_figure_belongs(self):
        news = {}
        faults(table({"words": "A drop takes {} s", "at": "time_s"}), '{"time_s": 0.6414}', news=news)
        ((begin, end), figure), = news.items()
        self.assertEqual(("0.639", "0.641"), (PAGE[begin:end], figure))


class Rounded(unittest.TestCase):
    def test_compares_at_the_digits_that_are_quoted(self):
        for quoted, value in (("1.5", 1.549), ("1,250", 1250.4), ("-6e-7", -6.3e-7), ("+2.2", 2.2), ("1760", 1759.6)):
            self.assertTrue(figures.agrees(quoted, value), quoted)
        for quoted, value in (("1.50", 1.549), ("1,250", 1251), ("-6e-7", -6.7e-7), ("2.2", -2.2), ("1760", 1761)):
            self.assertFalse(figures.agrees(quoted, value), quoted)

    def test_writes_at_the_digits_that_are_quoted(self):
        for quoted, value, text in (("1.5", 1.549, "1.5"), ("1,250", 1251.2, "1,251"), ("+2.2", 2.31, "+2.3"),
                                    ("6e-7", 6.7e-7, "7e-7")):
            self.assertEqual(text, figures.written(quoted, value))


class Found(unittest.TestCase):
    def test_finds_values_by_path_selection_and_expression(self):
        for place, value in (("time_s", 0.63855), ("1000*time_s", 638.55), ("drops[1].ms", 2),
                             ("drops[air=thin].ms", 1), ("max(drops[*].ms)", 2), ("min(drops[*].ms)", 1),
                             ('/"ms": (1)/', 1), ("max(/(\\d+) mm/ in /^b/)", 8)):
            output = "a: 9 mm\nb: 7 mm, 8 mm\n" if " in " in place else OUTPUT
            self.assertAlmostEqual(value, figures.value_at(output, place), msg=place)

    def test_refuses_several_values_where_one_is_meant(self):
        with self.assertRaises(figures.Fault):
            figures.value_at(OUTPUT, "drops[*].ms")

    def test_takes_a_comma_for_part_of_a_figure_only_between_thousands(self):
        self.assertEqual(["1,250", "12", "13", "0.5"], re.findall(figures.FIGURE, "1,250 12, 13, 0.5"))

    def test_replaces_and_appends_options(self):
        self.assertEqual("carina-lab drop --height-m 3 --mass-kg 1 --prone",
                         figures.joined(COMMAND, "--height-m 3", "--prone"))


class Uncovered(unittest.TestCase):
    def lines(self, text, *compared):
        spans = [(text.index(words), text.index(words) + len(words)) for words in compared]
        return [line for _, line in figures.uncovered_in(text, spans)]

    def test_a_command_holds_its_paragraph_the_next_and_the_table_of_that(self):
        self.assertEqual([], self.lines("# A\n\nBy `carina-lab drop` 12 mm.\n"))
        self.assertEqual([], self.lines("# A\n\n    carina-lab drop\n\n12 mm:\n\n| a | 13 mm |\n"))

    def test_it_does_not_hold_the_rest_of_the_section(self):
        text = "# A\n\n    carina-lab drop\n\n12 mm\n\n13 mm\n\n| a | 14 mm |\n\n## B\n\n15 ms, 16 of them\n"
        self.assertEqual(["13 mm", "| a | 14 mm |", "15 ms, 16 of them"], self.lines(text))

    def test_a_paragraph_that_is_compared_in_part_is_told(self):
        text = "# A\n\n    carina-lab drop\n\nIt takes 12 ms\nand 13 ms.\n"
        self.assertEqual(["and 13 ms."], self.lines(text, "12"))

    def test_a_row_that_is_compared_in_part_is_told(self):
        text = "# A\n\n    carina-lab drop\n\n| s | mm | of |\n|---|---|---|\n| 0.3 | 12 | 0.5 |\n"
        self.assertEqual(["| 0.3 | 12 | 0.5 |"], self.lines(text, "12"))
        self.assertEqual([], self.lines(text, "12", "0.5"))


class Run(unittest.TestCase):
    def test_says_what_a_command_that_fails_printed(self):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "apps/lab/carina-lab"
            program.parent.mkdir(parents=True)
            program.write_text("#!/bin/sh\necho no such drop >&2\nexit 2\n", encoding="utf-8")
            program.chmod(0o755)
            with self.assertRaisesRegex(figures.Fault, "status 2: no such drop"):
                figures.output_of(COMMAND, False, pathlib.Path(folder))

    def test_says_that_a_program_was_not_built(self):
        with self.assertRaisesRegex(figures.Fault, "No such file"):
            figures.output_of(COMMAND, False, pathlib.Path("nowhere"))


if __name__ == "__main__":
    unittest.main()
