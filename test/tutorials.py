#!/usr/bin/python3
"""Runs every block of the tutorials that is marked sh, in order, in one folder for each tutorial."""
import glob
import os
import re
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def run(path):
    with open(path, encoding="utf-8") as text:
        blocks = re.findall(r"^```sh\n(.*?)^```$", text.read(), re.MULTILINE | re.DOTALL)
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", "\n".join(blocks)], cwd=folder, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, universal_newlines=True)
    print("%s: %d blocks, exit code %d\n%s" % (os.path.relpath(path, ROOT), len(blocks), done.returncode, done.stdout))
    return done.returncode == 0 and "error" not in done.stdout.lower()


def shows(path, language, source):
    """Whether a tutorial has a file of the tests as it is."""
    with open(os.path.join(ROOT, path), encoding="utf-8") as text, open(os.path.join(ROOT, source), encoding="utf-8") as file:
        is_same = "```%s\n%s```\n" % (language, file.read()) in text.read()
    print("%s: %s %s" % (path, "shows" if is_same else "DOES NOT SHOW", source))
    return is_same


LIBRARY = "doc/tutorials/library_without_ros.md"


def main():
    paths = [p for p in sorted(glob.glob(ROOT + "/doc/tutorials/*.md")) if "```sh" in open(p, encoding="utf-8").read()]
    results = [run(path) for path in paths]
    results += [shows(LIBRARY, "cpp", "test/consumer/main.cpp"), shows(LIBRARY, "cmake", "test/consumer/CMakeLists.txt")]
    print("%d passed, %d failed" % (sum(results), len(results) - sum(results)))
    return 0 if all(results) and paths else 1


if __name__ == "__main__":
    sys.exit(main())
