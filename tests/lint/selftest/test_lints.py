"""Each lint is shown a small tree that is right, then the same tree with one planted fault."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import format as format_lint
import fuzzers
import layers
import links
import number_boxes
import pages
import rich_text
import size
import words

TABLE = """# Architecture

## Who may include whom

| files in | may include | libraries |
|---|---|---|
| `engine/core` | - | tl::expected |
| `engine/sync` | `engine/core` | Eigen |
| `engine/net` | all above | Qt Core, Qt Network |
| `models` | `engine/sync` | Qt Core |
| `apps` | all | all |

## Afterwards

| `widgets` | all | all |
"""
PROMISE = "TO" + "DO"
MACHINE = "/ho" + "me/someone/carina"


class Tree(unittest.TestCase):
    """A tree of files in a folder of its own, beside a folder of Qt's headers."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name) / "tree"
        self.qt = pathlib.Path(folder.name) / "qt6"
        for header in ("QtCore/QObject", "QtNetwork/QUdpSocket", "QtGui/QImage", "Qt3DCore/QEntity"):
            self.write(header, "", self.qt)
        self.write("docs/architecture.md", TABLE)
        self.write("engine/core/result.h", "#include <tl/expected.hpp>\n#include <vector>\n")
        self.write("engine/sync/codec.h", '#include "engine/core/result.h"\n#include <Eigen/Core>\n')
        self.write("engine/net/pump.cpp", '#include "engine/sync/codec.h"\n#include <QUdpSocket>\n')
        self.write("models/drift.cpp", '#include "drift.moc"\n#include "engine/sync/codec.h"\n')
        self.write("apps/main.cpp", '#include "models/drift.cpp"\n#include <QImage>\n')

    def write(self, path, text, root=None):
        file = (root or self.root) / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


class RichText(Tree):
    DESIGNER = ('<ui version="4.0"><widget class="QWidget" name="panel">'
                '<widget class="QLabel" name="owner"><property name="textFormat">'
                '<enum>Qt::PlainText</enum></property></widget></widget></ui>')
    SCREEN = ("auto* name = new PlainLabel{row.name};\n"
              'name->setToolTip(tr("Who takes part (by name), "\n"and \\"where\\""));\n'
              'name->setToolTip(isFull ? tr("No more") : shownAsIs(row.name));\n'
              "QMessageBox box;\nbox.setText(shownAsIs(errorText(error)));\n"
              "if (role == Qt::ToolTipRole && !row.reason.isEmpty())\n"
              "    return shownAsIs(row.reason);\n")

    def setUp(self):
        super().setUp()
        self.write("ui/panel.ui", self.DESIGNER)
        self.write("ui/panel.cpp", self.SCREEN)

    def one_fault(self, path, before, after):
        text = (self.root / path).read_text(encoding="utf-8")
        self.assertIn(before, text)
        self.write(path, text.replace(before, after))
        faults = rich_text.faults_of(self.root)
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(path, faults[0])

    def test_a_right_tree_has_no_fault(self):
        self.assertEqual(rich_text.faults_of(self.root), [])

    def test_refuses_a_label_of_qt(self):
        self.one_fault("ui/panel.cpp", "new PlainLabel", "new QLabel")

    def test_refuses_a_label_of_designer_without_a_format(self):
        self.one_fault("ui/panel.ui", "Qt::PlainText", "Qt::AutoText")

    def test_refuses_a_name_in_a_tooltip(self):
        self.one_fault("ui/panel.cpp", "shownAsIs(row.name)", "row.name")

    def test_refuses_an_argument_in_a_tooltip(self):
        self.one_fault("ui/panel.cpp", 'where\\""))', 'where\\"").arg(row.name))')

    def test_refuses_an_error_in_a_message_box(self):
        self.one_fault("ui/panel.cpp", "shownAsIs(errorText(error))", "errorText(error)")

    def test_refuses_a_reason_in_the_tooltip_of_a_model(self):
        self.one_fault("ui/panel.cpp", "return shownAsIs(row.reason)", "return row.reason")


class NumberBoxes(Tree):
    def setUp(self):
        super().setUp()
        self.write("ui/panel.ui", '<ui version="4.0"><widget class="QWidget" name="panel"><widget '
                                  'class="carina::CheckedSpinBox" name="rate"/></widget></ui>')
        self.write("ui/panel.cpp", "m_rate = new CheckedDoubleSpinBox{this};\n"
                                   "for (QSpinBox* box : boxes)\n    box->setRange(0, 9);\n")

    def one_fault(self, path, before, after):
        text = (self.root / path).read_text(encoding="utf-8")
        self.write(path, text.replace(before, after))
        faults = number_boxes.faults_of(self.root)
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(path, faults[0])

    def test_a_right_tree_has_no_fault(self):
        self.assertEqual(number_boxes.faults_of(self.root), [])

    def test_refuses_a_box_of_qt(self):
        self.one_fault("ui/panel.cpp", "new Checked", "new Q")

    def test_refuses_a_box_of_qt_as_a_value(self):
        self.one_fault("ui/panel.cpp", "for (QSpinBox*", "QSpinBox box;\nfor (QSpinBox*")

    def test_refuses_a_box_of_designer(self):
        self.one_fault("ui/panel.ui", "carina::Checked", "Q")


