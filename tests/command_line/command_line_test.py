#!/usr/bin/env python3
"""Tests options, exit codes, `gliftc explain`, `gliftc fmt` and reflection: command_line_test.py GLIFTC"""
import json
import os
import pty
import subprocess

from gliftc import Folder, compiler, expect, finish, says, sources

snake = (sources.parent.parent / "tests/command_line/properties.glift").read_text()
here = Folder(good="module good;\npub fn one() -> int { return 1; }\n", bad="module bad;\nfn f() -> int { return y; }\n",
              properties=snake)

# Files of arguments (@file).
here.write("words", "--check 'good.glift'\n@more")
here.write("more", "--error-limit 3\n")
says(here.run("@words"), 0)
says(here.run("@nothing"), 2, "cannot read 'nothing'")
here.write("itself", "@itself")
says(here.run("@itself"), 2, "names itself")

# Files of dependencies for make, as C and C++ compilers write them.
says(here.run("-MD", "-MF", "made.d", "-o", "out", "good.glift"), 0)
expect("good.glift.hpp" in (here.path / "made.d").read_text(), "-MF writes the rule")
says(here.run("-MD", "--target=json", "-o", "json", "good.glift"), 0)
expect(here.names("json") == ["good.glift.d", "good.glift.json"], "-MD writes a rule beside any output",
       here.names("json"))
here.write("halved.glift", "module halved;\nuse std.array;\nkernel halve(f: inout each<Array<1, float>>) { f = f * 0.5; }\n")
says(here.run("-MD", "--target=glsl", "-o", "glsl", "halved.glift"), 0)
expect("halved.glift.d" in here.names("glsl"), "the rule has the name of the file, whatever is written", here.names("glsl"))
says(here.run("--check", "--depfile", "d", "good.glift"), 2, "nothing is written here")

here.write("tabs.clang-format", "UseTab: Always\n")
says(here.run("-MD", "--target=cpp", "--style", "tabs.clang-format", "-o", "styled", "good.glift"), 0)
expect("tabs.clang-format" in (here.path / "styled/good.glift.d").read_text(), "the rule names the file of --style")

# Names behind a module's name: its own public ones.
here.write("x/util.glift", "module x.util;\nuse std.edge;\npub const n = 3u;\npub fn f() -> uint { return n; }\n"
                           "struct Hidden { a: uint; }\n")
here.write("outside.glift", """module outside;
use std.array;
use x.util;
kernel k(a: inout each<array.Array<1, uint>>, b: in each<std.array.Array<1, uint>>) {
    let some: uint[util.n] = {1u, 2u, 3u};
    a = util.f() + x.util.n + some[0] + b;
}
""")
says(here.run("--check", "outside.glift"), 0)
here.write("inside.glift", """module inside;
use x.util;
fn f() -> uint { return util.Hidden(2u).a; }
fn g(b: util.Boundary) -> uint { return 1u; }
""")
says(here.run("--check", "inside.glift"), 1, "'Hidden' is not 'pub' in module x.util", "unknown name 'Boundary'")

# Functions that call the one before twice: neither the time nor the code doubles with each.
chain = ["module chain;\nuse std.array;\nstructure Line = Array<1, uint>;\n",
         "fn f0(n: uint) -> uint { var k = n; for i in 0u..n { k += i; } return k; }\n", "fn g0(n: uint) -> uint { return n * n + 1u; }\n"]
for i in range(1, 29):
    chain.append(f"fn f{i}(n: uint) -> uint {{ var k = f{i - 1}(n); k += f{i - 1}(n + 1u); return k; }}\n")
    chain.append(f"fn g{i}(n: uint) -> uint {{ return g{i - 1}(n + {i}u) ^ g{i - 1}(n * {i}u); }}\n")
chain.append("pub kernel k(n: uint, a: at<Line>, to: out each<Line>) { var x = 0u; if n > 3u { x = f28(n); } to = x + g28(a); }\n")
here.write("chain.glift", "".join(chain))
says(here.run("--target=glsl", "-o", "chain", "chain.glift", timeout=60), 0)
lines = (here.path / "chain/chain.k.comp.glsl").read_text().count("\n")
expect(lines < 2000, "calls are inlined as far as the result stays small", str(lines))

