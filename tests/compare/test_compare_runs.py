#!/usr/bin/env python3
"""compare_runs.py as run.sh uses it: folders of two runs in, table and exit code out."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOOL = Path(__file__).with_name("compare_runs.py")

CHANNELS = ["time [s]", "height [m]", "rotor1.thrust [N]"]
ROWS = [["0", "0", "4.5"], ["0.001", "2", "4.5"], ["0.002", "nan", "4.5"], ["0.003", "4", "4.5"]]
METRICS = {"overshoot": "0.25", "wall_time": "0.1", "rise_time": "null"}


def write_run(folder, channels=CHANNELS, rows=ROWS, metrics=METRICS, name="recording.csv"):
    folder.mkdir(exist_ok=True)
    lines = [",".join(channels)] + [",".join(row) for row in rows]
    (folder / name).write_text("\n".join(lines) + "\n", encoding="utf-8")
    figures = "".join(f', "{key}": {value}' for key, value in metrics.items())
    units = json.dumps({key: "s" for key in metrics})
    (folder / "metrics.json").write_text(
        f'{{"metrics": [{{"run": ""{figures}}}], "units": {units}}}', encoding="utf-8"
    )


def changed(row, column, text):
    rows = [list(cells) for cells in ROWS]
    rows[row][column] = text
    return rows


class CompareRuns(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.old, self.new = Path(folder.name) / "old", Path(folder.name) / "new"
        write_run(self.old)

    def compare(self, *options):
        done = subprocess.run(
            [sys.executable, TOOL, self.old, self.new, *options],
            capture_output=True,
            text=True,
            check=False,
        )
        return done.returncode, done.stdout, done.stderr

    def expect(self, code, counts, *options):
        """The exit code, and equal, new, tolerated, failed; returns what was printed."""
        found, out, err = self.compare(*options)
        self.assertEqual((found, out.splitlines()[-1:]), (code, [counts]), out + err)
        return out

    def test_equal_runs_pass_and_the_clock_is_not_compared(self):
        write_run(self.new, metrics=METRICS | {"wall_time": "0.2"})
        self.assertIn("clock: wall_time", self.expect(0, "5 0 0 0"))

    def test_new_channels_and_metrics_pass_between_the_old_ones(self):
        rows = [[r[0], "7", *r[1:]] for r in ROWS]
        channels = [CHANNELS[0], "tilt [rad]", *CHANNELS[1:]]
        write_run(self.new, channels, rows, METRICS | {"settling_time": "3"})
        out = self.expect(0, "5 2 0 0")
        self.assertIn("new: tilt", out)
        self.assertIn("new: settling_time", out)

    def test_a_difference_beside_a_new_channel_is_found(self):
        rows = [[r[0], "7", *r[1:]] for r in changed(3, 1, "4.002")]
        write_run(self.new, [CHANNELS[0], "tilt [rad]", *CHANNELS[1:]], rows)
        out = self.expect(1, "4 1 0 1")
        self.assertIn("FAILED height: first in row 4 (time 0.003), 4 became 4.002", out)

    def test_missing_channels_metrics_and_files_fail(self):
        write_run(self.new, CHANNELS[:2], [r[:2] for r in ROWS], {"wall_time": "0.1"})
        write_run(self.old, name="recording-RK4.csv")
        out = self.expect(1, "2 0 0 4")
        self.assertIn("rotor1.thrust: missing", out)
        self.assertIn("overshoot: missing", out)
        self.assertIn("the whole file is missing", out)

    def test_the_last_bit_of_a_double_is_found_and_measured(self):
        write_run(self.new, rows=changed(1, 1, "2.0000000000000004"))
        out = self.expect(1, "4 0 0 1")
        # One bit of 2 is 4.44e-16; height goes from 0 to 4.
        self.assertIn("2 became 2.0000000000000004; largest 4.44e-16, relative 1.11e-16", out)

    def test_tolerance_is_a_share_of_the_range(self):
        write_run(self.new, rows=changed(1, 1, "2.004"))
        self.expect(1, "4 0 0 1", "--tolerance", "0.00099")
        out = self.expect(0, "4 0 1 0", "--tolerance", "0.00101")
        self.assertIn("within the tolerance: height: first in row 2", out)

    def test_a_constant_channel_is_measured_by_its_magnitude(self):
        write_run(self.new, rows=changed(0, 2, "4.50045"))
        self.expect(1, "4 0 0 1", "--tolerance", "0.9e-4")
        self.expect(0, "4 0 1 0", "--tolerance", "1.1e-4")

    def test_no_tolerance_hides_a_number_that_became_none(self):
        write_run(self.new, rows=changed(1, 1, "nan"), metrics=METRICS | {"overshoot": "null"})
        self.expect(1, "3 0 0 2", "--tolerance", "1e9")
        write_run(self.new, rows=changed(2, 1, "0"), metrics=METRICS | {"rise_time": "1"})
        self.expect(1, "3 0 0 2", "--tolerance", "1e9")

    def test_the_sign_of_zero_is_a_difference_of_bits(self):
        write_run(self.new, rows=changed(0, 1, "-0"))
        self.expect(1, "4 0 0 1")
        self.expect(0, "4 0 1 0", "--tolerance", "0")

    def test_another_number_of_rows_fails_whatever_the_tolerance(self):
        write_run(self.new, rows=ROWS[:3])
        self.assertIn("4 rows became 3", self.expect(1, "5 0 0 1", "--tolerance", "1"))
        write_run(self.new, rows=[*ROWS, ["0.004", "5", "4.5"]])
        self.assertIn("4 rows became 5", self.expect(1, "5 0 0 1", "--tolerance", "1"))

    def test_another_unit_fails(self):
        write_run(self.new, ["time [s]", "height [ft]", "rotor1.thrust [N]"])
        self.assertIn("height: unit m became ft", self.expect(1, "4 0 0 1"))

    def test_a_metric_is_measured_by_its_own_size(self):
        write_run(self.new, metrics=METRICS | {"overshoot": "0.25025"})
        self.assertIn("overshoot: 0.25 became 0.25025", self.expect(1, "4 0 0 1"))
        self.expect(0, "4 0 1 0", "--tolerance", "0.001")

    def test_what_cannot_be_read_is_said(self):
        self.assertEqual(self.compare()[0], 1)  # the new build left nothing
        write_run(self.new)
        for wrong in ["-1", "nan", "much"]:
            self.assertEqual(self.compare("--tolerance", wrong)[0], 2)
        write_run(self.new, rows=[["0", "1"]])
        code, _, err = self.compare()
        self.assertEqual(code, 2)
        self.assertIn("row 1 has 2 cells below 3 channels", err)
        for file in self.old.iterdir():
            file.unlink()
        code, _, err = self.compare()
        self.assertEqual(code, 2)
        self.assertIn("nothing to compare with", err)


if __name__ == "__main__":
    unittest.main()
