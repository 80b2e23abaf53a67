#!/usr/bin/env python3
"""Prints how measurements of a new build relate to those of an old one.

    ratio_table.py FOLDER

The folder has files old.N and new.N, measured next to each other, with lines `name unit value`.
The ratio is the median of the ratios of the pairs, so that a load that changes slowly meets both
sides; the quartiles show how far the pairs scatter, and the ratio of the smallest values is what is
least disturbed by other programs.
"""

import statistics
import sys
from pathlib import Path


def readings(path):
    """{(name, unit): value}"""
    values = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        name, unit, value = line.split()
        values[(name, unit)] = float(value)
    return values


def quartiles(values):
    if len(values) < 2:
        return values[0], values[0]
    low, _, high = statistics.quantiles(values, n=4, method="inclusive")
    return low, high


def main():
    folder = Path(sys.argv[1])
    pairs = []
    for old in sorted(folder.glob("old.*")):
        pairs.append((readings(old), readings(folder / old.name.replace("old", "new"))))
    columns = f"{'old':>14} {'new':>14} {'new/old':>8}  {'quartiles':<13} {'smallest':>8} pairs"
    print(f"{'':<34} {columns}")
    for key in {key: None for pair in pairs for side in pair for key in side}:
        both = [(old[key], new[key]) for old, new in pairs if key in old and key in new]
        label = f"{key[0]} [{key[1]}]"
        if not both:
            side = "old" if any(key in old for old, _ in pairs) else "new"
            print(f"{label:<34} only in the {side} build")
            continue
        ratios = [new / old for old, new in both]
        low, high = quartiles(ratios)
        medians = [statistics.median(side) for side in zip(*both)]
        smallest = min(new for _, new in both) / min(old for old, _ in both)
        print(
            f"{label:<34} {medians[0]:>14.9g} {medians[1]:>14.9g} {statistics.median(ratios):>8.4f}"
            f"  {low:.4f}-{high:.4f} {smallest:>8.4f} {len(both):>5}"
        )


if __name__ == "__main__":
    main()