# Instances of a pipeline share the kernels of equal values on the device; values of other types or constants have their own.
shares = """module shares;
use std.array;
structure Line = Array<1, uint>;
kernel fill(a: out each<Line>, value: uint) { a = value; }
pipeline put<T: type, more: uint, S: Structure<uint, T>>(a: out Line, counts: in S) {
    fill(a, uint(counts[0] + counts[1]));
    fill(a, uint(counts[0]) + more);
}
pub pipeline all(a: out Line, uints: in Line, ints: in Array<1, int>) {
    put<uint, 1u>(a, uints);
    put<uint, 2u>(a, uints);
    put<int, 2u>(a, ints);
}
"""
here.write("shares.glift", shares)
ran = here.run("--dump=sema", "shares.glift")
says(ran, 0)
kernels = [line for line in ran.said.splitlines() if line.startswith("kernel value(")]
expect(len(kernels) == 5, "uint sum, uint + 1, uint + 2, int sum, int + 2: a kernel each", kernels)
here.write("edited/shares.glift", shares.replace("    fill(", "    // A comment.\n    fill("))
says(here.run("--target=cpp", "-o", "shares", "shares.glift"), 0)
says(here.run("--target=cpp", "-o", "shares_edited", "edited/shares.glift"), 0)
header = "shares.glift.internal.hpp"
expect((here.path / "shares" / header).read_text() == (here.path / "shares_edited" / header).read_text(),
       "a comment changes no kernel's name")

# Outputs.
says(here.run("--host-only", "-o", "host", "properties.glift"), 0)
expect(here.names("host") and not [n for n in here.names("host") if n.endswith(".spv")],
       "--host-only writes no SPIR-V", here.names("host"))
says(here.run("-o", "-", "good.glift"), 2, "name a folder")
expect("-" not in here.names(), "no folder is called -")
here.write("taken", "")
ran = here.run("-o", "taken", "properties.glift")
says(ran, 4, "cannot write 'taken/")
expect(ran.said.count("cannot write") == 1, "one folder, one error", ran.said)

# Diagnostics.
says(here.run("--error-limit", "1", "--check", "bad.glift"), 1, "1 error; no more")
says(here.run("--error-limit", "-3", "--check", "good.glift"), 2)
here.write("unused.glift", "module unused;\nfn f() { let a = 1; let b = 2; }\nfn g(x: int) { let c = 3; }\n")
says(here.run("-Werror", "--check", "unused.glift"), 1, "'a' is", "'b' is", "'c' is", "'x' is")
here.write("within.glift", """module within;
use std.array;
translator Next : uint -> uint { n: uint; domain() { return n; } translate(p) { let dead = 1u; return p + n; } }
structure Line(n: uint) { memory data = Array<1, float>(n); via Next(n); }
structure Lines(n: uint) { structure line = Line(n); fn get(i: uint) -> float { let gone = 2u; return line[i]; } }
test "uses them" { temp lines = Lines(4u); expect(await lines.get(1u) == 2.0); }
""")
ran = here.run("-Werror", "--check", "within.glift")
says(ran, 1, "'dead' is", "'gone' is")
expect(ran.said.count("error:") == 2, "warnings that are errors cause no other errors", ran.said)
says(here.run("--library", "/nowhere", "--check", "good.glift"), 2, "does not hold the standard library")
expect("or ir" in here.run("--help").said, "--help names the stage 'ir'")
for code in ("0 done", "1 errors", "2 wrong usage", "3 a bug", "4 a file"):
    expect(code in here.run("--help").said, f"--help says what {code} is")


def on_terminal(**environment):
    """The output of gliftc when it writes to a terminal."""
    mine, its = pty.openpty()
    subprocess.run([compiler, "--check", "bad.glift"], cwd=here.path, stderr=its, env={**os.environ, **environment})
    os.write(its, b"\0")  # marks the end: one read gives only what has arrived
    said = b""
    while not said.endswith(b"\0"):
        said += os.read(mine, 4096)
    os.close(its)
    os.close(mine)
    return said.decode()


expect("\x1b[" in on_terminal(NO_COLOR=""), "errors are coloured on a terminal")
expect("\x1b[" not in on_terminal(NO_COLOR="1"), "NO_COLOR turns colours off")

# A module's name, or its part after the last dot, has to be its file's name, with '_' for what names cannot have, such as '-'.
here.write("my-file.glift", "module my_file;\npub fn one() -> int { return 1; }\n")
says(here.run("--check", "my-file.glift"), 0)
here.write("other.glift", "module wrong;\nfn f() -> int { return y; }\n")
says(here.run("--check", "other.glift"), 1, "[module-name]", "write 'module other;', or call the file 'wrong.glift'",
     "unknown name 'y'")

