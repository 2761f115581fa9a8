#!/usr/bin/env python3
"""Runs the block in Python of docs/how-to/files.md, on a file of the structure that the page declares: page_test.py PROGRAM."""
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import h5py
except ImportError as missing:
    if sys.executable == "/usr/bin/python3" or not pathlib.Path("/usr/bin/python3").exists():
        print(f"skipped: {missing}")
        sys.exit(77)
    sys.exit(subprocess.call(["/usr/bin/python3", *sys.argv]))

here = pathlib.Path(__file__).resolve().parent
page = (here.parents[2] / "docs/how-to/files.md").read_text(encoding="utf-8")


def block(language, number=0):
    return re.findall(rf"^```{language}\n(.*?)^```", page, re.S | re.M)[number]


assert block("glift") == (here / "field.glift").read_text(), "field.glift is not the page's first declaration"
with tempfile.TemporaryDirectory() as folder:
    subprocess.run([pathlib.Path(sys.argv[1]).resolve()], cwd=folder, check=True)
    run = subprocess.run([sys.executable, "-c", block("python")], cwd=folder, capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    assert run.stdout == "(3, 512) [64 64 32]\n", run.stdout
    with h5py.File(pathlib.Path(folder) / "field.h5") as file:
        density = file["grid/field/frames/data/density"][:]
        assert (density[:2] == 0.5).all() and (density[2] == 0).all()
print("the page's Python reads the page's file")
