#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Breaks the library on purpose, one fault at a time, and sees whether the tests of that unit notice.

tests/mutations/run.py [WORDS...]   only those whose name contains one of WORDS: "sleep: no ball" scenes:
tests/mutations/run.py --check [FILE]   makes none of them, and only sees whether each text is still in its file

The faults are in mutations.txt. They are made in a copy of the sources in build/mutations, which is built once;
each fault then costs one file or a few. Lists what was killed and what survived; fails if anything survived, if a
text is not in its file exactly once, if a fault does not compile, and if the tests fail without any fault.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORK = ROOT / "build" / "mutations"
SOURCES, BUILD = WORK / "sources", WORK / "sources/build/dev"  # where a clone has it: so ccache knows its objects
TIMEOUT = 300  # seconds for the tests of a unit; a fault that makes them run forever is noticed too


def read_mutations(path=ROOT / "tests/mutations/mutations.txt"):
    mutations = []
    for line in path.read_text().splitlines():
        if not line or line.startswith("#"):
            continue
        if line.startswith("["):
            mutations.append({"name": line[1:-1], "file": "", "old": [], "new": []})
        elif line.startswith("- ") or line == "-":
            mutations[-1]["old"].append(line[2:])
        elif line.startswith("+ ") or line == "+":
            mutations[-1]["new"].append(line[2:])
        elif line.startswith("! "):
            mutations[-1]["program"], mutations[-1]["filter"] = line[2:].split()
        else:
            mutations[-1]["file"] = line
    return mutations


def find_stale(mutation, root):
    """Why the fault cannot be made in the sources at root, or None."""
    path = root / mutation["file"]
    if not path.is_file():
        return f"there is no {mutation['file']}"
    count = path.read_text().count("\n".join(mutation["old"]))
    return f"its text is {count} times in {mutation['file']}, expected once" if count != 1 else None


def check(mutations):
    stale = [f"{m['name']}: {why}" for m in mutations if (why := find_stale(m, ROOT)) is not None]
    print("\n".join([*stale, f"{len(mutations)} mutations, {len(stale)} cannot be made"]))
    return 1 if stale or not mutations else 0


def build(program):
    """The words of the compiler if it fails."""
    done = subprocess.run(["cmake", "--build", BUILD, "--target", program], capture_output=True, text=True)
    return done.stdout if done.returncode else None


def tests_fail(program, tests):
    path = next(p for p in BUILD.rglob(program) if p.is_file())
    try:
        done = subprocess.run([path, f"--gtest_filter={tests}", "--gtest_brief=1"], capture_output=True, text=True,
                              timeout=TIMEOUT)
    except subprocess.TimeoutExpired:
        return "they do not end"
    if "[==========] 0 tests" in done.stdout:
        sys.exit(f"{program}: no test has a name like {tests}")
    failed = re.findall(r"^\[  FAILED  \] (\S+?)(?:,| \()", done.stdout, re.MULTILINE)
    if done.returncode and not failed:
        return f"they die ({done.returncode})"
    return failed[0] if failed else None


def prepare():
    SOURCES.mkdir(parents=True, exist_ok=True)
    files = subprocess.run(["git", "-c", "safe.directory=*", "ls-files", "-z"], cwd=ROOT, capture_output=True,
                           check=True).stdout.decode().split("\0")
    for name in filter(None, files):
        source, copy = ROOT / name, SOURCES / name
        # A source that has not changed keeps its time, so that it is not built again.
        if not copy.exists() or copy.read_bytes() != source.read_bytes():
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, copy)
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    subprocess.run(["cmake", "--preset", "dev", *launcher], cwd=SOURCES, stdout=subprocess.DEVNULL, check=True)


def main():
    if sys.argv[1:2] == ["--check"]:
        return check(read_mutations(*map(pathlib.Path, sys.argv[2:])))
    words = sys.argv[1:] or [""]
    mutations = [m for m in read_mutations() if any(word in m["name"] for word in words)]
    os.environ["CCACHE_NOHASHDIR"] = "1"
    os.environ["CCACHE_BASEDIR"] = str(SOURCES)
    prepare()
    for program in sorted({m["program"] for m in mutations}):
        if (error := build(program)) is not None:
            sys.exit(f"{program} does not compile without any fault:\n{error}")
    for program, tests in sorted({(m["program"], m["filter"]) for m in mutations}):
        if (failed := tests_fail(program, tests)) is not None:
            sys.exit(f"{program} --gtest_filter={tests} fails without any fault: {failed}")

    survived, errors = [], []
    for m in mutations:
        if (why := find_stale(m, SOURCES)) is not None:
            errors.append(m["name"])
            print(f"error     {m['name']}: {why}", flush=True)
            continue
        path = SOURCES / m["file"]
        text = path.read_text()
        path.write_text(text.replace("\n".join(m["old"]), "\n".join(m["new"])))
        try:
            if (error := build(m["program"])) is not None:
                errors.append(m["name"])
                print(f"error     {m['name']}: does not compile\n{error}", flush=True)
            elif (failed := tests_fail(m["program"], m["filter"])) is not None:
                print(f"killed    {m['name']}: {failed}", flush=True)
            else:
                survived.append(m["name"])
                print(f"SURVIVED  {m['name']}", flush=True)
        finally:
            path.write_text(text)
    print(f"{len(mutations) - len(survived) - len(errors)} killed, {len(survived)} survived, {len(errors)} errors")
    return 1 if survived or errors else 0


if __name__ == "__main__":
    sys.exit(main())
