#!/usr/bin/env python3
"""Saves random containers from one device, loads them on another one, and compares all that they consist of, bit for bit.

    saved.py GLIFTC BUILD_TREE [--seeds FIRST..LAST] [--cxx COMPILER] [--found FOLDER]

A program has one container, whose members are random structures (structures.py) and containers of the library; some of them are
containers of containers. Its memories are filled at random (tests/device/files/snapshot.h) on the host device and on the device
that GLIFT_DEVICE names, in turn. A program that fails is stored in the folder of --found.
"""
import argparse
import os
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

from declarations import Types
from model import INT, UINT, Items, Node, vector
from random_numbers import Random
from structures import Structures, extent_text

ROOT = pathlib.Path(__file__).resolve().parents[2]
USES = ["address", "array", "edge", "functions", "hash_map", "hash_set", "image", "linear", "lists", "n_stack", "ordered_hash_map", "page_allocator", "queue",
        "sparse", "sparse_hashed", "tiled", "two_levels"]
MOST_MEMBERS = 7  # of a container


class SavedProgram:
    def __init__(self, seed):
        self.module = f"saved_{seed}"
        self.random = random = Random(seed)
        self.types = Types(random)
        self.structures = Structures(random, self.types)
        self.items = Items(self.types.declarations())
        self.items.parts += self.structures.declarations(random.between(5, 8))
        made = [self.structure(s) for s in {s.whole or s.name: s for s in self.structures.all}.values()]
        made += [self.of_library() for _ in range(random.between(4, 7))]
        self.add_containers(random.shuffled(made))

    def extent(self, axes):
        return [self.random.between(1, 9) for _ in range(axes)]

    def structure(self, structure):
        return structure.make(self.extent(structure.axes))

    def element(self):
        return self.random.choice(self.structures.elements).text()

    def of_library(self):
        """A container of the library, made with random arguments."""
        random, t, count = self.random, self.element(), self.random.between(1, 40)
        axes = random.between(1, 3)
        page = extent_text([random.between(1, 4) for _ in range(axes)])
        policy = random.choice(["fail", "drop", "evict", "grow"])
        layout = random.choice(["together", "apart"])
        word = random.choice(["uint", "int", "float"])
        key = vector(random.between(1, 3), random.choice([UINT, INT])).text()
        table = random.choice(["", ", Table: TwoLevels<4>"])
        sparse = f"Sparse<{axes}, {t}, {page}, Overflow.{policy}, layout: Layout.{layout}{table}>({extent_text(self.extent(axes))}, {random.between(1, 9)}u)"
        hashed = f"SparseHashed<{axes}, {t}, {page}, layout: Layout.{layout}>({random.between(1, 9)}u)"
        return random.choice([sparse, sparse, hashed, f"HashMap<{word}, {t}>({count}u)", f"OrderedHashMap<{key}, {t}>({count}u)",
                              f"HashSet<{word}>({count}u)", f"Queue<{t}>({count}u)", f"Lists<{t}>({count}u, {count}u)",
                              f"Image<rgba8>({extent_text(self.extent(2))})", f"Array<4, {t}>({extent_text(self.extent(4))})"])

    def add_containers(self, made):
        """Containers of the members, and of the containers before them; the last one has all."""
        number = 0
        while True:
            members, made = made[:MOST_MEMBERS], made[MOST_MEMBERS:]
            lines = [f"    host state{i}: {t.text()} = {self.structures.zero(t)};"
                     for i, t in enumerate(self.random.choice(self.types.scalars + self.types.vectors) for _ in range(2))]
            lines += [f"    structure m{i} = {member};" for i, member in enumerate(members)]
            name = "Saved" if not made else f"C{number}"
            body = "\n".join(lines)
            self.items.parts.append(Node(f"{'pub ' * (not made)}structure {name}(n: uint) {{\n{body}\n}}"))
            if not made:
                return
            made.append(f"{name}({self.random.between(1, 9)}u)")
            number += 1

    def text(self):
        uses = "\n".join(f"use std.{name};" for name in USES)
        return f"module {self.module};\n{uses}\n{self.items.text()}\n"

    def main(self):
        return f'''#include "{self.module}.glift.hpp"
#include "snapshot.h"
#include <glift/files.h>
#include <glift/glift.h>
#include <cstdio>
using S = {self.module}::Saved;
int main() {{
    const glift::Device devices[] = {{glift::Device::open("host"), glift::Device::open()}};
    std::size_t bytes = 0;
    for (unsigned from = 0; from < 2; ++from) {{
        const S saved(devices[from], 3u);
        snapshot::fill_at_random(saved, from + 1);
        const snapshot::Snapshot before = snapshot::of(saved);
        for (const auto& [path, content] : before) bytes += content.size();
        glift::save("saved.h5", "it", saved);
        const S made = glift::load<S>("saved.h5", "it", devices[1 - from]);
        S existing(devices[1 - from], 3u);
        glift::load("saved.h5", "it", existing);
        for (const S& other : {{made, existing}}) {{
            const std::string difference = snapshot::difference(before, snapshot::of(other));
            if (!difference.empty()) return std::printf("from device %u: %s\\n", from, difference.c_str()), 1;
        }}
    }}
    std::printf("%zu bytes\\n", bytes);
}}
'''


