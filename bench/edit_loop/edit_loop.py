#!/usr/bin/env python3
"""Measures the time from an edit of one kernel's body to a linked program: bench/edit_loop/app.glift, in user CPU seconds.

    bench/edit_loop/edit_loop.py GLIFTC INCLUDE LIBRARY_FOLDER [--runs N]

The time is user time of gliftc, of the C++ compiler and of the linker, so that other work on the machine counts little.
Prints the least time of N edits and that of the first build, at -O2 and at -O0. Only those C++ sources are compiled again
that gliftc wrote again, but all of them if it wrote a header again. The compiler's options are those of glift_compile, but
for the level of optimisation.
"""
import argparse
import os
import pathlib
import resource
import subprocess
import tempfile

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


def user_time(*command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    subprocess.run([str(c) for c in command], check=True)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


class App:
    def __init__(self, folder, arguments, optimise):
        self.folder, self.arguments, self.optimise = folder, arguments, optimise
        self.source = folder / "app.glift"
        self.source.write_text((HERE / "app.glift").read_text())
        (folder / "main.cpp").write_text(MAIN)
        self.compiled = {}

    def build(self):
        spent = user_time(self.arguments.gliftc, "-o", self.folder, "--target=cpp", "--target=host", "--spirv-files",
                          "--shards=4", self.source)
        for source in sorted(self.folder.glob("*.cpp")):
            written = max(p.stat().st_mtime_ns for p in [source, *self.folder.glob("*.hpp")])
            if self.compiled.get(source) == written:
                continue
            self.compiled[source] = written
            spent += user_time("g++", *FLAGS, f'-DGLIFT_SPIRV_FOLDER="{self.folder}"', self.optimise, "-I", self.arguments.include, "-I", self.folder, "-c", source,
                               "-o", source.with_suffix(".o"))
        library = self.arguments.library
        return spent + user_time("g++", *self.folder.glob("*.o"), f"-L{library}", f"-Wl,-rpath,{library}", "-lglift", "-ltbb",
                                 "-o", self.folder / "app")

    def edit(self, k):
        text = (HERE / "app.glift").read_text()
        self.source.write_text(text.replace("from + amount * detail", f"from + amount * {k + 2}.0 * detail"))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("gliftc")
    parser.add_argument("include")
    parser.add_argument("library")
    parser.add_argument("--runs", type=int, default=3)
    arguments = parser.parse_args()
    for optimise in ("-O2", "-O0"):
        with tempfile.TemporaryDirectory() as name:
            app = App(pathlib.Path(name), arguments, optimise)
            first, edits = app.build(), []
            for k in range(arguments.runs):
                app.edit(k)
                edits.append(app.build())
            print(f"{optimise}: first build {first:.2f} s, edit {min(edits):.2f} s")


os.environ.pop("GLIFT_STDLIB", None)
main()
