#!/usr/bin/env python3
"""Which sources clang-tidy checks, and the commands it reads for them.

Usage: tidy_sources.py TREE BUILD FOLDER [--since COMMIT]
BUILD was configured by the tidy preset. Writes compile_commands.json into FOLDER and prints the files
to check, NUL-separated: what a unity build joins at once, for most of the time goes into the headers they
share (never what two of its batches hold: names of one source may stand in another again), and tests one
by one, each of them a program.

With --since, only what differs from that commit, in the working tree as in commits: changed sources,
sources of sim, ui and app that include a changed header over any number of steps, tests that include a
changed header of tests/. A header of sim/ does not bring back its tests: it was checked with its
sources, and one of sim/core would bring all of them, half an hour. A changed .clang-tidy brings back
everything in its folder. A commit that git does not know, as in a shallow clone, brings everything.
"""
import argparse
import json
import re
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from include_counts import include_graph, included  # noqa: E402

JOINED = re.compile(r'^#include "([^"]+)"$', re.MULTILINE)


def changed_files(tree, commit):
    """Names of the files that differ from a commit, or None if git does not know it."""
    def git(*arguments):
        return subprocess.run(["git", "-c", f"safe.directory={tree}", "-C", tree, *arguments],
                              capture_output=True, text=True, check=True).stdout
    try:
        git("rev-parse", "--verify", "--quiet", f"{commit}^{{commit}}")
    except subprocess.CalledProcessError:
        return None
    differing = git("diff", "--name-only", "--no-renames", "-z", commit, "--")
    untracked = git("ls-files", "--others", "--exclude-standard", "-z")
    return set(filter(None, (differing + untracked).split("\0")))


def concerned(source, changed, includes):
    """Whether a change of these files is one of `source`."""
    if source in changed:
        return True
    folders = [str(folder / ".clang-tidy") for folder in Path(source).parents]
    if changed.intersection(folders):
        return True
    test = source.startswith("tests/")
    return any(name in changed for name in included(source, includes) if name.startswith("tests/") or not test)


def compiled(build, tree):
    """(command, folder, sources) of each entry of the build, the sources as names from the top of the tree. A
    source that CMake copied for a test counts as the one beside the test; what a test takes from elsewhere
    is checked there."""
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if re.search("_autogen|cmake_pch", entry["file"]):
            continue
        joined = "/Unity/" in entry["file"]
        files = JOINED.findall(Path(entry["file"]).read_text()) if joined else [entry["file"]]
        names = [Path(f).relative_to(tree) for f in files]
        if names[0].parts[0] == "tests":
            beside = [names[0].parent / name.name for name in names]
            names = [name for name in dict.fromkeys(beside) if (tree / name).is_file()]
        yield re.sub(r" -o \S+ -c \S+$", "", entry["command"]), entry["directory"], list(map(str, names))


def main(tree, build, folder, since):
    changed = changed_files(tree, since) if since else None
    if since and changed is None:
        print(f"commit {since} is not known here: everything is checked", file=sys.stderr)
    includes = include_graph(tree, ("sim", "ui", "app", "tests"))
    folder.mkdir(parents=True, exist_ok=True)
    # What moc writes is not ours to check: an empty file stands for it.
    stubs = folder / "moc"
    stubs.mkdir(exist_ok=True)
    seen, checked, entries = set(), 0, []

    def enter(command, directory, file):
        entries.append({"directory": directory, "file": str(file),
                        "command": f"{command} -I{stubs} -o {file.stem}.o -c {file}"})

    for command, directory, sources in compiled(build, tree):
        sources = [s for s in sources if s not in seen]
        seen.update(sources)
        wanted = [s for s in sources if changed is None or concerned(s, changed, includes)]
        checked += len(wanted)
        if len(wanted) == 1 or any(s.startswith("tests/") for s in wanted):
            for source in wanted:
                (stubs / (Path(source).stem + ".moc")).touch()
                enter(command, directory, tree / source)
        elif wanted:
            batch = folder / f"batch_{len(entries)}.cpp"
            batch.write_text("".join(f'#include "{tree / s}"\n' for s in wanted))
            enter(command, directory, batch)
    (folder / "compile_commands.json").write_text(json.dumps(entries))
    print(f"{checked} of {len(seen)} sources in {len(entries)} runs", file=sys.stderr)
    print(*(entry["file"] for entry in entries), sep="\0", end="\0" if entries else "")


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("tree", type=Path)
    parser.add_argument("build", type=Path)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--since")
    given = parser.parse_args()
    main(given.tree.resolve(), given.build.resolve(), given.folder.resolve(), given.since)