class Runner:
    def __init__(self, options):
        self.options, self.build = options, pathlib.Path(options.build).resolve()
        self.compiler = shlex.split(options.cxx)
        if shutil.which("ccache"):
            self.compiler.insert(0, "ccache")

    def run(self, program, folder):
        """Returns what went wrong, or an empty text, and what the program printed."""
        (folder / f"{program.module}.glift").write_text(program.text())
        (folder / "main.cpp").write_text(program.main())
        out, libraries = folder / "out", [self.build / "lib", self.build / "files"]
        steps = [[self.options.gliftc, "-o", out, folder / f"{program.module}.glift"], None, [folder / "program"]]
        for step in steps:
            done = subprocess.run(step or self.compile(folder, out, libraries), cwd=folder, capture_output=True, text=True, check=False)
            if done.returncode:
                return "\n".join(line for line in (done.stdout + done.stderr).splitlines() if "warning" not in line)[-3000:], ""
        return "", done.stdout.strip()

    def compile(self, folder, out, libraries):
        tests = ROOT / "tests/device/files"
        flags = ["-std=c++20", "-O0", "-w", "-ffp-contract=off", "-fwrapv", f"-I{ROOT}/runtime/include", f"-I{ROOT}/files/include", f"-I{out}", f"-I{tests}"]
        links = [word for library in libraries for word in (f"-L{library}", f"-Wl,-rpath,{library}")] + ["-lglift_files", "-lglift", "-ltbb", "-ldl", "-pthread"]
        return [*self.compiler, *flags, folder / "main.cpp", *sorted(out.glob("*.cpp")), tests / "snapshot.cpp", "-o", folder / "program", *links]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gliftc", type=os.path.abspath)
    parser.add_argument("build", help="where lib/ is")
    parser.add_argument("--seeds", default="1..10", help="FIRST..LAST, both included")
    parser.add_argument("--cxx", default="c++")
    parser.add_argument("--found", default="found", help="a folder for programs that fail")
    options = parser.parse_args()
    first, last = (int(part) for part in options.seeds.split(".."))
    runner, start, failed = Runner(options), time.monotonic(), 0
    for seed in range(first, last + 1):
        program = SavedProgram(seed)
        with tempfile.TemporaryDirectory(prefix="glift-saved-") as name:
            problem, printed = runner.run(program, pathlib.Path(name))
        print(f"{'FAIL' if problem else 'pass'}  {program.module}: {problem or printed}", flush=True)
        if problem:
            failed += 1
            os.makedirs(options.found, exist_ok=True)
            (pathlib.Path(options.found) / f"{program.module}.glift").write_text(program.text())
    print(f"{last - first + 1} programs, {failed} failed; {time.monotonic() - start:.0f} s")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
