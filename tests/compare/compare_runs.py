#!/usr/bin/env python3
"""Compares what two builds left of the same run: every channel of the recordings and every metric.

    compare_runs.py OLD-FOLDER NEW-FOLDER [--tolerance R]

The folders are those of `rotorbench-cli run --output`. Numbers there have the shortest digits that
read back equal, so equal text is equal bits, and text is what is compared. What only the new folder
has passes and is listed; what it lacks, and what differs by more than R of the channel's range (of
a metric's size), fails. The last line of the output is a tally in plain numbers for the script that
calls: equal, new, tolerated, failed. Exit code 0 if all passed, 1 if not, 2 if the folders cannot
be read.
"""

import argparse
import csv
import json
import math
import sys
from dataclasses import dataclass, field
from operator import itemgetter
from pathlib import Path

# Measured with a clock: never the same twice.
CLOCK_FIGURES = {"wall_time"}


@dataclass
class Difference:
    """How far one channel or metric of the new run is from the old one."""

    name: str
    place: str  # where it is first seen, with both values
    absolute: float
    relative: float  # of the range of the old values

    def passes(self, tolerance):
        return tolerance is not None and self.relative <= tolerance

    def text(self):
        largest = f"largest {self.absolute:.3g}, relative {self.relative:.3g}"
        return f"{self.name}: {self.place}; {largest}"


@dataclass
class Comparison:
    """What came of one recording or of the metrics."""

    title: str
    tolerance: float | None = None
    equal: int = 0
    new: list = field(default_factory=list)
    excluded: list = field(default_factory=list)
    tolerated: list = field(default_factory=list)
    failures: list = field(default_factory=list)

    def judge(self, difference):
        passed = difference.passes(self.tolerance)
        (self.tolerated if passed else self.failures).append(difference.text())

    def counts(self):
        return [self.equal, len(self.new), len(self.tolerated), len(self.failures)]

    def lines(self):
        equal, new, tolerated, failed = self.counts()
        yield f"  {self.title:<44} {equal:>6} {new:>6} {tolerated:>9} {failed:>7}"
        if self.new:
            yield "    new: " + ", ".join(self.new)
        if self.excluded:
            yield "    not compared, measured with a clock: " + ", ".join(self.excluded)
        yield from (f"    within the tolerance: {line}" for line in self.tolerated)
        yield from (f"    FAILED {line}" for line in self.failures)


def gap(old, new):
    """Distance of two numbers given as text; infinite if only one of them is a number."""
    a, b = float(old), float(new)
    if a == b or (math.isnan(a) and math.isnan(b)):
        return 0.0
    distance = abs(a - b)
    return math.inf if math.isnan(distance) else distance


def relative_to(absolute, scale):
    if absolute == 0:
        return 0.0
    return absolute / scale if scale > 0 else math.inf


# Recordings


def header(path):
    """{name: (column, unit)} of a recording, in the order of the file."""
    with open(path, newline="", encoding="utf-8") as file:
        cells = next(csv.reader(file), [])
    channels = {}
    for column, cell in enumerate(cells):
        name, _, unit = cell.rpartition(" [")
        if name in channels:
            raise ValueError(f"{path}: two channels are called {name}")
        channels[name] = (column, unit.rstrip("]"))
    return channels


def rows(path):
    """The rows below the header as lists of text. No cell of a number is ever quoted."""
    with open(path, encoding="utf-8") as file:
        width = len(next(csv.reader([next(file, "")]), []))
        for count, line in enumerate(file, 1):
            cells = line.rstrip("\n").split(",")
            if len(cells) != width:
                found = f"row {count} has {len(cells)} cells below {width} channels"
                raise ValueError(f"{path}: {found}")
            yield cells


def value_range(path, columns):
    """{column: largest minus smallest finite value, or the magnitude of what never changes}"""
    low = dict.fromkeys(columns, math.inf)
    high = dict.fromkeys(columns, -math.inf)
    for row in rows(path):
        for column in columns:
            value = float(row[column])
            if math.isfinite(value):
                low[column] = min(low[column], value)
                high[column] = max(high[column], value)
    return {c: high[c] - low[c] if high[c] > low[c] else abs(low[c]) for c in columns}


def differing_columns(old, new, pairs):
    """What differs, {index of a pair: [first row, time, old, new, largest gap]}; rows compared, old
    rows and new rows."""
    found, common, old_count, new_count = {}, 0, 0, 0
    left, right = rows(old), rows(new)
    # Most rows are equal: one comparison for all of a row is much faster than one per cell.
    pick_old, pick_new = (itemgetter(*columns) for columns in zip(*pairs))
    while True:
        a, b = next(left, None), next(right, None)
        old_count += a is not None
        new_count += b is not None
        if a is None or b is None:
            old_count += sum(1 for _ in left)
            new_count += sum(1 for _ in right)
            return found, common, old_count, new_count
        common += 1
        if pick_old(a) == pick_new(b):
            continue
        for index, (i, j) in enumerate(pairs):
            if a[i] != b[j]:
                entry = found.setdefault(index, [common, a[0], a[i], b[j], 0.0])
                entry[4] = max(entry[4], gap(a[i], b[j]))


