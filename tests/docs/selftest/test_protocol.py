"""A page of the protocol that agrees with the code, then with one planted fault."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import protocol

PAGE = """# Protocol

What Carina programs say to each other, version 9. More words.

| 2 | version | u8 | 9 |

| 1 | StreamGroup | both | 12 |
| 2 | Fact | host | 39 |
| 3 | Goodbye | both | 1 |

### 1 StreamGroup

### 2 to 3
"""
RECORDS = ["StreamGroup", "Fact", "Goodbye"]


class Protocol(unittest.TestCase):
    def test_a_page_that_agrees_has_no_fault(self):
        self.assertEqual([], protocol.faults_of(PAGE, 9, RECORDS))

    def test_reads_version_and_records_of_the_code(self):
        self.assertEqual(9, protocol.version_of("std::uint8_t kProtocolVersion = 9;"))
        self.assertEqual(RECORDS, protocol.records_of(
            "enum class RecordKind : std::uint8_t {\n    StreamGroup = 1,\n    Fact,\n    Goodbye,\n};"))

    def test_refuses_another_version_in_either_place(self):
        self.assertEqual(2, len(protocol.faults_of(PAGE, 10, RECORDS)))
        self.assertEqual(1, len(protocol.faults_of(PAGE.replace("| u8 | 9", "| u8 | 8"), 9, RECORDS)))

    def test_refuses_a_record_that_is_missing(self):
        self.assertIn("the records are", protocol.faults_of(PAGE.replace("| 2 | Fact", "| 2 | Facts"), 9, RECORDS)[0])
        self.assertEqual(2, len(protocol.faults_of(PAGE, 9, [*RECORDS, "EventCpo"])))

    def test_refuses_a_heading_that_ends_too_early(self):
        self.assertIn("[3]", protocol.faults_of(PAGE.replace("2 to 3", "2 to 2"), 9, RECORDS)[0])


if __name__ == "__main__":
    unittest.main()
