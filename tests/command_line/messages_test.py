#!/usr/bin/env python3
"""Tests `print` and `assert` of gliftc: --no-print makes no code, `gliftc test` shows and compares messages. messages_test.py GLIFTC"""
from gliftc import Folder, expect, finish, says

here = Folder()

# Without messages the outputs are, byte for byte, those of the source without the statements.
source = """module quiet;
use std.array;
pub structure Line = Array<1, float>;
pub structure Bins = Array<1, uint>;
pub structure Plane = Array<2, float>;
fn root(x: float) -> float {
    assert(x >= 0.0, "no root of {}", x);
    return sqrt(x);
}
pub kernel roots(f: inout each<Line>, scale: float) {
    print("{} by {}", f, scale);
    f = root(f) + scale * root(2.0 * f);
    print(f, sqrt(f * f));
}
pub kernel smooth(f: in near<Plane, 1>, to: out each<Plane>) {
    print(f[-1]);
    to = f[int2(1, 0)] + f[int2(-1, 0)];
}
pub kernel histogram(f: in each<Line>, bins: out scatter<Bins, add>) {
    bins[uint(f) % 8u] = 1u;
    assert(f < 8.0);
}
pub kernel turned(f: inout each<Line>) group(64) {
    shared all: float[64];
    all[local_index()] = f;
    barrier();
    f = all[63u - local_index()];
    print(f);
}
"""
without = "\n".join("" if line.strip().startswith(("print(", "assert(")) else line for line in source.split("\n"))
here.write("with/quiet.glift", source)
here.write("without/quiet.glift", without)
for folder in "with", "without":
    says(here.run("--no-print", "-o", f"{folder}/out", f"{folder}/quiet.glift"), 0)
names = here.names("with/out")
expect(len(names) > 10 and names == here.names("without/out"), "--no-print writes the same files", names)
for name in names:
    one, other = (here.path / folder / "out" / name for folder in ("with", "without"))
    expect(name.endswith(".d") or one.read_bytes() == other.read_bytes(), f"--no-print leaves nothing in {name}")
says(here.run("-o", "with/printing", "with/quiet.glift"), 0)
for kernel in "roots", "smooth", "histogram", "turned":
    text = (here.path / f"with/printing/quiet.{kernel}.comp.glsl").read_text()
    expect("begin_message(" in text, f"messages are compiled in unless --no-print is given: {kernel}", text)
says(here.run("--no-print", "--print", "-o", "with/last", "with/quiet.glift"), 0)
expect("begin_message(" in (here.path / "with/last/quiet.roots.comp.glsl").read_text(), "the last of both counts")

# What is wrong with messages is an error in every build.
here.write("wrong.glift", "module wrong;\nuse std.array;\nkernel k(f: in each<Array<1, uint>>) { print(\"{}\"); }\n")
for option in "--print", "--no-print":
    says(here.run("--check", option, "wrong.glift"), 1, "the text has 1 '{}' for 0 values")

# `gliftc test` shows what kernels print below the test's line, and fails where an assertion does.
here.write("shown.glift", """module shown;
use std.array;
structure Line = Array<1, uint>;
structure Reals = Array<1, float>;
kernel number(a: at<Line>, x: out each<Line>) { x = a * a; print("{} squared is {}", a, a * a); }
kernel check(x: in each<Line>) { assert(x < 4u); print(x); }
kernel inexact(a: at<Reals>) { print(sin(float(a))); }
kernel on_host(x: in each<Line>) { print("the host has {}", x); }
kernel elsewhere(x: in each<Line>) { print("the device has {}", x); }
test "squares" { temp x = Line(2u); number(x, x); }
test "small squares" { temp x = Line(4u); number(x, x); check(x); }
test "sines" { temp x = Reals(100u); inexact(x); }
test "other messages" {
    temp x = Line(1u);
    if device.is_host { on_host(x); } else { elsewhere(x); }
}
test "quiet" { temp x = Line(1u); expect(await x[0] == 0u); }
""")
ran = here.run("test", "shown.glift")
says(ran, 1, """pass  squares (shown.glift:10)
      shown.glift:5: at (0): 0 squared is 0
      shown.glift:5: at (1): 1 squared is 1
FAIL  small squares (shown.glift:11)
""", "      shown.glift:6: at (2): assertion failed: x < 4u (x = 4)\n      shown.glift:6: at (3): assertion failed: x < 4u (x = 9)\n",
     "pass  sines", "FAIL  other messages",
     "shown.glift:13: message 1: the host printed 'shown.glift:8: at (0): the host has 0' and llvmpipe",
     "pass  quiet", "2 failed")
says(here.run("test", "--device", "host", "--filter", "sines", "shown.glift", GLIFT_PRINT_BYTES="1K"), 0, "pass  sines",
     "messages were lost: the buffer has 1.0 KiB", "GLIFT_PRINT_BYTES makes it larger [host]")
says(here.run("test", "--device", "host", "--no-print", "--filter", "small", "shown.glift"), 0, "pass  small squares")

finish()
