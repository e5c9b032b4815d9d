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


def main():
    paths = [p for p in sorted(glob.glob(ROOT + "/doc/tutorials/*.md")) if "```sh" in open(p, encoding="utf-8").read()]
    passed = sum(run(path) for path in paths)
    print("%d passed, %d failed" % (passed, len(paths) - passed))
    return 0 if passed == len(paths) and paths else 1


if __name__ == "__main__":
    sys.exit(main())
