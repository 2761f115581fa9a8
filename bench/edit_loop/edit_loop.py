#!/usr/bin/env python3
"""Measures the time from an edit of bench/edit_loop/app.glift to a linked program.

    bench/edit_loop/edit_loop.py GLIFTC INCLUDE LIBRARY_FOLDER [--runs N]

Two edits of one kernel's body: one that changes only the kernel's code, and one of a factor that is uniform, so that the
host's function that calls the kernel, which computes it once a call, changes too. Prints the medians of N edits, in
seconds of the wall clock, at -O2 and at -O0. C++ sources are compiled by as many jobs as there are cores, only those that
gliftc wrote again, but all of them if it wrote a header again. The compiler's options are those of glift_compile, but for
the level of optimisation.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).parent
FLAGS = ["-std=c++20", "-ffp-contract=off", "-fwrapv", "-fno-math-errno", "-fno-trapping-math"]
MAIN = """#include "app.glift.hpp"
int main() {
    auto device = glift::Device::open("host");
    app::Image image(device, {64, 64});
    app::Levels bright(device, 4096);
    app::Bins bins(device, 16);
    return static_cast<int>(app::analyse(device, image, 0.5f, bright, bins, 16u));
}
"""


EDITED = "from + amount * detail"
EDITS = {"a kernel's own code": "from + amount * (detail + {}.0)", "a uniform factor": "from + amount * {}.0 * detail"}


def run(*command):
    subprocess.run([str(c) for c in command], check=True)


class App:
    def __init__(self, folder, arguments, optimise):
        self.folder, self.arguments, self.optimise = folder, arguments, optimise
        self.source = folder / "app.glift"
        self.source.write_text((HERE / "app.glift").read_text())
        (folder / "main.cpp").write_text(MAIN)
        self.compiled = {}

    def build(self):
        started = time.monotonic()
        run(self.arguments.gliftc, "-o", self.folder, "--target=cpp", "--target=host", "--spirv-files", "--shards=4", self.source)
        headers = [p.stat().st_mtime_ns for p in self.folder.glob("*.hpp")]
        written = {p: max(p.stat().st_mtime_ns, *headers) for p in self.folder.glob("*.cpp")}
        with ThreadPoolExecutor(os.cpu_count()) as jobs:
            list(jobs.map(self.compile, sorted(p for p in written if written[p] != self.compiled.get(p))))
        self.compiled = written
        library = self.arguments.library
        run("g++", *self.folder.glob("*.o"), f"-L{library}", f"-Wl,-rpath,{library}", "-lglift", "-ltbb", "-o", self.folder / "app")
        return time.monotonic() - started

    def compile(self, source):
        run("g++", *FLAGS, f'-DGLIFT_SPIRV_FOLDER="{self.folder}"', self.optimise, "-I", self.arguments.include, "-I", self.folder,
            "-c", source, "-o", source.with_suffix(".o"))

    def edit(self, wanted):
        text = (HERE / "app.glift").read_text()
        assert EDITED in text
        self.source.write_text(text.replace(EDITED, wanted))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("gliftc")
    parser.add_argument("include")
    parser.add_argument("library")
    parser.add_argument("--runs", type=int, default=5)
    arguments = parser.parse_args()
    for optimise in ("-O2", "-O0"):
        with tempfile.TemporaryDirectory() as name:
            app = App(pathlib.Path(name), arguments, optimise)
            first = app.build()
            for name, wanted in EDITS.items():
                times = []
                for k in range(arguments.runs + 1):
                    app.edit(wanted.format(k + 2))
                    times.append(app.build())
                print(f"{optimise}: edit of {name} {statistics.median(times[1:]):.2f} s (first build {first:.2f} s)", flush=True)


os.environ.pop("GLIFT_STDLIB", None)
main()
