#!/usr/bin/env python3
"""Tests of include_counts.py on a small tree."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).with_name("include_counts.py")
TREE = {
    "sim/core/a.h": "",
    "sim/core/b.h": '#include "sim/core/a.h"\n',
    "sim/core/a.cpp": '#include "sim/core/a.h"\n',
    "sim/core/b.cpp": '#include <vector>\n#include "sim/core/b.h"\n',
    "ui/w.h": '#include "ui/v.h"\n',
    "ui/v.h": '#include "ui/w.h"\n#include "sim/core/b.h"\n',  # a circle ends
    "ui/w.cpp": '#include "ui/w.h"\n// #include "sim/core/none.h"\n',
    "tests/t.cpp": '#include "sim/core/a.h"\n',  # tests do not count
}


class IncludeCounts(unittest.TestCase):
    def counts(self, *headers):
        with tempfile.TemporaryDirectory() as folder:
            for name, text in TREE.items():
                file = Path(folder) / name
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text)
            (Path(folder) / "app").mkdir()
            run = subprocess.run([sys.executable, SCRIPT, folder, *headers], capture_output=True, text=True, check=True)
            return run.stdout.splitlines()

    def test_over_any_number_of_steps(self):
        self.assertEqual(self.counts(), ["3", "3 sim/core/a.h", "2 sim/core/b.h"])

    def test_only_the_headers_asked_for(self):
        self.assertEqual(self.counts("ui/v.h", "sim/core/none.h"), ["3", "1 ui/v.h", "0 sim/core/none.h"])


if __name__ == "__main__":
    unittest.main()