class Fuzzers(Tree):
    def setUp(self):
        super().setUp()
        self.write("tests/fuzz/fuzz_ndi.cpp", "")
        self.write("tests/fuzz/seeds.cpp", 'areWritten(folder / "ndi", ndi())')
        self.line = "    build/fuzz/tests/fuzz/fuzz_ndi -runs=10000000 -max_len=9 build/fuzz/seeds/ndi\n"
        self.write("CONTRIBUTING.md", "Give each 10,000,000 inputs:\n\n" + self.line)

    def one_fault(self, path, text, words_of_it):
        self.write(path, text)
        faults = fuzzers.faults_of(self.root)
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(words_of_it, faults[0])

    def test_a_right_tree_has_no_fault(self):
        self.assertEqual(fuzzers.faults_of(self.root), [])

    def test_refuses_a_fuzzer_that_is_not_named(self):
        self.one_fault("tests/fuzz/fuzz_tum.cpp", "", "fuzz_tum has no command")

    def test_refuses_a_command_of_no_fuzzer(self):
        self.one_fault("CONTRIBUTING.md", self.line + self.line.replace("ndi", "tum"), "no fuzz_tum")

    def test_refuses_another_number_of_inputs(self):
        self.one_fault("CONTRIBUTING.md", self.line.replace("10000000", "2000000"), "2000000")

    def test_refuses_a_command_without_seeds(self):
        self.one_fault("CONTRIBUTING.md", self.line.replace(" build/fuzz/seeds/ndi", ""), "seeds")

    def test_refuses_seeds_that_nothing_writes(self):
        self.one_fault("tests/fuzz/seeds.cpp", "", "seeds.cpp")


class Layers(Tree):
    def faults(self):
        return layers.faults_of(self.root, self.qt)

    def one_fault(self, path, text, words_of_it):
        self.write(path, text)
        faults = self.faults()
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(path, faults[0])
        self.assertIn(words_of_it, faults[0])

    def test_a_right_tree_has_no_fault(self):
        self.assertEqual(self.faults(), [])

    def test_refuses_an_include_against_the_order(self):
        self.one_fault("engine/sync/x.h", '#include "engine/net/pump.cpp"\n', "in engine/net")

    def test_all_above_ends_at_the_row(self):
        self.one_fault("engine/net/x.h", '#include "models/drift.cpp"\n', "in models")

    def test_names_the_line(self):
        self.one_fault("engine/core/x.h", '\n\n#include "engine/sync/codec.h"\n', "x.h:3:")

    def test_refuses_a_library_outside_the_row(self):
        self.one_fault("engine/net/x.h", "#include <QImage>\n", "Qt Gui")

    def test_refuses_a_library_named_by_its_folder(self):
        self.one_fault("models/x.h", "#include <Qt3DCore/QEntity>\n", "Qt3D")

    def test_refuses_an_unknown_library(self):
        self.one_fault("apps/x.h", "#include <zlib.h>\n", "does not know")

    def test_refuses_an_include_beside_the_file(self):
        self.one_fault("engine/core/x.cpp", '#include "result.h"\n', "path from the root")

    def test_refuses_a_folder_without_a_row(self):
        self.one_fault("widgets/x.h", "#include <vector>\n", "no row")

    def test_the_simulated_polaris_shares_no_code_with_the_client(self):
        """By the table of the project itself."""
        project = pathlib.Path(layers.__file__).resolve().parents[2]
        rows = layers.rows_of((project / layers.TABLE).read_text(encoding="utf-8"))
        row = layers.row_of("evaluation/polaris/polaris_device.cpp", rows)
        self.assertEqual(row.folders, {"engine/core", "engine/geometry"})
        client = "engine/tracking/ndi/ndi_client.h"
        self.write(client, "")
        fault = layers.fault_of_include(self.root, row, '"', client, rows, {})
        self.assertIn("is in engine/tracking", fault)

    def test_refuses_a_missing_table(self):
        self.one_fault("docs/architecture.md", "# Architecture\n", "no table")


class Links(unittest.TestCase):
    RIGHT = "\tlibQt6Core.so.6 => /lib/libQt6Core.so.6 (0x1)\n\tlibc.so.6 => /lib/libc.so.6 (0x2)\n"

    def test_qt_6_alone_is_right(self):
        self.assertEqual(links.faults_in("lab", self.RIGHT), [])

    def test_refuses_qt_5(self):
        listing = self.RIGHT + "\tlibQt5Core.so.5 => /lib/libQt5Core.so.5 (0x3)\n"
        self.assertEqual(links.faults_in("lab", listing), ["lab: loads libQt5Core.so.5"])

    def test_refuses_highgui(self):
        listing = self.RIGHT + "\tlibopencv_highgui.so.406 => /lib/libopencv_highgui.so.406 (0x3)\n"
        self.assertEqual(links.faults_in("lab", listing), ["lab: loads libopencv_highgui.so.406"])

    def test_refuses_a_missing_library(self):
        listing = self.RIGHT + "\tlibvdb.so => not found\n"
        self.assertEqual(links.faults_in("lab", listing), ["lab: libvdb.so is not there"])

    def test_reads_a_program(self):
        self.assertEqual(links.faults_of("/bin/sh"), [])
        self.assertEqual(len(links.faults_of("/bin/no-such-program")), 1)


