#!/usr/bin/env python3
"""Compiles generated C++ with the headers of this version of the runtime, and of others.
version_test.py GLIFTC SOURCE_TREE CXX VERSION"""
import pathlib
import subprocess
import sys
import tempfile

gliftc, source, compiler, version = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3], sys.argv[4]
headers = source / "runtime" / "include"
numbers = version.split(".")


def run(*command):
    return subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


said = run(gliftc, "--version").stdout.strip()
assert said == f"gliftc {version}", said
with tempfile.TemporaryDirectory(prefix="glift-version-") as name:
    folder = pathlib.Path(name)
    (folder / "one.glift").write_text("module one;\npub structure Line = Array<1, float>;\n")
    assert run(gliftc, "-o", folder, "--target=cpp", folder / "one.glift").returncode == 0

    def compiled_with(part, number):
        """What the C++ compiler says when the runtime's version has this number."""
        changed = folder / f"{part}_{number}" / "glift"
        changed.mkdir(parents=True)
        text = (headers / "glift" / "version.h").read_text()
        old = f"#define GLIFT_VERSION_{part} {numbers[['MAJOR', 'MINOR', 'PATCH'].index(part)]}\n"
        assert old in text, text
        (changed / "version.h").write_text(text.replace(old, f"#define GLIFT_VERSION_{part} {number}\n"))
        # The copy has to be found first also by the headers beside it: these include <glift/version.h>.
        return run(compiler, "-std=c++20", "-fsyntax-only", "-I", changed.parent, "-I", headers, folder / "one.glift.cpp")

    for part, number in ("MINOR", 99), ("MAJOR", 7):
        ran = compiled_with(part, number)
        wanted = f"gliftc {numbers[0]}.{numbers[1]} made this, and the Glift headers found are of another version"
        assert ran.returncode != 0 and wanted in ran.stdout and "run the gliftc that belongs to them" in ran.stdout, ran.stdout
    ran = compiled_with("PATCH", 99)
    assert ran.returncode == 0, ran.stdout
