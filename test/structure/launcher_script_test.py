#!/usr/bin/env python3
"""The script ./twinbus, in a copy of the tree's outside with invented packages, compilers and package managers."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def executable(path, text):
    path.write_text(text)
    path.chmod(0o755)


class Script(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        shutil.copy(ROOT / "twinbus", self.root / "twinbus")
        (self.root / "config").mkdir()
        self.bin = self.root / "fakes"
        self.bin.mkdir()
        self.calls = self.root / "calls"
        # dpkg knows one package as installed; apt-get writes down what it is asked for.
        executable(self.bin / "dpkg-query", "#!/bin/sh\nprintf 'installed there\\nnot-installed gone\\n'\n")
        executable(self.bin / "apt-get", f"#!/bin/sh\necho apt-get \"$@\" >>{self.calls}\n")
        executable(self.bin / "sudo", "#!/bin/sh\nexec \"$@\"\n")
        # configures and builds a program that says what it was given
        executable(self.bin / "cmake", f"""#!/bin/sh
echo cmake "$@" >>{self.calls}
case $1 in --preset) build=$4; mkdir -p "$build/bin"; touch "$build/build.ninja";; --build) build=$2;; esac
printf '#!/bin/sh\\necho program "$@"\\n' >"$build/bin/twinbus"; chmod +x "$build/bin/twinbus"
""")
        for program in ("ninja", "c++"):
            executable(self.bin / program, "#!/bin/sh\nexit 1\n")
        self.packages("there  a reason\n")

    def tearDown(self):
        self.folder.cleanup()

    def packages(self, text):
        (self.root / "config" / "packages.txt").write_text("# comment\n" + text)

    def environment(self, **settings):
        ours = {name: value for name, value in os.environ.items() if not name.startswith("TWINBUS_")}  # what CI sets is not for these
        return dict(ours, **{"PATH": f"{self.bin}:{os.environ['PATH']}", **settings})

    def run_script(self, *words, **settings):
        return subprocess.run([self.root / "twinbus", *words], capture_output=True, text=True, env=self.environment(**settings),
                              stdin=subprocess.DEVNULL, timeout=60)

    def said(self):
        return self.calls.read_text() if self.calls.exists() else ""

    def test_builds_and_hands_over(self):
        done = self.run_script("up", "stand", "--for", "3")
        self.assertEqual((done.returncode, done.stdout), (0, "program up stand --for 3\n"), done.stderr)
        self.assertNotIn("apt-get", self.said())

    def test_installs_what_is_missing_and_says_so(self):
        self.packages("there  a\ngone  b\nother  c\nspy: window  d\n")
        done = self.run_script("up")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("gone other", done.stderr)
        self.assertIn("gone other", self.said())
        self.assertNotIn("window", self.said())

    def test_installs_for_one_command_only(self):
        self.packages("there  a\nspy: window  d\n")
        self.run_script("spy")
        self.assertIn("window", self.said())

    def test_goes_on_without_what_it_can_do_without(self):
        self.packages("there  a\nany?: window  d\n")
        executable(self.bin / "apt-get", "#!/bin/sh\nexit 1\n")
        done = self.run_script("up")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("goes on without window", done.stderr)

    def test_no_install_forbids_it_and_names_the_remedy(self):
        self.packages("gone  b\n")
        done = self.run_script("--no-install", "up")
        self.assertEqual(done.returncode, 1)
        self.assertIn("apt-get install gone", done.stderr)
        self.assertEqual(self.said(), "")

    def test_an_account_without_root_gets_one_sentence_to_pass_on(self):
        self.packages("there  a\ngone  b\nother  c\n")
        executable(self.bin / "id", "#!/bin/sh\necho 1000\n")
        executable(self.bin / "sudo", "#!/bin/sh\nexit 1\n")
        done = self.run_script("up")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertIn("administrator to run: apt-get install gone other", done.stderr)
        self.assertEqual(self.said(), "")
        # What it can do without is no reason to stop.
        self.packages("there  a\nany?: window  d\n")
        done = self.run_script("up")
        self.assertEqual((done.returncode, done.stdout), (0, "program up\n"), done.stderr)
        self.assertIn("goes on without window", done.stderr)

    def test_packages_of_one_distribution_only(self):
        release = self.root / "os-release"
        self.packages("there  a\ngone [debian]  b\nother [!debian-13]  c\nspy: window [ubuntu-24.04 debian-13]  d\n")
        for text, wanted in (("ID=debian\nVERSION_ID=\"13\"\n", "gone window"), ("ID=ubuntu\nVERSION_ID=22.04\n", "other"),
                             ("ID=ubuntu\nVERSION_ID=24.04\n", "other window"), ("ID=debian\nVERSION_ID=12\n", "gone other")):
            release.write_text(text)
            done = self.run_script("--no-install", "spy", TWINBUS_OS_RELEASE=str(release))
            self.assertTrue(done.stderr.endswith(f"apt-get install {wanted}\n"), (text, done.stderr))

    def test_builds_elsewhere(self):
        elsewhere = self.root / "else where"
        done = self.run_script("up", TWINBUS_BUILDS=str(elsewhere))
        self.assertEqual((done.returncode, done.stdout), (0, "program up\n"), done.stderr)
        self.assertTrue((elsewhere / "release" / "bin" / "twinbus").exists())
        self.assertFalse((self.root / "build").exists())

    def test_a_moved_or_copied_build_folder_is_told_and_made_anew(self):
        self.run_script("up")
        build = self.root / "build/release"
        for tree, place, moved in ((self.root, build, False), ("/old/tree", build, True), (self.root, "/old/tree/build/release", True)):
            (build / "CMakeCache.txt").write_text(f"CMAKE_HOME_DIRECTORY:INTERNAL={tree}\nCMAKE_CACHEFILE_DIR:INTERNAL={place}\n")
            self.calls.unlink()
            done = self.run_script("up")
            self.assertEqual((done.returncode, done.stdout), (0, "program up\n"), done.stderr)
            self.assertEqual("was moved or copied" in done.stderr, moved, done.stderr)
            self.assertEqual("cmake --preset release" in self.said(), moved, self.said())

    def test_what_cannot_be_written_is_one_sentence_with_the_remedy(self):
        done = self.run_script("up", TWINBUS_BUILDS="/proc/nothing/here")
        self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (1, "", 1), done.stderr)
        self.assertIn("TWINBUS_BUILDS=", done.stderr)

    def test_a_missing_program_is_named_with_its_package(self):
        (self.bin / "ninja").unlink()
        done = self.run_script("up", PATH=f"{self.bin}:{self.tools_without('ninja', 'ctest')}")
        self.assertEqual(done.returncode, 1)
        self.assertIn("apt-get install ninja-build", done.stderr)

    def tools_without(self, *names):
        folder = self.root / "tools"
        folder.mkdir()
        for place in ("/usr/bin", "/bin"):
            for tool in pathlib.Path(place).iterdir():
                if tool.name not in names and not (folder / tool.name).exists():
                    (folder / tool.name).symlink_to(tool)
        return folder

    def test_the_newest_clang_that_makes_fuzzers_is_taken(self):
        for number, works in ((97, True), (98, True), (99, False)):
            executable(self.bin / f"clang++-{number}", f"#!/bin/sh\ncat >/dev/null; exit {0 if works else 1}\n")
        executable(self.bin / "ctest", "#!/bin/sh\necho 100% tests passed, 0 tests failed out of 1\n")
        (self.root / "CMakePresets.json").write_text('{"testPresets": [{"name": "release"}, {"name": "asan"}, {"name": "tsan"},'
                                                     ' {"name": "fuzz", "filter": {"include": {"label": "fuzz"}}}]}')
        self.run_script("test")
        self.assertIn("clang++-98", self.said())
        self.assertNotIn("clang++-99", self.said())

    def test_a_stop_never_waits_for_a_build(self):
        self.run_script("up")
        self.calls.unlink()
        self.packages("gone  b\n")
        for word in ("stop", "clear", "status", "doctor"):
            done = self.run_script(word)
            self.assertEqual(done.stdout, f"program {word}\n")
        self.assertEqual(self.said(), "")

    def test_what_needs_no_build_does_not_wait_for_another_one(self):
        self.run_script("up")
        for program in ("twinbus_gamepad", "twinbus_recorder", "twinbus_log_viewer"):
            executable(self.root / "build/release/bin" / program, "#!/bin/sh\n")
        with subprocess.Popen(["flock", "--no-fork", self.root / "build/.lock", "sleep", "600"]) as other:
            time.sleep(0.3)
            self.calls.unlink()
            for word in ("walk", "mode", "pose", "reach", "switch", "push", "sim", "restart", "log", "env", "record", "view", "gamepad"):
                done = self.run_script(word, str(self.calls.parent))
                self.assertEqual((done.returncode, done.stdout), (0, f"program {word} {self.calls.parent}\n"), done.stderr)
                self.assertIn("another build goes on", done.stderr)
            self.assertEqual(self.said(), "")
            (self.root / "build/release/bin/twinbus_gamepad").unlink()  # its first build goes on
            waits = subprocess.Popen([self.root / "twinbus", "gamepad"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                     env=self.environment(), stdin=subprocess.DEVNULL)
            self.assertIn("waits for another build", waits.stderr.readline())
            other.terminate()
        self.assertEqual(waits.communicate(timeout=60)[0], "program gamepad\n")
        self.assertEqual(self.run_script("walk").stdout, "program walk\n")
        self.assertIn("cmake --build", self.said())

    def sources(self):
        for folder in ("launcher", "test", "campaign", "python"):
            (self.root / folder).symlink_to(ROOT / folder)

    def test_spy_check_installs_and_builds_nothing(self):
        self.sources()
        self.packages("gone  b\nspy: window  d\n")
        for _ in range(2):
            done = self.run_script("spy", "--check")
            self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
            self.assertIn("types.jar, so nothing would be decoded", done.stderr)
            self.assertEqual(self.said(), "")
            (self.root / "build/release/bin").mkdir(parents=True, exist_ok=True)  # with a program too
            executable(self.root / "build/release/bin/twinbus", "#!/bin/sh\necho program\n")

    def test_a_bench_or_chart_without_a_known_name_is_answered_without_a_build(self):
        self.sources()
        for word, some in (("bench", ("control", "any_robot", "explorer", "planner")), ("chart", ("walk", "guard"))):
            for words in ((word,), (word, "--help"), (word, "-h")):
                done = self.run_script(*words)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                for name in some:
                    self.assertRegex(done.stdout, rf"\s{name}\s")
            done = self.run_script(word, "nosuch")
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertRegex(done.stderr, rf"^{word}: no {word} 'nosuch'; known: \w+, .*; ./twinbus {word} lists all\n$")
            self.assertIn("did you mean planner?", self.run_script(word, "plannr").stderr)
        done = self.run_script("bench", "kinematics", "--help")
        self.assertIn("one call of the robot library", done.stdout)
        self.assertEqual(self.said(), "")
        self.run_script("bench", "kinematics")
        self.assertIn("--target all", self.said())

    def test_every_bench_that_is_built_is_known(self):
        self.sources()
        listed = re.findall(r"(?m)^  (\w+)", self.run_script("bench").stdout)
        built = set()
        for file in (ROOT / "test").glob("*/CMakeLists.txt"):
            built.update(re.findall(r"(?:add_executable\(|OUTPUT_NAME )(\w+)_bench\b(?! EXCLUDE_FROM_ALL)", file.read_text()))
        built.update(path.stem[6:] for path in (ROOT / "test/bench").glob("bench_*.py"))
        self.assertGreater(len(built), 25)
        self.assertFalse(built - set(listed), "not in the table of launcher/operate/tools.cpp")

    def test_a_log_that_is_not_there_is_told_without_a_build(self):
        self.sources()
        for words in (("view", "nosuch.log"), ("view", str(self.calls.parent), "nosuch.log"), ("replay", "nosuch.log"), ("log", "info", "nosuch.log"),
                      ("log", "compare", str(self.calls.parent), "nosuch.log")):
            done = self.run_script(*words)
            self.assertEqual((done.returncode, done.stdout), (1, ""), done.stderr)
            self.assertRegex(done.stderr, rf"^twinbus: {words[0]}: no log 'nosuch.log': .*\n$")
        self.assertEqual(self.said(), "")
        (self.root / "runs/one").mkdir(parents=True)
        for words in (("view", "one"), ("view",), ("view", "--port", "1"), ("view", "http://127.0.0.1/#log=x"), ("log", "cut", str(self.root), "new.log")):
            self.assertEqual(self.run_script(*words).stdout, " ".join(("program", *words)) + "\n")

    def test_help_of_every_command_without_its_program(self):
        self.sources()
        for line in (ROOT / "launcher/main.cpp").read_text().splitlines():
            found = re.match(r'    \{"(\w+)", "', line)
            if found and found[1] not in ("scenes", "doctor"):
                done = self.run_script(found[1], "--help")
                self.assertEqual(done.returncode, 0, found[1] + done.stderr)
                self.assertRegex(done.stdout, rf"(?s)usage: .*\./twinbus {found[1]}\b.*\n.*\w", found[1])
        said = self.run_script("up", "stand", "--help").stdout
        self.assertTrue(said.startswith("usage: ./twinbus up [SCENE]\nStarts the processes"), said)
        self.assertIn("\n  --report F  writes the figures as JSON", said)
        self.assertIn("usage: ./twinbus log info FILE\n", self.run_script("log", "info", "--help").stdout)
        self.assertEqual(self.said(), "")
        # While another build goes on, and the program of `view` is not there yet; once it is, the program says it.
        self.run_script("up")
        self.calls.unlink()
        with subprocess.Popen(["flock", "--no-fork", self.root / "build/.lock", "sleep", "600"]) as other:
            time.sleep(0.3)
            self.assertIn("look at a log", self.run_script("view", "--help").stdout)
            self.assertEqual(self.run_script("up", "--help").stdout, "program up --help\n")
            executable(self.root / "build/release/bin/twinbus_log_viewer", "#!/bin/sh\n")
            self.assertEqual(self.run_script("view", "--help").stdout, "program view --help\n")
            other.terminate()
        self.assertEqual(self.said(), "")

    def test_own_network_is_joined_by_programs_and_goes_in_front(self):
        done = self.run_script("up", "--own-network")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("in front of the command: ./twinbus --own-network up", done.stderr)
        mine = self.root / "mine"
        mine.mkdir()
        done = self.run_script("--own-network", "--", "mine", XDG_RUNTIME_DIR=str(mine))
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("first: ./twinbus --own-network up", done.stderr)
        (self.root / "build/release/bin").mkdir(parents=True)
        shutil.copy(shutil.which("sleep"), self.root / "build/release/bin/twinbus")
        executable(self.bin / "nsenter", "#!/bin/sh\necho nsenter \"$@\"\n")
        with subprocess.Popen([self.root / "build/release/bin/twinbus", "60"]) as stack:
            # An earlier command, which made the network, has ended.
            ended = subprocess.Popen(["true"])
            ended.wait()
            (mine / f"twinbus-network-{os.getuid()}").write_text(f"{ended.pid}\n{stack.pid}")
            time.sleep(0.2)
            done = self.run_script("--own-network", "--", "mine", "--fast", XDG_RUNTIME_DIR=str(mine))
            self.assertRegex(done.stdout, rf"^nsenter --target {stack.pid} .*--net mine --fast\n$", done.stderr)
            done = self.run_script("--own-network", "status", XDG_RUNTIME_DIR=str(mine))
            stack.terminate()
        self.assertRegex(done.stdout, rf"^nsenter --target {stack.pid} .*/twinbus status\n$", done.stderr)
        numbers = (mine / f"twinbus-network-{os.getuid()}").read_text().split()
        self.assertEqual((numbers[0], len(numbers)), (str(stack.pid), 2), "the command is one of them, who has ended is not")
        self.assertEqual(self.said(), "")

    def test_words_that_are_no_command_build_nothing(self):
        (self.root / "launcher").mkdir()
        shutil.copy(ROOT / "launcher" / "main.cpp", self.root / "launcher" / "main.cpp")
        done = self.run_script("wlak")
        self.assertEqual((done.returncode, done.stderr, self.said()), (2, "twinbus: no command 'wlak'; did you mean walk?\n", ""))
        self.run_script("up")
        self.calls.unlink()
        for word in ("wlak", ".", "up x", "u"):
            done = self.run_script(word)
            self.assertEqual((done.returncode, done.stdout, self.said()), (0, f"program {word}\n", ""), done.stderr)
        self.run_script("run", "stand")
        self.assertIn("cmake --build", self.said())

    def test_help_answers_at_once_without_a_build(self):
        (self.root / "launcher").mkdir()
        shutil.copy(ROOT / "launcher" / "main.cpp", self.root / "launcher" / "main.cpp")
        for words in ((), ("--help",), ("help",)):
            done = self.run_script(*words)
            self.assertEqual(done.returncode, 0, done.stderr)
            for line in ("usage: ./twinbus COMMAND", "  up        start and supervise", "  test      build", "--own-network -- PROGRAM", 'eval "$(./twinbus env)"'):
                self.assertIn(line, done.stdout)
        self.assertEqual(self.said(), "")

    def test_help_of_every_bench_and_chart_builds_nothing_and_needs_no_package(self):
        (self.root / "test").symlink_to(ROOT / "test")
        absent = self.root / "absent"
        absent.mkdir()
        for module in ("yaml", "numpy", "matplotlib", "mujoco", "torch", "onnxruntime", "pandas"):
            (absent / f"{module}.py").write_text("raise ImportError('not installed')\n")
        for script in sorted((ROOT / "test/bench").glob("bench_*.py")) + sorted((ROOT / "test/bench").glob("chart_*.py")):
            command, name = script.stem.split("_", 1)
            done = self.run_script(command, name, "--help", PYTHONPATH=str(absent))
            self.assertEqual(done.returncode, 0, script.name + done.stderr)
            self.assertIn(name, done.stdout, script.name)
        self.assertEqual(self.said(), "")

    def test_run_builds_no_more_than_it_needs(self):
        self.run_script("run", "stand")
        self.assertIn("--target twinbus_cli", self.said())
        self.assertNotIn("--target programs", self.said())

    def test_up_builds_what_the_stacks_start_and_a_command_its_program(self):
        for words, targets in ((["up"], "stack_programs"), (["restart"], "stack_programs"), (["up", "--face", "unitree_hg"], "programs"),
                               (["walk"], "twinbus_cli"), (["stop"], "twinbus_cli"), (["gamepad"], "twinbus_cli twinbus_gamepad"),
                               (["view"], "twinbus_cli twinbus_log_viewer"), (["env"], "programs")):
            shutil.rmtree(self.root / "build", ignore_errors=True)
            self.calls.unlink(missing_ok=True)
            self.run_script(*words)
            self.assertRegex(self.said(), f"(?m)--target {targets}$", words)

    def test_every_program_of_a_stack_is_built_by_up(self):
        made = {}  # name of the program: its target
        for file in ROOT.glob("*/**/CMakeLists.txt"):
            text = file.read_text()
            made.update((name, name) for name in re.findall(r"(?:add_executable|twinbus_control_main)\((\w+)", text))
            made.update((name, target) for target, name in re.findall(r"set_target_properties\((\w+) PROPERTIES OUTPUT_NAME (\w+)", text))
        built = re.search(r"set\(stack ([^)]*)\)", (ROOT / "launcher/CMakeLists.txt").read_text()).group(1).split()
        for file in (ROOT / "config/stacks").glob("*.yaml"):
            for program in re.findall(r"^\s*program: (\w+)", file.read_text(), re.MULTILINE):
                self.assertIn(made[program], built, f"{file.name} starts {program}: add its target to `stack` in launcher/CMakeLists.txt")

    def test_doctor_and_scenes_answer_at_once_without_a_build(self):
        scenes = self.root / "config/scenes"
        scenes.mkdir()
        (scenes / "one.yaml").write_text("# a comment\nabout: Stands still.\nduration: 3\n")
        (scenes / "two.yaml").write_text("about: Walks.\n")
        self.packages("there  a\ngone  b\n")
        executable(self.bin / "ip", "#!/bin/sh\nexit 0\n")
        done = self.run_script("scenes")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"(?m)^  one +Stands still\.\n  two +Walks\.$")
        self.assertNotIn("two", self.run_script("scenes", "STAND", "one").stdout)
        done = self.run_script("scenes", "twp")
        self.assertEqual((done.returncode, done.stderr), (1, "twinbus: no scene has all of these words; did you mean two?; ./twinbus scenes lists all\n"))
        done = self.run_script("doctor")
        self.assertEqual((done.returncode, done.stderr), (1, ""))
        self.assertIn("MISSING  packages are missing: gone\n         mend: ./twinbus up, or sudo apt-get install gone", done.stdout)
        self.assertIn("nothing is built yet", done.stdout)
        self.packages("there  a\n")
        self.assertEqual(self.run_script("doctor").returncode, 0)
        for word in ("scenes", "doctor"):
            self.assertIn("usage: ./twinbus COMMAND", self.run_script(word, "--help").stdout)
        self.assertEqual(self.said(), "")
        self.run_script("up")
        self.calls.unlink()
        for word in ("scenes", "doctor"):  # after a change too
            self.assertEqual(self.run_script(word).stdout, f"program {word}\n")
        self.assertEqual(self.said(), "")

    def test_stdout_belongs_to_the_program(self):
        self.packages("gone  b\n")
        self.assertEqual(self.run_script("env").stdout, "program env\n")

    def test_a_build_that_fails_is_one_line_and_exit_status_1(self):
        executable(self.bin / "cmake", "#!/bin/sh\ncase $1 in --build) echo error: no such thing; exit 1;; esac\n"
                                       "mkdir -p $4; touch $4/build.ninja\n")
        done = self.run_script("up")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no such thing", done.stderr)
        self.assertEqual(done.stdout, "")

    def test_a_library_that_cmake_misses_is_one_line_with_its_package(self):
        executable(self.bin / "cmake", "#!/bin/sh\necho CMake Error\necho '  ode (x) is missing; run: apt-get install libode-dev'\nexit 1\n")
        done = self.run_script("up")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr.splitlines()[-1], "twinbus: ode (x) is missing; run: apt-get install libode-dev")
        self.assertEqual(len(done.stderr.splitlines()), 2, done.stderr)

    def test_what_builds_the_container_and_the_clean_root_builds(self):
        for file, line in (("Dockerfile", r"^RUN ./twinbus (\S+)$"), ("test/clean_root/clean_root.sh", r"shared ./twinbus (\S+) .*>/dev/null")):
            command = re.search(line, (ROOT / file).read_text(), re.MULTILINE).group(1)
            self.calls.unlink(missing_ok=True)
            shutil.rmtree(self.root / "build", ignore_errors=True)
            self.run_script(command)
            self.assertIn("--target programs", self.said(), f"{file}: {command}")

    def test_the_clean_root_has_a_time_limit_and_says_what_it_left_out(self):
        shutil.copy(ROOT / "CMakePresets.json", self.root)
        executable(self.bin / "ctest", "#!/bin/sh\necho 100% tests passed, 0 tests failed out of 1\n")
        (self.root / "test/clean_root").mkdir(parents=True)
        for status, by, result, said in ((0, "54", 0, "== clean root: given --within 900"), (77, "10", 0, "== clean root: given --within [56]"),
                                         (1, "54", 1, "failed after"), (1, "2", 0, "skipped, the rest took until minute 0 of 2")):
            executable(self.root / "test/clean_root/clean_root.sh", f"#!/bin/sh\necho clean root: given $*\nexit {status}\n")
            done = self.run_script("test", "-R", "x", "--clean-root-by", by)
            self.assertEqual(done.returncode, result, done.stdout + done.stderr)
            self.assertRegex(done.stdout, said)

    def test_wrong_arguments_of_test_exit_with_2(self):
        self.assertEqual(self.run_script("test", "--fulll").returncode, 2)
        self.assertEqual(self.run_script("test", "--help").returncode, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
