#!/usr/bin/env python3
"""Makes a project by `gliftc new`, builds it, and runs its tests. new_project_test.py GLIFTC PREFIX CXX

PREFIX is an installation of Glift, or a build tree."""
import os
import pathlib
import subprocess
import sys
import tempfile

gliftc, prefix, compiler = sys.argv[1:]


def run(*command, code=0, says="", cwd=None):
    environment = {**os.environ, "GLIFT_DEVICE": "host"}
    ran = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=cwd,
                         env=environment)
    if ran.returncode != code or says not in ran.stdout:
        sys.exit(f"{' '.join(map(str, command))} ends with {ran.returncode}, not {code}, or does not say '{says}':\n{ran.stdout}")
    return ran.stdout


with tempfile.TemporaryDirectory(prefix="glift-new-") as name:
    folder = pathlib.Path(name)
    run(gliftc, "new", "wave-tank", says="gliftc test wave-tank/wave-tank.glift", cwd=folder)
    project = folder / "wave-tank"
    assert sorted(p.name for p in project.iterdir()) == ["CMakeLists.txt", "main.cpp", "wave-tank.glift"]
    run(gliftc, "fmt", "--check", project / "wave-tank.glift")

    run(gliftc, "new", "wave-tank", code=2, says="is there already", cwd=folder)
    for wrong in "2d", "a b", "", "å", "class", "test", "for", "glift", "../test":
        run(gliftc, "new", wrong, code=2, says="no project can be named", cwd=folder)
    assert [p.name for p in folder.iterdir()] == ["wave-tank"], "a refused name leaves nothing"
    run(gliftc, "new", code=2, says="name is required", cwd=folder)

    # Without optimisation: the test is whether it builds.
    run("cmake", "-G", "Ninja", "-S", project, "-B", project / "build", f"-DCMAKE_PREFIX_PATH={prefix}",
        f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_CXX_FLAGS_RELEASE=-O0")
    run("cmake", "--build", project / "build")
    run("ctest", "--output-on-failure", cwd=project / "build", says="100% tests passed, 0 tests failed out of 2")
    run(project / "build" / "wave-tank", says="  0.0  1.0  1.0  1.0  0.0")
