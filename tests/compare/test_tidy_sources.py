#!/usr/bin/env python3
"""Tests of tidy_sources.py on a small tree with a build that joins b.cpp and c.cpp and leaves a.cpp alone."""
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).with_name("tidy_sources.py")
TREE = {
    ".gitignore": "build/\n",
    "sim/core/a.h": "",
    "sim/core/b.h": '#include "sim/core/a.h"\n',
    "sim/core/a.cpp": '#include "sim/core/a.h"\n',
    "sim/core/b.cpp": '#include <vector>\n#include "sim/core/b.h"\n',
    "sim/core/c.cpp": "",
    "ui/w.h": '#include "sim/core/b.h"\n',
    "ui/w.cpp": '#include "ui/w.h"\n',
    "tests/t.cpp": '#include "sim/core/a.h"\n',
    "tests/room/fixture.h": "",
    "tests/room/test_f.cpp": '#include "fixture.h"\n#include "sim/core/a.h"\n#include "test_f.moc"\n',
}


@unittest.skipUnless(shutil.which("git"), "git tells what changed")
class TidySources(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.tree = Path(self.folder.name).resolve()
        for name, text in TREE.items():
            self.write(name, text)
        self.git("init", "-q")
        self.git("add", ".")
        self.git("-c", "user.name=t", "-c", "user.email=t@t", "commit", "-qm", "one")
        joined = "".join(f'#include "{self.tree}/sim/core/{s}.cpp"\n\n' for s in "bc")
        self.write("build/sim/Unity/unity_0_cxx.cxx", joined)
        files = ["build/sim/Unity/unity_0_cxx.cxx", "sim/core/a.cpp", "ui/w.cpp", "tests/t.cpp",
                 "tests/room/test_f.cpp", "build/ui/ui_autogen/mocs_compilation.cpp"]
        self.write("build/compile_commands.json", json.dumps(
            [{"directory": str(self.tree), "file": f"{self.tree}/{f}", "command": f"c++ -o x.o -c {self.tree}/{f}"}
             for f in files]))

    def write(self, name, text):
        file = self.tree / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def git(self, *arguments):
        subprocess.run(["git", "-C", self.tree, *arguments], check=True, capture_output=True)

    def checked(self, *arguments):
        """What clang-tidy would see, a batch as its sources."""
        folder = self.tree / "build/checked"
        run = subprocess.run([sys.executable, SCRIPT, self.tree, self.tree / "build", folder, *arguments],
                             capture_output=True, text=True, check=True)
        files = list(filter(None, run.stdout.split("\0")))
        entries = json.loads((folder / "compile_commands.json").read_text())
        self.assertEqual([e["file"] for e in entries], files)
        found = set()
        for file in files:
            text = Path(file).read_text() if Path(file).parent == folder else f'#include "{file}"'
            found.add("+".join(sorted(line.split("core/")[-1].split("/")[-1].rstrip('"') for line in text.splitlines())))
        return found

    def test_everything(self):
        everything = {"b.cpp+c.cpp", "a.cpp", "w.cpp", "t.cpp", "test_f.cpp"}
        self.assertEqual(self.checked(), everything)
        self.assertEqual(self.checked("--since", "0123abc"), everything)
        self.write(".clang-tidy", "")
        self.assertEqual(self.checked("--since", "HEAD"), everything)

    def test_nothing_changed(self):
        self.assertEqual(self.checked("--since", "HEAD"), set())

    def test_a_header_brings_its_sources_but_no_tests(self):
        self.write("sim/core/a.h", "// changed")
        self.assertEqual(self.checked("--since", "HEAD"), {"b.cpp", "a.cpp", "w.cpp"})

    def test_a_test_comes_with_its_source_and_its_fixture(self):
        self.write("tests/room/fixture.h", "// changed")
        self.assertEqual(self.checked("--since", "HEAD"), {"test_f.cpp"})
        self.assertTrue((self.tree / "build/checked/moc/test_f.moc").is_file())
        self.write("tests/.clang-tidy", "")
        self.assertEqual(self.checked("--since", "HEAD"), {"test_f.cpp", "t.cpp"})

    def test_commits_count_as_edits_do(self):
        self.write("sim/core/c.cpp", "// changed")
        self.git("-c", "user.name=t", "-c", "user.email=t@t", "commit", "-qam", "two")
        self.assertEqual(self.checked("--since", "HEAD~1"), {"c.cpp"})
        self.assertEqual(self.checked("--since", "HEAD"), set())


if __name__ == "__main__":
    unittest.main()
