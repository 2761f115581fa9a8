#!/usr/bin/env python3
"""Checks with gliftc each code block of the given documents that is in Glift: snippets.py GLIFTC FILE.md…"""
import pathlib
import re
import subprocess
import sys
import tempfile

gliftc, *documents = sys.argv[1:]
passed = failed = 0
for document in documents:
    text = pathlib.Path(document).read_text()
    for block in re.finditer(r"```glift\n(.*?)```", text, re.S):
        line = text[: block.start()].count("\n") + 2
        source = block.group(1)
        name = re.search(r"^module (\w+);", source, re.M)
        if not name:
            source = "module snippet;\n" + source
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / f"{name.group(1) if name else 'snippet'}.glift"
            path.write_text(source)
            run = subprocess.run([gliftc, "--check", str(path)], capture_output=True, text=True)
        if run.returncode == 0:
            passed += 1
        else:
            failed += 1
            print(f"{document}:{line}: does not compile\n{run.stderr}{run.stdout}")
print(f"{passed} passed, {failed} failed")
sys.exit(1 if failed or not passed else 0)
