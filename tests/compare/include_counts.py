#!/usr/bin/env python3
"""How many sources of sim, ui and app include each header of sim/, directly or through others.

Usage: include_counts.py TREE [HEADER...]
Prints lines `number header`, the largest first; with headers, these alone in the order given. The
first line of output is the number of sources. Our includes name their path from the top of the tree
(the structure test sees to it), so the counts are those of a build that compiles file by file.
"""
import re
import sys
from collections import Counter
from pathlib import Path

INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)


def include_graph(tree, rooms=("sim", "ui", "app")):
    """The files of the rooms with what each includes, as names from the top of the tree."""
    files = [f for room in rooms for f in (tree / room).rglob("*") if f.suffix in (".h", ".cpp")]
    names = {str(f.relative_to(tree)) for f in files}

    def named(file, include):
        beside = str(file.relative_to(tree).parent / include)  # as tests name what stands beside them
        return beside if include not in names and beside in names else include

    return {str(f.relative_to(tree)): [named(f, i) for i in INCLUDE.findall(f.read_text(encoding="utf-8"))]
            for f in files}


def included(file, includes):
    """All files of the tree that `file` includes, over any number of steps."""
    seen, waiting = set(), [file]
    while waiting:
        for name in includes.get(waiting.pop(), ()):
            if name not in seen:
                seen.add(name)
                waiting.append(name)
    return seen


def main(tree, wanted):
    includes = include_graph(tree)
    sources = [name for name in includes if name.endswith(".cpp")]
    counts = Counter(header for source in sources for header in included(source, includes))
    print(len(sources))
    if wanted:
        for header in wanted:
            print(counts[header], header)
        return
    for header, count in sorted(counts.items(), key=lambda item: (-item[1], item[0])):
        if header.startswith("sim/"):
            print(count, header)


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2:])
