#!/usr/bin/env python3
"""Tests that `gliftc test` checks the translators of members at any depth, as a test leaves them: a defect is planted in a copy of the
library, in a translator that a container uses inside of another container. planted_translators_test.py GLIFTC"""
import pathlib
import shutil

from gliftc import Folder, expect, finish, says

here = Folder()
library = pathlib.Path(__file__).resolve().parents[2] / "stdlib"

PROGRAM = """module planted;
use std.array;
use std.page_allocator;
use std.sparse;
use {module};

structure Inner(extent: uint2, frames: uint) {{
    structure grid = {grid};
}}

structure Outer(extent: uint2) {{
    structure inner = Inner(extent, 8u);
}}

structure List = Array<1, uint2>;

kernel request(at: in each<List>, outer: calls<Outer>) {{ outer.inner.grid.{request}; }}

test "a container in a container" {{
    temp outer = Outer(uint2({extent}, 16u));
    temp list = List(1u);
    request(list, outer);
    outer.inner.grid.allocate();
    expect(await outer.inner.grid.status().resident == 1u);
}}
"""

PAGES = ("translators/page_table.glift", "return uint2(linearize(va % page, page), entry - 1u);",
         "return uint2(linearize(va % page, page) / 2u, entry - 1u);")
# The table of two levels alone, which has one axis.
TOP = (PAGES[0], PAGES[1], "return uint2(linearize(va % page, page) / (N == 1u ? 2u : 1u), entry - 1u);")
HASH = ("structures/sparse_hashed.glift", "return uint2(linearize(va % page, page), entry);",
        "return uint2(linearize(va % page, page) / 2u, entry);")
FRAMES = (PAGES[0], "return frame_place<N>(va.y, bits) * page + delinearize(va.x, page);",
          "return frame_place<N>(va.y, bits) * page + delinearize(va.x / 2u, page);")

SPARSE = "Sparse<2, float, uint2(4, 4), policy: drop>(extent, frames, -1.0)"
BUMP = "Sparse<2, float, uint2(4, 4), policy: drop, allocation: bump>(extent, frames, -1.0)"
LEVELS = "Sparse<2, float, uint2(4, 4), policy: drop, Table: TwoLevels<4>>(extent, frames, -1.0)"
HASHED = "SparseHashed<2, float, uint2(4, 4)>(frames, -1.0)"
OCTREE = "Adaptive<2, r32f, 4u>(3u, frames)"

CASES = (("sparse", SPARSE, PAGES, 18, "Paged<2, float, uint2(4, 4), OneLevel>", "field"),
         ("sparse", SPARSE, PAGES, 100000, "Paged<2, float, uint2(4, 4), OneLevel>", "field"),  # not all addresses are tried
         ("sparse", BUMP, PAGES, 18, "Paged<2, float, uint2(4, 4), OneLevel>", "field"),
         ("two_levels", LEVELS, PAGES, 18, "Paged<2, float, uint2(4, 4), TwoLevels<4>>", "field"),
         ("two_levels", LEVELS, TOP, 18, "Paged<1, uint, 4>", "table.entries"),
         ("sparse_hashed", HASHED, HASH, 18, "HashedField<2, float, uint2(4, 4), Array<1, uint2>, Array<2, float>>", "field"),
         ("adaptive", OCTREE, FRAMES, 18, "FrameImage<2, r32f, uint2(5, 5)>", "frames"))


def program(module, grid, extent):
    request = "request(at, 0u)" if module == "adaptive" else "request(at)"
    return PROGRAM.format(module="std." + module, grid=grid, extent=f"{extent}u", request=request)


def run(module, grid, extent, folder):
    here.write("planted.glift", program(module, grid, extent))
    return here.run("test", "--device", "host", "--library", folder, "planted.glift")


for number, (module, grid, (file, right, wrong), extent, structure, member) in enumerate(CASES):
    copy = here.path / f"library{number}"
    shutil.copytree(library, copy)
    text = (copy / file).read_text()
    expect(text.count(right) == 1, f"{file} has '{right}' once")
    (copy / file).write_text(text.replace(right, wrong))
    ran = run(module, grid, extent, copy)
    says(ran, 1, f"FAIL  translation of {structure}, as the tests made it", f"it is outer.inner.grid.{member}")
    expect(" both map to " in ran.said or "invert(translate(" in ran.said, "the addresses are named", ran.said)

for module, grid in dict.fromkeys((module, grid) for module, grid, *_ in CASES):
    ran = run(module, grid, 18, library)
    says(ran, 0, "pass  a container in a container", ": 0 failed")
finish()