# explain.
ran = here.run("explain", "properties.glift")
says(ran, 0,
     "total, one to one (checked to 4087 addresses)", "yes (checked to 4087 addresses)",
     "total, many to one: {0} and {1} both map to {0}",
     "total ({0} maps to {1}, outside of the memory), one to one (checked to 4093 addresses)",
     "no: invert(translate({1, 0})) is {0, 1}",
     "total, one to one or many to one: not known",
     "not known: that of list", "not known, not uniform")
explained = json.loads(here.run("explain", "--json", "properties.glift").stdout)
expect({s["name"] for s in explained["structures"]} >= {"Snake", "Halves", "Wrong", "Places"}, "explain --json", explained)
expect(all(t["location"] == "GPU and CPU" for s in explained["structures"] for t in s["via"]), "properties in JSON")
# Folded is not affine: its result depends on the address by way of a field that is assigned. The access of Through is not known to
# be O(1): it reads a table, Over, whose memory, Slow, has a translator with a loop.
here.write("folded.glift", """module folded;
use std.array;
struct Two { a: uint; b: uint; }
translator Folded : uint -> uint {
    extent: uint;
    domain() { return extent; }
    translate(va) {
        var t: Two;
        t.a = va % 4u;
        return t.a;
    }
}
pub structure Fours(n: uint) { memory data = buffer<float>[4]; via Folded(n); }
translator Looped : uint -> uint {
    extent: uint;
    domain() { return extent; }
    translate(va) {
        const low = -1;
        var x = va;
        for i in low..2 { x = x ^ 1u; }
        return x;
    }
}
pub structure InALoop(n: uint) { memory data = buffer<float>[n]; via Looped(n); }
translator Converted : uint -> uint {
    extent: uint;
    domain() { return extent; }
    translate(va) {
        const low = -1;
        var x = va;
        if uint(low) == 4294967295u { x = x ^ 1u; }
        return x;
    }
}
pub structure ByAConversion(n: uint) { memory data = buffer<float>[n]; via Converted(n); }
translator Searched : uint -> uint {
    n: uint;
    domain() { return n; }
    translate(va) {
        var x = va;
        while x * x > n { x = x / 2u; }
        return x;
    }
}
structure Slow(n: uint) { memory data = Array<1, uint>(n); via Searched(n); }
structure Over(n: uint) { memory data = Slow(n); }
translator Through<Table: Structure<uint, uint>> : uint -> uint {
    n: uint;
    table: Table;
    domain() { return n; }
    translate(va) { return table[va]; }
}
pub structure ByTable(n: uint) {
    memory data = Array<1, float>(n);
    structure table = Over(n);
    via Through(n, table);
}
""")
folded = {t["name"]: t for s in json.loads(here.run("explain", "--json", "folded.glift").stdout)["structures"] for t in s["via"]}
expect(not folded["Folded"]["affine"], "a translator that assigns to a field is not affine", folded["Folded"])
expect(not folded["Looped"]["affine"], "a loop from a negative bound is followed", folded["Looped"])
expect(not folded["Converted"]["affine"], "constants are converted as at run time", folded["Converted"])
through = next(t for name, t in folded.items() if name.startswith("Through"))
expect(through["access_complexity"] == "not known" and through["access_consistency"] == "not uniform", "a table's memory counts", through)
# Updates that are combined.
here.write("sums.glift", "module sums;\nuse std.array;\npub structure Line = Array<1, uint>;\n"
           "pub structure Picture = Array<2, uint>;\n"
           "kernel rows(a: at<Picture>, x: in each<Picture>, to: out scatter<Line, add>) { to[a.y] = x; }\n"
           "kernel bins(x: in each<Line>, to: out scatter<Line, add>) { to[x % 256u] = 1u; }\n")
text = here.run("explain", "sums.glift").stdout
expect("kernel rows  (sums.glift:5)" in text and "combined along x: 16 elements by an invocation, 4096 by a workgroup" in text,
       "explain says how rows are summed", text)
expect("updates to_data" in text and "in copies in workgroup memory" in text, "explain names copies", text)
updates = json.loads(here.run("explain", "--json", "sums.glift").stdout)["updates"]
expect({kernel["name"] for kernel in updates} == {"rows", "bins"}, "updates in JSON", updates)
# Transposed accesses.
here.write("pictures.glift", "module pictures;\nuse std.array;\npub structure Picture = Array<2, float>;\n"
           "kernel store(a: at<Picture>, x: in each<Picture>, to: out scatter<Picture>) { to[a.yx] = x; }\n"
           "kernel load(a: at<Picture>, x: in any<Picture>, to: out each<Picture>) { to = x[a.yx]; }\n")
