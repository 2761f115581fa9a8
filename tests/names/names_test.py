#!/usr/bin/env python3
"""Checks that names which mean something to C++, GLSL or gliftc's own output give C++ and GLSL that compile, wherever the language
allows a name.

    names_test.py GLIFTC INCLUDE_FOLDER CXX [--all] [POSITION…]

For each position in the language (names of fields, of locals, of kernels, …) modules declare each word there, in some positions in
several ways. gliftc compiles the modules to C++ and, for positions whose names reach shaders, to GLSL, and the GLSL to SPIR-V; then the C++
compiler reads the C++ after the C and POSIX headers. Words are keywords of C++ and GLSL, names that headers of C and of the runtime
declare, and names in gliftc's own output; without --all (or GLIFT_NAMES_ALL in the environment) a sample of them.
Left out are reserved words of the language, names that the modules of the position use themselves, and words that begin with z, as most
of the modules' own names do.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from words import LANGUAGE, identifiers_of, words_for

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PRELUDE_BODY = """structure ZLine = Array<1, float>;
kernel zone(zy: out each<ZLine>) { zy = 1.0; }
"""
PRELUDE = "use std.array;\nuse std.linear;\n" + PRELUDE_BODY
BLOCKS = """use std.address;
use std.page_table;
structure ZNumbers = Array<1, uint>;
structure ZPages(zextent: uint2, ztable: ZNumbers, zlist: ZNumbers, zcount: ZNumbers, zmost: uint) {
    memory zframes = Array<2, float>(uint2(64, zmost));
    via PageTable<2, uint2(8, 8)>(zextent, ztable);
    blocks() { return min(zcount[0], zmost); }
    block(zi) { return delinearize(zlist[zi], div_ceil(zextent, uint2(8, 8))) * uint2(8, 8); }
    block_size() { return uint2(8, 8); }
}
"""
BODY = "pub kernel zuse%d(zx: in each<ZLine>, zy: out each<ZLine>) {\n    var zs = zx;\n%s    zy = zs;\n}\n"


def in_body(line):
    """A maker of modules that declare the words, and use them in bodies of kernels, twelve words in each. `line` gives
    (declaration, use) of a word."""
    def module(entries):
        lines = [line(i, w) for i, w in entries]
        uses = [use for _, use in lines]
        return "".join(declaration for declaration, _ in lines) + "".join(
            BODY % (at, "".join(uses[at:at + 12])) for at in range(0, len(uses), 12))
    return module


def declared(line):
    return lambda entries: "".join(line(i, w) for i, w in entries)


def called(line, call, head):
    """A maker of modules of declarations, all of which one pipeline calls."""
    return lambda entries: "".join(line(i, w) for i, w in entries) + head + "".join(
        call(i, w) for i, w in entries) + "}\n"


CPP, ALL = ["--target", "cpp", "--target", "host", "--host-only"], []
# Position: (options of gliftc, cost of a word, maker of a module from numbered words). Samples and modules have fewer words where
# these cost more.
POSITIONS = {
    "fields": (ALL, 1, in_body(lambda i, w: (
        f"pub struct Z{i} {{ {w}: float; zb: uint; }}\n", f"    {{ let zv = Z{i}(zs, 2u); zs = zv.{w}; }}\n"))),
    "structs": (ALL, 1, in_body(lambda i, w: (
        f"pub struct {w} {{ za: float; zb: uint; }}\n", f"    {{ let zv = {w}(zs, 2u); zs = zv.za; }}\n"))),
    "functions": (ALL, 1, in_body(lambda i, w: (
        f"fn {w}(za: float3, zb: float3) -> float {{ if za.x > 1.0 {{ return za.x * zb.y; }} return 2.0; }}\n",
        f"    zs += {w}(float3(zx), float3(1.0));\n"))),
    "parameters": (ALL, 1, in_body(lambda i, w: (
        f"fn zf{i}({w}: float, zb: float) -> float {{ if zb > 1.0 {{ return {w}; }} return zb + {w}; }}\n",
        f"    zs += zf{i}(zx, zx);\n"))),
    "locals": (ALL, 1, in_body(lambda i, w: ("", f"    {{ let {w} = zs * 2.0; var zv = {w}; zv += zs; zs = zv * {w}; }}\n"))),
    "loops": (ALL, 1, in_body(lambda i, w: ("", f"    for {w} in 0..int(zs) {{ zs += float({w}); }}\n"))),
    "local and function": (ALL, 1, in_body(lambda i, w: (
        f"fn {w}(za: float) -> float {{ if za > 1.0 {{ return za; }} return 2.0; }}\n",
        f"    {{ let zv = {w}(zx); let {w} = {w}(zv); zs += {w}; }}\n"))),
    "constants": (ALL, 1, in_body(lambda i, w: (
        f"pub const {w}: float[3] = {{1.0, {i}.0, 3.0}};\n", f"    zs += {w}[uint(zs) % 3u];\n"))),
    "enums": (ALL, 1, in_body(lambda i, w: (
        f"pub enum {w} {{ za, zb }}\n", f"    zs += float(uint({w}.zb));\n"))),
    "enumerators": (ALL, 1, in_body(lambda i, w: (
        f"pub enum Z{i} {{ za, {w}, zb }}\n", f"    zs += float(uint(Z{i}.{w}));\n"))),
    "generics": (ALL, 1, in_body(lambda i, w: (
        f"fn zf{i}<{w}: uint>(za: vec<{w}, float>) -> float {{ return za.x * float({w}); }}\n",
        f"    zs += zf{i}(float3(zs));\n"))),
    "shared": (ALL, 8, declared(lambda i, w: (
        f"pub kernel zk{i}(zx: in each<ZLine>, zy: out each<ZLine>) group(64) {{ shared {w}: float[64]; "
        f"{w}[local_index()] = zx; barrier(); zy = {w}[63u - local_index()]; }}\n"))),
    "kernels": (CPP, 2, called(
        lambda i, w: f"pub kernel {w}(zy: out each<ZLine>, zx: float) {{ zy = zx; }}\n",
        lambda i, w: f"    {w}(zy, 2.0);\n", "pub pipeline zall(zy: out ZLine) {\n")),
    "kernel parameters": (ALL, 8, declared(lambda i, w: (
        f"pub kernel zk{i}({w}: in near<ZLine, 1>, zx: float, zy: out each<ZLine>) {{ zy = {w}[+1] * zx; }}\n"
        f"pub kernel zl{i}({w}: float, zy: out each<ZLine>) {{ zy = {w}; }}\n"))),
    "parameters over blocks": (ALL, 8, lambda entries: BLOCKS + declared(lambda i, w: (
        f"pub kernel zk{i}({w}: float, zg: inout each<ZPages>) {{ zg = {w} * zg + 1.0; }}\n"))(entries)),
    "parameters of groups": (ALL, 8, declared(lambda i, w: (
        f"pub kernel zk{i}({w}: float, zy: inout each<ZLine>) group(64) {{ shared zs: float[64]; zs[local_index()] = {w}; barrier(); "
        f"zy = zs[63u - local_index()] + {w} + float(group_index() + group_count()); }}\n"))),
    "parameters of draws": (ALL, 8, lambda entries: "use std.image;\nstructure ZCorners = Array<1, float4>;\nstructure ZImage = Image<rgba8>;\n"
        + declared(lambda i, w: (
        f"pub raster zd{i}(zc: in each<ZCorners>, {w}: float, zt: out target<ZImage>) {{ linear zv: float; "
        f"vertex {{ zv = {w} * zc.x; place(zc); }} fragment {{ zt = float4(zv + {w}); }} }}\n"))(entries)),
    "functions of structures": (CPP, 1, declared(lambda i, w: (
        f"fn {w}(zn: uint) -> uint {{ var zs = zn; for zi in 0u..zn {{ zs += zi; }} return zs; }}\n"
        f"pub structure Z{i}(zn: uint) {{ memory zdata = buffer<float>[{w}(zn)]; via Linear({w}(zn)); }}\n"
        f"pub kernel zk{i}(zy: inout each<Z{i}>) {{ zy = 2.0; }}\n"
        f"pub translator ZT{i} : uint -> uint {{ zn: uint; domain() {{ return zn; }} translate(za) {{ return {w}(za); }} "
        f"invert(za) {{ return za; }} }}\n"
        f"pub structure ZS{i}(zn: uint) {{ memory zdata = buffer<float>[zn]; via ZT{i}(zn); }}\n"
        f"pub kernel zl{i}(zy: inout each<ZS{i}>) {{ zy = 2.0; }}\n"))),
    "pipelines": (CPP, 1, called(
        lambda i, w: f"pub pipeline {w}(zy: out ZLine) {{ zone(zy); }}\n",
        lambda i, w: f"    {w}(zy);\n", "pub pipeline zall(zy: out ZLine) {\n")),
    "pipeline locals": (CPP, 1, declared(lambda i, w: (
        f"pub pipeline zp{i}({w}: out ZLine, zn: uint) {{ zone({w}[0..zn]); temp za = ZLine(zn); zone(za); }}\n"
        f"pub pipeline zq{i}({w}: uint) {{ temp za = ZLine({w}); zone(za); }}\n"
        f"pub pipeline zr{i}(zn: uint) {{ temp {w} = ZLine(zn); zone({w}); let zm = {w}.extent; temp za = ZLine(zm); zone(za); }}\n"))),
    "aliases": (CPP, 1, declared(lambda i, w: f"pub structure {w} = Array<1, float>;\n")),
    "structures": (ALL, 12, declared(lambda i, w: (
        f"pub structure {w}(zn: uint) {{ memory zdata = buffer<uint>[zn]; via Linear(zn); }}\n"))),
    "structure members": (ALL, 12, declared(lambda i, w: (
        f"pub structure Z{i}({w}: uint) {{ memory zdata = buffer<uint>[{w}]; via Linear({w}); }}\n"
        f"pub structure Y{i}(zn: uint) {{ memory {w} = buffer<uint>[zn]; structure {w}_ = ZLine(zn); via Linear(zn); }}\n"
        f"pub structure X{i}(zn: uint) {{ memory zdata = buffer<uint>[zn]; structure {w} = ZLine(zn); via Linear(zn); }}\n"))),
    "translators": (ALL, 12, declared(lambda i, w: (
        f"pub translator {w} : uint -> uint {{ zn: uint; translate(za) {{ return zn - za; }} domain() {{ return zn; }} }}\n"
        f"pub structure Z{i}(zn: uint) {{ memory zdata = buffer<uint>[zn]; via {w}(zn); }}\n"))),
    "translator fields": (ALL, 12, declared(lambda i, w: (
        f"pub translator T{i} : uint -> uint {{ {w}: uint; translate(za) {{ return {w} - za; }} domain() {{ return {w}; }} }}\n"
        f"pub structure Z{i}(zn: uint) {{ memory zdata = buffer<uint>[zn]; via T{i}(zn); }}\n"))),
    "views": (ALL, 8, declared(lambda i, w: (
        f"pub structure {w}(zs: ZLine) : uint -> float {{ at(zp) {{ return zs[zp]; }} domain() {{ return zs.extent; }} }}\n"
        f"pub kernel zk{i}(zx: in each<{w}>, zy: out each<ZLine>) {{ zy = zx; }}\n"
        f"pub structure V{i}({w}: ZLine) : uint -> float {{ at(zp) {{ return {w}[zp]; }} domain() {{ return {w}.extent; }} }}\n"))),
    "containers": (CPP, 1, declared(lambda i, w: (
        f"pub structure {w}(zn: uint) {{ structure zs = ZLine(zn); pub pipeline zp() {{ zone(zs); }} }}\n"))),
    "structure members": (CPP, 1, declared(lambda i, w: (
        f"pub structure Z{i}({w}: uint) {{ structure zs = ZLine({w}); pub pipeline zp() {{ zone(zs); }} }}\n"
        f"pub structure Y{i}(zn: uint) {{ structure {w} = ZLine(zn); pub pipeline zp() {{ zone({w}); }} }}\n"
        f"pub structure X{i}(zn: uint) {{ structure zs = ZLine(zn); host {w}: uint = 0; pub pipeline zp() {{ {w} += 1; zone(zs); }} }}\n"
        f"pub structure W{i}(zn: uint) {{ structure zs = ZLine(zn); pub pipeline {w}() {{ zone(zs); }} pub pipeline zp() {{ {w}(); }} }}\n"
        f"pub structure V{i}(zn: uint) {{ structure zs = ZLine({w}()); pub fn {w}() -> uint {{ return zn; }} pub pipeline zp() {{ zone(zs[0..{w}()]); }} }}\n"
        f"pub structure U{i}(zn: uint) {{ structure zs = ZLine(zn); pub fn {w}({w}_: uint) -> float {{ return zs[{w}_]; }} }}\n"))),
    "interfaces": (CPP, 1, declared(lambda i, w: f"interface {w} {{ fn {w}(za: uint) -> uint; }}\n")),
    "types": (ALL, 1, in_body(lambda i, w: (
        f"type {w} = float2;\n", f"    {{ let zv = {w}(zs, 2.0); zs = zv.y; }}\n"))),
}


class Failure(Exception):
    pass


def run(command):
    try:
        return subprocess.run(command, capture_output=True, text=True, timeout=300)
    except subprocess.TimeoutExpired:
        raise Failure(f"not done after 300 s: {' '.join(command)}") from None


def module_of(position, chunk, folder, gliftc):
    """Writes a module for words of a position and compiles it by gliftc; returns the paths of the C++ sources of its own
    code (not of the library's)."""
    targets, _, make = POSITIONS[position]
    name = "z" + re.sub(r"\W", "_", position) + f"_{chunk[0][0]}"
    path = folder / f"{name}.glift"
    path.write_text(f"module {name};\n" + PRELUDE + make(chunk))
    done = run([gliftc, "-o", str(folder), *targets, str(path)])
    if done.returncode:
        kept = os.environ.get("GLIFT_NAMES_KEEP")
        if kept:
            pathlib.Path(kept, path.name).write_text(path.read_text())
        raise Failure(f"{position}: gliftc ends with {done.returncode}: {done.stderr[:2000]}")
    return [folder / f"{name}.glift.{part}" for part in ("cpp", "kernels.cpp")]


def compiled(source, folder, cxx, include):
    done = run([*cxx.split(), "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-Wno-unknown-pragmas",
                "-Winvalid-pch", "-include", str(folder / "all.h"), "-I", include, str(source)])
    if done.returncode:
        raise Failure(f"{source.stem}: {done.stderr[:3000]}")


def check(position, chunk, folder, gliftc, cxx, include):
    for source in module_of(position, chunk, folder, gliftc):
        compiled(source, folder, cxx, include)
    return len(chunk)


def check_modules(words, folder, gliftc, cxx, include):
    """Checks names of modules: one C++ file includes all of their headers."""
    text = ""
    for word in words:
        path = folder / f"{word}.glift"
        path.write_text(f"module {word};\npub enum E {{ za }}\n")
        done = run([gliftc, "-o", str(folder), "--target", "cpp", str(path)])
        if done.returncode:
            raise Failure(f"modules: {done.stderr[:2000]}")
        text += f'#include "{word}.glift.hpp"\n'
    source = folder / "zmodules.cpp"
    source.write_text(text)
    compiled(source, folder, cxx, include)
    return len(words)


def main():
    gliftc, include, cxx, *rest = sys.argv[1:]
    everything = "--all" in rest or bool(os.environ.get("GLIFT_NAMES_ALL"))
    wanted = [word for word in rest if word != "--all"]
    with tempfile.TemporaryDirectory(prefix="glift-names-") as name:
        folder = pathlib.Path(name)
        headers = re.findall(r"[\w/]+(?=[ )\n])", re.search(r"c_headers=\((.*?)^for", (ROOT / "tools/cpp-names").read_text(),
                                                             re.S | re.M)[1])
        have = [h for h in headers if any((p / f"{h}.h").exists() for p in map(pathlib.Path, (
            "/usr/include", "/usr/include/x86_64-linux-gnu", "/usr/include/aarch64-linux-gnu")))]
        (folder / "all.h").write_text("".join(f"#include <{h}.h>\n" for h in have) + "".join(
            f"#include <glift/{h}.h>\n" for h in ("glift", "structure", "host/image", "host/math", "host/parallel", "host/report")))
        done = run([*cxx.split(), "-std=c++20", "-I", include, "-x", "c++-header", str(folder / "all.h"), "-o", str(folder / "all.h.gch")])
        if done.returncode:
            raise SystemExit(done.stderr)
        jobs = []
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for position, (_, cost, make) in POSITIONS.items():
                if wanted and position not in wanted:
                    continue
                needed = LANGUAGE | identifiers_of(PRELUDE_BODY + make([(0, "zzz")]))
                words = words_for(ROOT, position, None if everything else max(160 // cost, 16), needed)
                numbered = list(enumerate(words))
                size = max(480 // cost, 40)
                for begin in range(0, len(numbered), size):
                    jobs.append(pool.submit(check, position, numbered[begin:begin + size], folder, gliftc, cxx, include))
            if not wanted or "modules" in wanted:
                words = words_for(ROOT, "modules", None if everything else 80, LANGUAGE)
                jobs.append(pool.submit(check_modules, words, folder, gliftc, cxx, include))
            failures, count = [], 0
            for job in concurrent.futures.as_completed(jobs):
                try:
                    count += job.result()
                except Failure as failure:
                    failures.append(failure)
                    print("FAIL", failure, flush=True)
        print(f"{count} names in {len(wanted) or len(POSITIONS) + 1} positions, {len(failures)} failures")
        raise SystemExit(1 if failures or not count else 0)


if __name__ == "__main__":
    main()
