"""The launcher among stand-ins: programs that write down how they were called, and a ninja, a
dpkg-query and an apt-get that do nothing else."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
RECORD = '#!/bin/sh\necho "$(basename "$0") $*" >> "$CALLS"\n'
LAB = RECORD + 'echo "{}"\n'
# Three tests: one passes, one of its checks left out; one is skipped whole; one may fail.
CTEST = RECORD + r"""
results=''; before=''
for word; do [ "$before" = --output-junit ] && results=$word; before=$word; done
case "$*" in
    *" -N"*) for name in a b c; do echo "  Test #1: $name"; done; exit ;;
    *nonsense*--show-only*) echo '"tests" : []'; exit ;;
    *--show-only*) echo "\"command\": [\"$PWD/build/release/tests/engine/sync/test_engine_sync\""; exit ;;
esac
for name in a b c; do echo "1/3 Test #1: $name ....   Passed    0.01 sec"; done
cat > "$results" << END
<testsuite><testcase name="a" status="run"><system-out>SKIP   : TestA::rows(one) no recordings
Loc: [x]</system-out></testcase>
<testcase name="b" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/>
<system-out>SKIP   : TestB::all() no anatomy set</system-out></testcase>
<testcase name="c" status="${THIRD:-run}"><system-out>FAIL!  : TestC::third() it broke</system-out></testcase>
$FOURTH</testsuite>
END
[ "${THIRD:-run}" = run ]
"""
INSTALLED = RECORD + 'shift 3\nfor name; do [ "$name" = "$ABSENT" ] || echo "installed $name"; done\n'


class Launcher(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "tests/support").mkdir(parents=True)
        (self.root / "apps").mkdir()
        shutil.copy(ROOT / "carina", self.root)
        shutil.copy(ROOT / "apps/demo.bash", self.root / "apps")
        (self.root / "evaluation/intubation").mkdir(parents=True)
        shutil.copy(ROOT / "evaluation/intubation/motion_parameters.h",
                    self.root / "evaluation/intubation")
        for script in ("with_display", "run_tests"):
            shutil.copy(ROOT / "tests/support" / script, self.root / "tests/support")
        self.calls = self.root / "calls"
        self.program("build/release/build.ninja", "")
        self.program("build/release/apps/lab/carina-lab", LAB)
        self.program("build/release/apps/instructor/carina-instructor", RECORD)
        self.program("build/release/apps/trainee/carina-trainee", RECORD)
        self.program("build/release/apps/registration/carina-registration", RECORD)
        self.program("bin/dpkg-query", INSTALLED)
        for name in ("ninja", "apt-get", "sudo"):
            self.program(f"bin/{name}", RECORD)
        self.program("bin/ctest", CTEST)
        self.environment = {"PATH": f"{self.root}/bin:{os.environ['PATH']}", "CALLS": str(self.calls),
                            "HOME": str(self.root), "ABSENT": ""}

    def program(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")
        file.chmod(0o755)

    def carina(self, *arguments, **environment):
        return subprocess.run([str(self.root / "carina"), *arguments], cwd=self.root, timeout=30,
                              env=self.environment | environment, capture_output=True, text=True)

    def called(self, name):
        lines = self.calls.read_text(encoding="utf-8").splitlines() if self.calls.exists() else []
        return [line for line in lines if line.startswith(name + " ")]

    def test_help_needs_nothing(self):
        run = self.carina("help")
        self.assertEqual((run.returncode, run.stderr, self.called("ninja")), (0, "", []))
        for command in ("setup", "demo", "test", "bench", "lab"):
            self.assertIn(f"\n  {command} ", run.stdout)

    def test_a_command_explains_itself(self):
        for arguments in (["demo", "--help"], ["demo", "-h"], ["demo", "--size", "640x480", "--help"]):
            run = self.carina(*arguments)
            self.assertEqual((run.returncode, run.stderr, self.called("ninja")), (0, "", []))
            self.assertIn("--headless DIR", run.stdout)
            self.assertNotIn("--mutate", run.stdout)
        self.assertIn("--mutate", self.carina("test", "--help").stdout)
        self.assertIn("configures and builds", self.carina("setup", "--help").stdout)

    def test_refuses_what_it_does_not_know(self):
        for arguments in (["fly"], ["test", "--some"], ["test", "--mutate"], ["test", "--reach", "engine"], ["test", "a", "b"], ["demo", "--fast", "1"], ["demo", "--size", "9"],
                          ["demo", "--seconds", "0"], ["demo", "--patient", "horse"], ["demo", "--patient", "child,"],
                          ["demo", "--anatomy", "no/such/folder"], ["demo", "--headless"], ["demo", "--headless", "no/such/out"],
                          ["demo", "--site", "no/such/file"], ["demo", "--output", "sphere"],
                          ["demo", "--register", "--site", "carina"], ["demo", "--tracker", "simulated:nope"],
                          ["demo", "--tracker", "simulated:hidden=nose"], ["demo", "--intubation", "perfect"],
                          ["demo", "--tracker", "simulated:intubation=perfect"],
                          ["demo", "--intubation", "good", "--tracker", "simulated"]):
            run = self.carina(*arguments)
            self.assertEqual((run.returncode, run.stdout), (2, ""), arguments)
            self.assertIn("./carina help", run.stderr)

    def test_installs_what_is_missing_and_says_so(self):
        run = self.carina("lab", "help", ABSENT="ninja-build")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertIn("installing ninja-build", run.stderr)
        installs = self.called("apt-get") if os.getuid() == 0 else self.called("sudo")
        self.assertTrue(installs[-1].endswith("--no-install-recommends ninja-build"), installs)

    def test_no_install_names_what_is_missing(self):
        run = self.carina("lab", "--no-install", "help", ABSENT="ninja-build")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("missing: ninja-build", run.stderr)
        self.assertEqual((self.called("apt-get"), self.called("sudo")), ([], []))

    def test_lab_leaves_stdout_to_the_program(self):
        run = self.carina("lab", "breathe", "--seconds", "3")
        self.assertEqual((run.returncode, run.stdout), (0, "{}\n"))
        self.assertEqual(self.called("carina-lab"), ["carina-lab breathe --seconds 3"])

    def test_the_fast_tests_are_the_default(self):
        self.assertEqual(self.carina("test").returncode, 0)
        self.assertIn(" -L ^fast$", self.called("ctest")[-1])

    def test_ends_with_a_line_that_counts(self):
        run = self.carina("test")
        lines = run.stdout.splitlines()
        self.assertRegex(lines[-1], r"^1 passed, 0 failed, 1 skipped, 1 in part, \d+\.\d minutes$")
        self.assertIn("skipped: b: no anatomy set", lines)
        self.assertIn("skipped in part: a: no recordings", lines)
        self.assertIn("3 of 3 tests", run.stderr)

    def test_a_failed_test_is_shown_and_fails(self):
        run = self.carina("test", THIRD="fail")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("failed: c\nFAIL!  : TestC::third() it broke", run.stdout)
        self.assertRegex(run.stdout.splitlines()[-1], "^0 passed, 1 failed, 1 skipped, 1 in part, ")

    def test_a_missing_program_is_a_failed_test(self):
        run = self.carina("test", FOURTH='<testcase name="d" status="notrun">'
                          '<skipped message="Unable to find executable"/></testcase>')
        self.assertNotEqual(run.returncode, 0)
        self.assertRegex(run.stdout.splitlines()[-1], "^1 passed, 1 failed, 1 skipped, 1 in part, ")

    def test_a_class_of_which_nothing_ran_is_skipped(self):
        run = self.carina("test", FOURTH='<testcase name="d" status="run"><system-out>SKIP   : '
                          'TestD::one() no lungs\nTotals: 2 passed, 0 failed, 3 skipped</system-out>'
                          '</testcase>')
        self.assertEqual(run.returncode, 0)
        self.assertRegex(run.stdout.splitlines()[-1], "^1 passed, 0 failed, 2 skipped, 1 in part, ")

    def test_the_warnings_of_lints_are_shown(self):
        run = self.carina("test", FOURTH='<testcase name="lint.size" status="run"><system-out>'
                          'warning: x.cpp: 401 lines</system-out></testcase>')
        self.assertIn("lint.size: warning: x.cpp: 401 lines", run.stdout)

    def test_a_pattern_without_tests_is_refused(self):
        run = self.carina("test", "nonsense")
        self.assertEqual(run.returncode, 2)
        self.assertIn("no test matches nonsense", run.stderr)
        self.assertEqual(self.called("ninja"), [])

    def test_a_pattern_builds_and_runs_a_part(self):
        self.assertEqual(self.carina("test", "engine.sync").returncode, 0)
        self.assertIn("tests/engine/sync/test_engine_sync", self.called("ninja")[-1])
        self.assertNotIn("tests/all", self.called("ninja")[-1])
        self.assertIn(" -R engine.sync", self.called("ctest")[-1])

    def test_reach_lists_what_no_program_calls(self):
        self.program("tests/reach", RECORD)
        self.assertEqual(self.carina("test", "--reach").returncode, 0)
        self.assertEqual(len(self.called("reach")), 1)

    def test_all_mutates_files_that_are_there(self):
        for name in ("reach", "mutate"):
            self.program(f"tests/{name}", RECORD)
        self.assertEqual(self.carina("test", "--all").returncode, 0)
        self.assertEqual(len(self.called("reach")), 1)
        mutated = self.called("mutate")[0].split()[1:]
        self.assertIn("engine/lungs/mechanics/lung_condition.cpp", mutated)
        self.assertEqual([], [name for name in mutated if not (ROOT / name).is_file()])

    def test_a_failed_build_is_shown_and_stops(self):
        self.program("bin/ninja", "#!/bin/sh\necho 'FAILED: x.o'\nexit 1\n")
        run = self.carina("lab", "help")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("FAILED: x.o", run.stderr)
        self.assertEqual(self.called("carina-lab"), [])

    def test_demo_says_what_to_do_without_a_display(self):
        run = self.carina("demo")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("--headless", run.stderr)

    def test_demo_starts_both_programs_on_one_port(self):
        run = self.carina("demo", "--patient", "child", DISPLAY=":none")
        self.assertEqual(run.returncode, 0, run.stderr)
        instructor, trainee = self.called("carina-instructor")[0], self.called("carina-trainee")[0]
        self.assertEqual(instructor.split()[2], trainee.split()[2])
        for call in (instructor, trainee):
            self.assertTrue(call.endswith("--patient child"), call)

    def test_demo_plays_an_intubation_that_the_console_assists_at(self):
        for arguments, script in (([], "good"), (["--intubation", "oesophageal"], "oesophageal")):
            run = self.carina("demo", *arguments, DISPLAY=":none")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertIn(f"--tracker simulated:intubation={script},after=60 ", self.called("carina-trainee")[-1])
            self.assertIn(f"--start --play {script}", self.called("carina-instructor")[-1])

    def test_demo_plays_none_where_a_tracker_is_named(self):
        run = self.carina("demo", "--tracker", "simulated:seed=2,intubation=slow", DISPLAY=":none")
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertNotIn("--play", self.called("carina-instructor")[0])

    def test_demo_takes_a_patient_in_words(self):
        for patient in ("adult, airway 250 mm", "child, girl", "45 years, 182 cm, man, obese"):
            run = self.carina("demo", "--patient", patient, DISPLAY=":none")
            self.assertEqual(run.returncode, 0, run.stderr)
            self.assertTrue(self.called("carina-trainee")[-1].endswith(f"--patient {patient}"), patient)

    def test_demo_registers_first_and_gives_the_site_to_the_trainee(self):
        run = self.carina("demo", "--register", "--output", "mono", DISPLAY=":none")
        self.assertEqual(run.returncode, 0, run.stderr)
        site = f"--site {self.root}/.local/share/carina/demo/site.json"
        self.assertIn(site, self.called("carina-registration")[0])
        self.assertIn(f"--output mono {site}", self.called("carina-trainee")[0])
        self.assertNotIn("--site", self.called("carina-instructor")[0])

    def test_demo_keeps_the_site_from_before(self):
        folder = self.root / ".local/share/carina/demo"
        folder.mkdir(parents=True)
        (folder / "site.json").write_text("old", encoding="utf-8")
        self.carina("demo", "--register", DISPLAY=":none")
        self.assertEqual((folder / "site-before.json").read_text(encoding="utf-8"), "old")

    def test_demo_ends_when_the_registration_fails(self):
        self.program("build/release/apps/registration/carina-registration", "#!/bin/sh\nexit 3\n")
        run = self.carina("demo", "--register", DISPLAY=":none")
        self.assertEqual((run.returncode, self.called("carina-trainee")), (3, []))

    def test_demo_ends_the_other_when_one_fails(self):
        self.program("build/release/apps/instructor/carina-instructor", "#!/bin/sh\nexec sleep 300\n")
        self.program("build/release/apps/trainee/carina-trainee", "#!/bin/sh\nexit 3\n")
        run = self.carina("demo", DISPLAY=":none")
        self.assertEqual(run.returncode, 3)  # and not TimeoutExpired: nobody waits for the other

    @unittest.skipUnless(shutil.which("Xvfb"), "no Xvfb")
    def test_headless_demo_measures_and_sums_up(self):
        (self.root / "set").mkdir()
        run = self.carina("demo", "--headless", "out", "--anatomy", "set", "--seconds", "2")
        self.assertEqual((run.returncode, run.stdout), (0, "{}\n"), run.stderr)
        self.assertEqual((self.root / "out/summary.json").read_text(encoding="utf-8"), "{}\n")
        self.assertEqual(self.called("carina-lab"),
                         [f"carina-lab anatomy import {self.root}/set",
                          f"carina-lab summary {self.root}/out"])
        # The console outlives the trainee, whose last picture is of a session that runs.
        for name, seconds in (("carina-instructor", 10), ("carina-trainee", 2)):
            self.assertIn(f"--measure {self.root}/out --size 1280x800", self.called(name)[0])
            self.assertIn(f" --seconds {seconds}", self.called(name)[0])
        # What it measures of the breathing is as the console sets it.
        self.assertNotIn("--play", self.called("carina-instructor")[0])
        self.assertIn("--tracker simulated ", self.called("carina-trainee")[0])

    @unittest.skipUnless(shutil.which("Xvfb"), "no Xvfb")
    def test_headless_demo_fails_with_its_program_and_shows_why(self):
        self.program("build/release/apps/trainee/carina-trainee", "#!/bin/sh\necho no sight\nexit 4\n")
        run = self.carina("demo", "--headless", "out")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("no sight", run.stderr)
        self.assertFalse((self.root / "out/summary.json").exists())


if __name__ == "__main__":
    unittest.main()