text = here.run("explain", "pictures.glift").stdout
expect("kernel store  (pictures.glift:4)" in text and "stores to to_data   through a tile of 32 x 32 elements" in text,
       "explain says how a picture is transposed", text)
expect("loads from x_data   through a tile" in text and "exchanges x and y" in text, "explain names the axes", text)
tiles = json.loads(here.run("explain", "--json", "pictures.glift").stdout)["tiles"]
expect({kernel["name"] for kernel in tiles} == {"store", "load"}, "tiles in JSON", tiles)

# `explain --made`: the bytes that a structure takes.
here.write("grids.glift", """module grids;
use std.array;
use std.image;
use std.page_allocator;
use std.paged;
use std.sparse;
pub structure Grid = Sparse<3, float, uint3(8, 8, 8), Overflow.drop>;
pub structure Field = Paged<2, float2, uint2(4, 4)>;
pub structure Levels = ImageLevels<rgba8>;
""")
made = here.run("explain", "--made", "Grid(uint3(256, 256, 256), 4096, -1.5)", "--made", "Field({18, 16} 3u, 0 0)",
                "--made=Levels(16, 8, 5)", "grids.glift")
says(made, 0, "Grid made with extent uint3(256, 256, 256), capacity 4096, background -1.5",
     "8 MiB, elements of field", "128 KiB, table of field", "pages.wanted.data   4 KiB\n",
     "Field made with extent uint2(18, 16), capacity 3, background float2(0.0, 0.0)", "384 bytes, elements of it",
     "Levels made with", "684 bytes")  # levels of 128, 32, 8, 2 and 1 texels
says(made, 0, "structure Grid = Sparse<3, float, uint3(8, 8, 8), drop>", "member field        Paged<3, float, uint3(8, 8, 8)",
     "fn status           reads elements")
as_json = json.loads(here.run("explain", "--json", "--made", "Grid(256 256 256 4096 0)", "grids.glift").stdout)["made"]
expect({m["path"]: m["bytes"] for m in as_json[0]["memories"]}["field.frames.data"] == 8 << 20, "explain --made --json", as_json)
expect(as_json[0]["bytes"] == sum(m["bytes"] for m in as_json[0]["memories"]), "the sum", as_json)
says(here.run("explain", "--made", "Grid(256, 256, 256)", "grids.glift"), 2,
     "(extent: uint3, capacity: uint, background: float) takes 5 numbers, not 3")
says(here.run("explain", "--made", "Grid(-1, 1, 1, 2.5, 0)", "grids.glift"), 2, "number 1 is whole")
says(here.run("explain", "--made", "Sheet(1)", "grids.glift"), 2, "no structure 'Sheet'")
says(here.run("explain", "--made", "Grid(my_pair(256, 256), uint[1](256), 4096, 0)", "grids.glift"), 0, "extent uint3(256, 256, 256)")
says(here.run("explain", "--made", "(1, 2)", "grids.glift"), 2, "is not a name and numbers")
here.write("moved.glift", "module moved;\nuse std.linear;\n"
                          "pub structure Line(n: uint, by: int) { memory data = buffer<float>[n]; via Linear(n); }\n")
says(here.run("explain", "--made", "Line(16, -2)", "moved.glift"), 0, "n 16, by -2", "64 bytes")
says(here.run("explain", "--made", "Line(16, 2147483648)", "moved.glift"), 2, "number 2 is whole, from -2^31 to 2^31 - 1")
says(here.run("explain", "--made", "Grid", "grids.glift"), 2, "is not a name and numbers")
for word in ("unknown-name", "E-unknown-name", "[unknown-name]"):
    says(here.run("explain", word), 0, "error: unknown name '…' [unknown-name]", "heigth")
expect(json.loads(here.run("explain", "--json", "unknown-name").stdout)["example"].startswith("module"), "explain --json ID")
says(here.run("explain", "unknwon-name"), 2, "did you mean 'unknown-name'?")

# The formatter: an error in one file does not keep it from the others; the exit code says whether a file could not be formatted or,
# with --check, is not formatted.
many = Folder(good="module good;\n", loose="module   loose;\nfn f( ) { }\n", last="module last;\n\nfn f() { }\n",
              **{f"broken{k}": "module broken;\nfn f( { \n" for k in range(3)})