def same_bytes(old, new):
    if old.stat().st_size != new.stat().st_size:
        return False
    with open(old, "rb") as a, open(new, "rb") as b:
        while True:
            piece = a.read(1 << 20)
            if piece != b.read(1 << 20):
                return False
            if not piece:
                return True


def compare_recordings(old, new, tolerance):
    result = Comparison(new.name, tolerance)
    before, after = header(old), header(new)
    result.new = [name for name in after if name not in before]
    if same_bytes(old, new):
        result.equal = len(before)
        return result
    common = []
    for name, (_, unit) in before.items():
        if name not in after:
            result.failures.append(f"{name}: missing in the new recording")
        elif after[name][1] != unit:
            result.failures.append(f"{name}: unit {unit} became {after[name][1]}")
        else:
            common.append(name)
    if not common:
        return result
    pairs = [(before[name][0], after[name][0]) for name in common]
    found, compared, old_count, new_count = differing_columns(old, new, pairs)
    if old_count != new_count:
        became = f"{old_count} rows became {new_count}"
        result.failures.append(f"{became}; the first {compared} are compared")
    ranges = value_range(old, [pairs[index][0] for index in found])
    first = next(iter(before), "")
    for index, (row, time, a, b, largest) in sorted(found.items()):
        place = f"first in row {row} ({first} {time}), {a} became {b}"
        relative = relative_to(largest, ranges[pairs[index][0]])
        result.judge(Difference(common[index], place, largest, relative))
    result.equal = len(common) - len(found)
    return result


# Metrics


def metric_values(path):
    """({run or name: text or None}, {name: unit}) of metrics.json, numbers as they are written."""
    with open(path, encoding="utf-8") as file:
        document = json.load(file, parse_float=str, parse_int=str)
    values = {}
    for line in document["metrics"]:
        run = line["run"]
        for name, text in line.items():
            if name != "run":
                values[(run, name)] = text
    return values, document["units"]


def compare_metrics(old, new, tolerance):
    result = Comparison(new.name, tolerance)
    (before, old_units), (after, new_units) = metric_values(old), metric_values(new)

    def label(key):
        return f"{key[1]} of {key[0]}" if key[0] else key[1]

    result.new = [label(key) for key in after if key not in before]
    for key, a in before.items():
        name = key[1]
        if key not in after:
            result.failures.append(f"{label(key)}: missing in the new metrics")
        elif name in CLOCK_FIGURES:
            result.excluded.append(label(key))
        elif old_units[name] != new_units[name]:
            result.failures.append(f"{label(key)}: unit {old_units[name]} became {new_units[name]}")
        elif after[key] == a:
            result.equal += 1
        else:
            b = after[key]
            # A figure that does not exist is null.
            largest = math.inf if a is None or b is None else gap(a, b)
            scale = 0 if a is None or b is None else max(abs(float(a)), abs(float(b)))
            place = f"{a} became {b}"
            result.judge(Difference(label(key), place, largest, relative_to(largest, scale)))
    return result


def compare_folders(old, new, tolerance):
    def results(folder):
        return {path.name for path in folder.glob("*.csv")} | {"metrics.json"}

    # Two empty folders would be equal.
    if not any(old.glob("*.csv")) or not (old / "metrics.json").exists():
        raise ValueError(f"{old}: no recording or no metrics, so there is nothing to compare with")
    comparisons = []
    for name in sorted(results(old) | results(new)):
        if not (old / name).exists():
            comparisons.append(Comparison(name, new=["the whole file"]))
        elif not (new / name).exists():
            comparisons.append(Comparison(name, failures=["the whole file is missing"]))
        elif name == "metrics.json":
            comparisons.append(compare_metrics(old / name, new / name, tolerance))
        else:
            comparisons.append(compare_recordings(old / name, new / name, tolerance))
    return comparisons


def not_negative(text):
    value = float(text)
    if not 0 <= value < math.inf:
        raise ValueError
    return value


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old", type=Path)
    parser.add_argument("new", type=Path)
    parser.add_argument("--tolerance", type=not_negative, metavar="R")
    options = parser.parse_args()
    try:
        comparisons = compare_folders(options.old, options.new, options.tolerance)
    except (OSError, ValueError, KeyError) as error:
        print(f"compare_runs.py: {error}", file=sys.stderr)
        return 2
    for comparison in comparisons:
        print("\n".join(comparison.lines()))
    print(*(sum(column) for column in zip(*(c.counts() for c in comparisons))))
    return 1 if any(c.failures for c in comparisons) else 0


if __name__ == "__main__":
    sys.exit(main())
