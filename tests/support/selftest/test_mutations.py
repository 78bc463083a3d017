"""What is mutated, what is left alone, and that a toy's good and bad tests are told apart."""

import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

SUPPORT = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(SUPPORT))
import mutations


def changes(text):
    return [(mutation.old, mutation.new) for mutation in mutations.mutations_of(text)]


class Sites(unittest.TestCase):
    def test_comparisons_between_blanks(self):
        self.assertEqual(changes("a < b"), [("<", "<="), ("<", ">=")])
        self.assertEqual(changes("a == b"), [("==", "!=")])

    def test_arithmetic_and_logic(self):
        self.assertEqual(changes("a + b && c"), [("+", "-"), ("&&", "||")])
        self.assertEqual(changes("a += b << c"), [("+=", "-="), ("<<", ">>")])

    def test_unary_operators(self):
        self.assertEqual(changes("if (!ready) --count;"), [("!", ""), ("--", "++")])
        self.assertEqual(changes("return -x;"), [("-", "")])

    def test_constants(self):
        self.assertEqual(changes("return true;"), [("true", "false")])
        self.assertEqual(changes("x = 16u;"), [("16u", "17u"), ("16u", "15u")])
        self.assertEqual(changes("x = 0;"), [("0", "1")])
        self.assertEqual(changes("x = 0xFFu;"), [("0xFFu", "0x100u"), ("0xFFu", "0xfeu")])
        self.assertEqual(changes("x = 0.5f;"), [("0.5f", "1.0f")])
        self.assertEqual(changes("x = 10'000ms;"), [("10'000", "10001"), ("10'000", "9999")])

    def test_leaves_types_alone(self):
        self.assertEqual(changes("std::array<std::pair<int, 3>, 4> f(const T& a, T* b, T&& c);"), [])
        self.assertEqual(changes("template <typename T> auto f() -> T;"), [])
        self.assertEqual(changes("bool operator<(const T& other) const;"), [])
        self.assertEqual(changes("bool operator==(const T& other) const = default;"), [])

    def test_leaves_text_and_contracts_alone(self):
        self.assertEqual(changes("// a < b\n/* 1 + 2 */ \"a == b\" 'c' R\"x(1 < 2)x\""), [])
        self.assertEqual(changes("#include <a>\n#define SUM(a, b) \\\n    a + b\n"), [])
        self.assertEqual(changes("static_assert(sizeof(T) == 8);\nCARINA_EXPECTS(f(a) > 0);\n"), [])

    def test_replaces_in_place_and_names_the_line(self):
        text = "int f(int a)\n{\n    return a * 2;\n}\n"
        product = mutations.mutations_of(text)[0]
        self.assertEqual(product.line, 3)
        self.assertEqual(product.applied_to(text), text.replace("*", "/"))


TOY_LIST = """cmake_minimum_required(VERSION 3.25)
project(Toy LANGUAGES CXX)
enable_testing()
add_subdirectory(tests)
"""
TOY_TESTS = "add_subdirectory(engine/toy)\n"
TOY_TEST = """add_executable(test_toy tst_toy.cpp "${PROJECT_SOURCE_DIR}/engine/toy/toy.cpp")
add_test(NAME toy COMMAND test_toy)
"""
TOY = "bool isAdult(int years)\n{\n    return years >= 18;\n}\n"
STRONG = "bool isAdult(int);\nint main() { return isAdult(18) && !isAdult(17) ? 0 : 1; }\n"
WEAK = "bool isAdult(int);\nint main() { return isAdult(90) ? 0 : 1; }\n"


@unittest.skipUnless(shutil.which("ninja") and shutil.which("cmake"), "no cmake and ninja")
class Toy(unittest.TestCase):
    """The four mutants of one comparison: >= to > and <, 18 to 19 and 17."""

    def mutate(self, test):
        with tempfile.TemporaryDirectory() as folder:
            for path, text in (("CMakeLists.txt", TOY_LIST), ("tests/CMakeLists.txt", TOY_TESTS),
                               ("tests/engine/toy/CMakeLists.txt", TOY_TEST),
                               ("tests/engine/toy/tst_toy.cpp", test), ("engine/toy/toy.cpp", TOY)):
                file = pathlib.Path(folder) / path
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")
            run = subprocess.run([str(SUPPORT.parent / "mutate"), "--root", folder, "--json",
                                  "engine/toy/toy.cpp"], capture_output=True, text=True)
            unchanged = (pathlib.Path(folder) / "engine/toy/toy.cpp").read_text(encoding="utf-8")
            self.assertEqual(unchanged, TOY)
            return run.returncode, json.loads(run.stdout)["mutants"]

    def test_a_test_at_the_boundary_kills_all(self):
        status, mutants = self.mutate(STRONG)
        self.assertEqual((status, len(mutants)), (0, 4))
        self.assertTrue(all(mutant["killed_by"] == "toy" for mutant in mutants))

    def test_a_test_far_from_the_boundary_kills_one(self):
        status, mutants = self.mutate(WEAK)
        survivors = {(mutant["line"], mutant["new"]) for mutant in mutants if not mutant["killed_by"]}
        self.assertEqual(status, 1)
        self.assertEqual(survivors, {(3, ">"), (3, "19"), (3, "17")})


if __name__ == "__main__":
    unittest.main()