(many.path / "folder.glift").mkdir()
says(many.run("fmt", "--check", "good.glift", "last.glift"), 0)
for bad in ("broken0.glift", "missing.glift", "folder.glift"):
    ran = many.run("fmt", "--check", bad, "loose.glift", "good.glift")
    says(ran, 1, f"{bad}")
    expect(ran.stdout == "loose.glift\n", f"--check goes on after {bad}", ran.said)
    says(many.run("fmt", "--check", "good.glift", bad), 1, f"{bad}")
broken = [f"broken{k}.glift" for k in range(3)]
ran = many.run("fmt", "--check", "--error-limit", "1", *broken, "missing.glift", "good.glift", "loose.glift", timeout=60)
says(ran, 1, "cannot read 'missing.glift'", *broken)
expect(ran.stdout == "loose.glift\n", "the limit of errors is for each file", ran.said)
before = {name: (many.path / name).read_text() for name in broken}
says(many.run("fmt", "--error-limit", "1", *broken, "loose.glift", timeout=60), 1)
expect({name: (many.path / name).read_text() for name in broken} == before, "broken files are left alone")
expect((many.path / "loose.glift").read_text() == "module loose;\nfn f() { }\n", "loose.glift is formatted",
       (many.path / "loose.glift").read_text())
if os.geteuid():  # root writes everything
    many.write("kept.glift", "module   kept;\n")
    (many.path / "kept.glift").chmod(0o444)
    says(many.run("fmt", "kept.glift"), 4, "cannot write 'kept.glift'")
# fmt replaces a file as a whole: the mode and a symbolic link stay, and nothing is left beside it.
link = Folder()
link.write("files/real.glift", "module   real;\n")
(link.path / "files/real.glift").chmod(0o640)
(link.path / "real.glift").symlink_to("files/real.glift")
before = (link.path / "files/real.glift").stat()
says(link.run("fmt", "real.glift"), 0)
after = (link.path / "files/real.glift").stat()
expect((link.path / "real.glift").is_symlink() and (link.path / "files/real.glift").read_text() == "module real;\n",
       "fmt writes through a symbolic link")
expect(after.st_mode == before.st_mode and after.st_ino != before.st_ino, "a new file with the same mode")
expect(link.names("files") == ["real.glift"], "nothing is left beside the file", link.names("files"))
# A limit on the size of files stands for a full disk.
long = "module long;\n" + "".join(f"fn f{i}()->int{{return {i};}}\n" for i in range(200))
link.write("long.glift", long)
ran = subprocess.run(["bash", "-c", f"trap '' XFSZ; ulimit -f 1; exec '{compiler}' fmt long.glift"], cwd=link.path, text=True,
                     capture_output=True)
expect(ran.returncode == 4 and "cannot write 'long.glift'" in ran.stderr, "fmt says that it cannot write", ran.stderr)
expect((link.path / "long.glift").read_text() == long, "the file is as it was")
expect(link.names() == ["files", "long.glift", "real.glift"], "nothing is left beside it", link.names())

# A carriage return alone ends no line, in a comment neither.
with open(link.path / "old.glift", "w", newline="") as old:
    old.write("module old;\n/// one,\rtwo\r\nfn f() {}\n")
says(link.run("--check", "old.glift"), 1, "old.glift:2:9: error: unexpected character U+000D, a carriage return without a line feed")
with open(link.path / "windows.glift", "w", newline="") as windows:
    windows.write("module windows;\r\n/// one\r\npub fn f() {}\r\n")
says(link.run("--check", "windows.glift"), 0)

# `use` finds my-file.glift as my_file, by name, by path and from the command line, and suggests only what parses.
link.write("my-file.glift", "module my_file;\npub const n = 3u;\n")
for use in "my_file", "./my_file":
    link.write("user.glift", f"module user;\nuse {use};\npub fn f() -> uint {{ return n; }}\n")
    says(link.run("--check", "user.glift"), 0)
    says(link.run("--check", "user.glift", "my-file.glift"), 0)
link.write("typo.glift", "module typo;\nuse my_fil;\n")
says(link.run("--check", "typo.glift"), 1, "did you mean 'my_file'?")

