#!/usr/bin/env python3
"""Compiles generated code and the runtime's headers as programs do that have other flags, libraries or systems.

    headers_test.py GLIFTC INCLUDE_FOLDER CXX

Clang and the linker of LLVM are used too, where they are installed.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

gliftc, include = map(os.path.abspath, sys.argv[1:3])
compiler = sys.argv[3]
MODULE = """module part;
use std.array;
use std.image;
use std.page_allocator;
use std.sparse;
pub struct Pair { a: float; b: uint; }
pub structure Line = Array<1, float>;
pub structure Counts = Array<1, uint>;
pub structure Pairs = Array<2, Pair>;
pub structure Film = Image<rgba8>;
pub structure Volume = Sparse<3, float, uint3(8, 8, 8)>;
pub kernel twice(f: in each<Line>, g: out each<Line>) { g = 2.0 * f; }
pub kernel count(f: in each<Line>, g: out scatter<Counts, add>) { g[uint(f)] = 1u; }
"""
# Headers that a program includes; others are for generated code and for `gliftc test`.
PUBLIC = ["glift", "inspect", "log", "recording", "reload", "vulkan"]
# Two sources that define the same things, and one that uses them.
SHARED = """#include <glift/api.h>
struct Kernel { int name; };
struct Line { int size(); };
extern const Kernel kernel;
GLIFT_SHARED const Kernel kernel = {1};
GLIFT_SHARED int twice(int x) { return 2 * x * kernel.name; }
GLIFT_SHARED int Line::size() { return 3; }
"""
USE = """struct Kernel { int name; };
struct Line { int size(); };
extern const Kernel kernel;
int twice(int x);
extern "C" int start() { return twice(kernel.name) + Line().size(); }
"""
failures = 0


def run(what, *words, folder):
    global failures
    ran = subprocess.run([str(w) for w in words], cwd=folder, capture_output=True, text=True)
    if ran.returncode:
        failures += 1
        print(f"not so: {what}\n{ran.stderr}")
    return ran.stdout


def found(*names):
    return next((path for path in map(shutil.which, names) if path), None)


def check_flags(folder):
    (folder / "program.cpp").write_text("".join(f"#include <glift/{h}.h>\n" for h in PUBLIC) + """#include "part.glift.hpp"
void write(part::Line& line, const part::Volume& volume) {
    line.map()[0] = 1.0f;
    glift::inspect(volume, "volume").save("volume.inspection");
}
""")
    for cxx in filter(None, [compiler, found("clang++-14", "clang++")]):
        def compiles(what, *flags):
            run(what + ", " + cxx, cxx, "-std=c++20", "-fsyntax-only", "-I.", "-I", include, *flags, folder=folder)
        compiles("no warnings", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror", "program.cpp")
        compiles("no exceptions", "-fno-exceptions", "program.cpp")
        # libc++ has no std::atomic_ref before LLVM 19.
        (folder / "old.h").write_text("#include <atomic>\n#define atomic_ref not_in_this_library\n")
        compiles("no std::atomic_ref", "-include", "old.h", "part.glift.kernels.cpp")


def check_reload(folder):
    """Variables of the whole process (STB_GNU_UNIQUE) would stay those of the first version of a library."""
    run("the classes compile", compiler, "-std=c++20", "-O0", "-fPIC", "-shared", "-I.", "-I", include, "-o", "part.so",
        "part.glift.cpp", folder=folder)
    symbols = run("nm", "nm", "-C", "part.so", folder=folder)
    of_process = [line for line in symbols.splitlines() if " u " in line and " u std::" not in line]
    global failures
    if "structure_table" not in symbols or of_process:
        failures += 1
        print("not so: no variable is one for the whole process", *of_process, sep="\n")


def check_windows(folder):
    clang, link = found("clang++-14", "clang++"), found("lld-link-14", "lld-link")
    if not clang or not link:
        return print("no clang and lld-link: Windows is not checked")
    for name, text in [("one", SHARED), ("two", SHARED), ("use", USE)]:
        (folder / f"{name}.cpp").write_text(text)
        run("compiles for Windows", clang, "-std=c++20", "--target=x86_64-w64-windows-gnu", "-I", include, "-c",
            f"{name}.cpp", folder=folder)
    run("what sources share is linked once on Windows", link, "/nodefaultlib", "/entry:start", "/subsystem:console",
        "/lldmingw", "/out:shared.exe", "one.o", "two.o", "use.o", folder=folder)


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    (folder / "part.glift").write_text(MODULE)
    run("gliftc", gliftc, "-o", ".", "--target", "cpp", "--target", "host", "--host-only", "part.glift", folder=folder)
    check_flags(folder)
    check_reload(folder)
    check_windows(folder)
sys.exit(1 if failures else 0)
