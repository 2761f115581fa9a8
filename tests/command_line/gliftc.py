"""Runs gliftc in a temporary folder and checks its output."""
import os
import pathlib
import subprocess
import sys
import tempfile

compiler = pathlib.Path(sys.argv[1]).resolve()
sources = pathlib.Path(__file__).resolve().parent
failures = 0


class Folder:
    """A temporary folder with some files."""

    def __init__(self, **files):
        self.held = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.held.name)
        for name, text in files.items():
            self.write(name + ".glift", text)

    def write(self, name, text):
        (self.path / name).parent.mkdir(parents=True, exist_ok=True)
        (self.path / name).write_text(text)

    def names(self, folder="."):
        at = self.path / folder
        return sorted(p.name for p in at.iterdir()) if at.is_dir() else []

    def run(self, *words, timeout=None, **environment):
        ran = subprocess.run([compiler, *map(str, words)], cwd=self.path, text=True, capture_output=True, timeout=timeout,
                             env={**os.environ, **environment})
        ran.said = ran.stdout + ran.stderr
        return ran


def expect(condition, what, said=""):
    global failures
    if condition:
        return
    failures += 1
    print(f"not so: {what}\n{said}")


def says(ran, code, *words):
    for word in words:
        expect(word in ran.said, f"{ran.args[1:]} says '{word}'", ran.said)
    expect(ran.returncode == code, f"{ran.args[1:]} ends with {code}, not {ran.returncode}", ran.said)


def finish():
    sys.exit(1 if failures else 0)