# Errors of standard output.
for words in ("fmt", "-"), ("--list-outputs", "good.glift"), ("explain", "unknown-name"), ("--version",), \
        ("--dump", "syntax", "--stop-after", "syntax", "good.glift"):
    with open("/dev/full", "w") as full:
        ran = subprocess.run([compiler, *words], cwd=here.path, text=True, input="module a;\n", stdout=full, stderr=subprocess.PIPE)
    expect(ran.returncode == 4 and "cannot write standard output" in ran.stderr, f"{words} on a full disk", ran.stderr)

says(many.run("fmt", "--help"), 0, "Exit status", "The other files are done")

# Two files of one name in one run: their outputs would have one name, too.
for folder in ("one", "other"):
    here.write(f"{folder}/same.glift", f"module {folder}.same;\npub fn of_{folder}() -> int {{ return 1; }}\n")
says(here.run("-o", "out", "one/same.glift", "other/same.glift"), 2, "'one/same.glift' and 'other/same.glift'", "rename one")
says(here.run("--list-outputs", "one/same.glift", "other/same.glift"), 2, "'one/same.glift' and 'other/same.glift'")
says(here.run("--check", "one/same.glift", "other/same.glift"), 0)
says(here.run("-o", "out", "one/same.glift", "one/../one/same.glift"), 0)
here.write("other/same.glift", "module one.same;\n")
says(here.run("--check", "one/same.glift", "other/same.glift"), 1, "'one.same' is declared twice", "one/same.glift", "another name")

# Sums and products of floats over a subgroup, and sums of floats by scatter, are rounded in an order that depends on the device; the
# other operations here are exact.
here.write("sums.glift", """module sums;
use std.array;
structure Ints = Array<1, uint>;
structure Floats = Array<1, float>;
kernel sum_ints(a: inout each<Ints>) group(64) { a = subgroupAdd(a) + subgroupInclusiveAdd(a); }
kernel multiply_ints(a: inout each<Ints>) group(64) { a = subgroupMul(a); }
kernel extremes(a: inout each<Floats>) group(64) { a = subgroupMax(a) + subgroupExclusiveMin(a); }
kernel sum(a: inout each<Floats>) group(64) { a = subgroupAdd(a); }
kernel sums_before(a: inout each<Floats>) group(64) { a = subgroupExclusiveAdd(float2(a, 1.0)).x; }
kernel sums_to(a: inout each<Floats>) group(64) { a = subgroupInclusiveAdd(a); }
kernel multiply(a: inout each<Floats>) group(64) { a = subgroupMul(a); }
kernel count(a: in each<Ints>, b: out scatter<Ints, add>) { b[a] = 1u; }
kernel least(a: in each<Floats>, b: out scatter<Floats, min>) { b[uint(a)] = a; }
kernel total(a: in each<Floats>, b: out scatter<Floats, add>) { b[uint(a)] = a; }
""")
says(here.run("--target=json", "-o", "sums", "sums.glift"), 0)
kernels = json.loads((here.path / "sums/sums.glift.json").read_text())["kernels"]
exact = {kernel["name"] for kernel in kernels if all(form["exact"] for form in kernel["forms"].values())}
expect(exact == {"sum_ints", "multiply_ints", "extremes", "count", "least"}, "sums and products of floats alone are inexact", exact)
# Instances whose names exceed what file systems allow have shortened ones, which differ.
parameters = [f"element_of_the_structure_{i}" for i in range(12)]
struct = "struct A_struct_with_a_rather_long_name { value: float; }\n"
generics = ", ".join(f"S{i}: Structure<uint, A_struct_with_a_rather_long_name>" for i in range(12))
takes = ", ".join(f"{name}: {'out' if i == 0 else 'in'} each<S{i}>" for i, name in enumerate(parameters))
here.write("long_names.glift", f"""module long_names;
use std.array;
{struct}structure Line = Array<1, A_struct_with_a_rather_long_name>;
kernel copy<{generics}>({takes}) {{ {parameters[0]} = {parameters[1]}; }}
pub pipeline step({", ".join(f"p{i}: inout Line" for i in range(12))}) {{ copy({", ".join(f"p{i}" for i in range(12))}); }}
""")
says(here.run("--target=glsl", "--target=spirv", "-o", "long_names", "long_names.glift"), 0)
expect(all(len(name) < 150 for name in here.names("long_names")), "names of shaders are short", here.names("long_names"))

# A number for each component.
here.write("bordered.glift", "module bordered;\nuse std.array;\npub structure B = Bordered<2, float4>;\n")
says(here.run("explain", "--made", "B(uint2(8, 8), float4(0.0))", "bordered.glift"), 2, "takes 6 numbers, not 3", "each component")
finish()
