#!/usr/bin/env python3
"""Tests `gliftc -g`: debuggers stop at lines of the .glift file on the host device. source_lines_test.py GLIFTC CXX"""
import shutil
import subprocess
import sys

from gliftc import Folder, compiler, expect, finish, says

SOURCE = """module lines;
use std.array;
pub structure Line = Array<1, float>;
pub kernel twice(x: in each<Line>, y: out each<Line>, k: float) {
    let scaled = x * k;
    y = scaled + scaled;
}
"""
MAIN = """#include "lines.glift.hpp"
int main() {
    auto device = glift::Device::open("host");
    lines::Line x(device, 4), y(device, 4);
    lines::twice(device, x, y, 2.0f);
    return static_cast<int>(y.read()[0]);
}
"""
here = Folder(lines=SOURCE)
here.write("main.cpp", MAIN)
says(here.run("-g", "-o", ".", "--target=cpp", "--target=host", "lines.glift"), 0)
root = compiler.parent.parent
done = subprocess.run([*sys.argv[2].split(), "-std=c++20", "-g", "-O0", "-I", root / "include", *here.path.glob("*.cpp"),
                       "-L", root / "lib", f"-Wl,-rpath,{root / 'lib'}", "-lglift", "-o", here.path / "program"],
                      cwd=here.path, capture_output=True, text=True)
expect(done.returncode == 0, "the program is built", done.stderr)

table = subprocess.run(["objdump", "--dwarf=decodedline", here.path / "program"], capture_output=True, text=True).stdout
lines = {words[1] for words in map(str.split, table.splitlines()) if len(words) > 2 and words[0] == "lines.glift"}
expect({"5", "6"} <= lines, "the line table has the lines of the kernel's body", str(sorted(lines)))

if shutil.which("gdb"):
    said = subprocess.run(["gdb", "-batch", "-ex", "break lines.glift:6", "-ex", "run", "-ex", "continue", "-ex", "continue",
                           "-ex", "info locals",
                           here.path / "program"], cwd=here.path, capture_output=True, text=True).stdout
    expect("lines.glift:6" in said and "scaled = 0" in said, "gdb stops at the line and shows the local", said)
finish()