class Format(Tree):
    def test_refuses_other_spacing(self):
        program = format_lint.formatter()
        if program is None:
            self.skipTest("no clang-format of that version")
        self.write(".clang-format", "BasedOnStyle: LLVM\n")
        self.write("apps/main.cpp", "int main() { return 0; }\n")
        self.assertEqual(format_lint.faults_of(self.root, program), [])
        self.write("apps/main.cpp", "int main()   { return 0; }\n")
        self.assertEqual(len(format_lint.faults_of(self.root, program)), 1)


    def test_refuses_python_that_python_cannot_read(self):
        self.write("bench/peer.py", "def main():\n    return 0\n")
        self.assertEqual(format_lint.unreadable_of(self.root), [])
        self.write("bench/peer.py", "def main(): {\n    return 0;\n}\n")
        self.assertEqual(len(format_lint.unreadable_of(self.root)), 1)


class Size(Tree):
    def test_399_lines_are_not_warned_of_and_400_are(self):
        self.write("engine/core/x.cpp", "\n" * 399)
        self.assertEqual(size.warnings_of(self.root), [])
        self.write("engine/core/x.cpp", "\n" * 400)
        self.assertEqual(len(size.warnings_of(self.root)), 1)
        self.assertEqual(size.lengths_of(self.root)[0], (400, "engine/core/x.cpp"))
        self.assertEqual(size.faults_of(self.root), [])

    def test_32_files_in_a_folder_are_not_warned_of_and_33_are(self):
        for number in range(32):
            self.write(f"engine/full/x{number}.cpp", "")
        self.assertEqual(size.warnings_of(self.root), [])
        self.write("engine/full/one_more.cpp", "")
        self.assertEqual(len(size.warnings_of(self.root)), 1)

    def test_20_root_entries_are_right_and_21_are_not(self):
        for number in range(16):
            self.write(f"entry{number}.md", "")
        self.write(".hidden", "")
        self.assertEqual(size.faults_of(self.root), [])
        self.write("entry16.md", "")
        self.assertEqual(len(size.faults_of(self.root)), 1)


class Pages(Tree):
    def faults(self, text):
        self.write("docs/start.md", text)
        return pages.faults_of(self.root)

    def test_a_right_link_has_no_fault(self):
        self.assertEqual([], self.faults(
            "# Start: `codec` and [table](architecture.md)\n[all](#start-codec-and-table), "
            "[who](architecture.md#who-may-include-whom), [file](../engine/sync/codec.h), "
            "[`folder`](../engine/), [elsewhere](https://example.org/a#b), `[code](none)`\n\n"
            "    [code](none)\n"))

    def test_refuses_a_file_that_is_not_there(self):
        self.assertEqual(["docs/start.md:2: other.md#a: no such file"],
                         self.faults("# Start\n[other](other.md#a)\n"))

    def test_refuses_an_anchor_without_its_heading(self):
        self.assertIn("0 headings", self.faults("# Start\n\n    # Code\n\n[code](#code)\n")[0])

    def test_refuses_an_anchor_of_two_headings(self):
        self.assertIn("2 headings", self.faults("# Start\n## Files\n## Files\n[files](#files)\n")[0])

    def test_refuses_an_anchor_in_a_source(self):
        self.assertEqual(1, len(self.faults("[line](../engine/sync/codec.h#L1)\n")))


class Words(Tree):
    def test_a_right_tree_has_no_fault(self):
        self.assertEqual(words.faults_of(self.root), [])

    def test_refuses_a_promise(self):
        self.write("engine/core/x.cpp", f"\n// {PROMISE}: later\n")
        self.assertEqual(len(words.faults_of(self.root)), 1)
        self.assertIn("engine/core/x.cpp:2:", words.faults_of(self.root)[0])

    def test_refuses_a_path_of_one_machine(self):
        self.write("docs/start.md", f"cd {MACHINE}\n")
        self.assertEqual(len(words.faults_of(self.root)), 1)

    def test_refuses_the_number_of_a_station_in_a_program(self):
        number = "constexpr StationId kStation{0};\n"
        self.write("engine/core/ids.h", number)
        self.write("tests/apps/tst_main.cpp", number)
        self.assertEqual(words.faults_of(self.root), [])
        for path in ("apps/main.cpp", "engine/net/pump.cpp", "models/drift.cpp"):
            self.write(path, number)
        self.assertEqual(len(words.faults_of(self.root)), 3)

    def test_a_path_of_the_project_is_right(self):
        inside = [folder + MACHINE[:6] + "page.md" for folder in ("tests", "build")]
        self.write("docs/start.md", f"{' and '.join(inside)} and ../shared/data\n")
        self.assertEqual(words.faults_of(self.root), [])


if __name__ == "__main__":
    unittest.main()
