#!/usr/bin/env python3
"""Runs random programs whose operands log that they are evaluated, and compares the logs with the order that the language defines.

    evaluation.py GLIFTC [--seeds FIRST..LAST] [--bodies N] [--minutes M] [--device NAME] [--keep FOLDER] [--shrink]

A program has N kernels and N pipelines, each with a test. Calls of `note_…` append a number to the log c[0]. This generator
evaluates each body itself: operands once, from left to right, and only where they count.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from evaluated import shrunk
from evaluated_kernels import KernelMaker
from evaluated_pipelines import PipelineMaker
from random_numbers import Random

SECONDS = 600

PRELUDE = """
use std.array;

struct Pair {
    x: uint;
    y: uint;
}

structure Line = Array<1, uint>;

fn note_uint(c: inout coherent<Line>, number: uint, value: uint) -> uint {
    c[0] = c[0] * 31u + number;
    return value;
}

fn note_bool(c: inout coherent<Line>, number: uint, value: bool) -> bool { return note_uint(c, number, 0u) == 0u && value; }

fn note_pair(c: inout coherent<Line>, number: uint, value: uint) -> Pair { return Pair(note_uint(c, number, value), number); }

fn note_optional(c: inout coherent<Line>, number: uint, has: bool, value: uint) -> uint? {
    let noted = note_uint(c, number, value);
    if has {
        return noted;
    }
    return none;
}

fn sum_of(a: uint, b: uint, d: uint) -> uint { return a + 3u * b + 5u * d; }

fn sum_of_pair(p: Pair, b: uint) -> uint { return p.x + 7u * p.y + 11u * b; }

kernel append(_x: in each<Line>, c: inout coherent<Line>, number: uint) { c[0] = c[0] * 31u + number; }

kernel append_both(_x: in each<Line>, c: inout coherent<Line>, a: uint, b: uint) { c[0] = (c[0] * 31u + a) * 31u + b; }

kernel number(a: at<Line>, to: out each<Line>) { to = a + 10u; }

pipeline device_uint(c: Line, number: uint, value: uint) -> uint {
    append(c[0..1], c, number);
    return c[0] * 0u + value;
}

pipeline host_uint(c: Line, number: uint, value: uint) -> uint { return await device_uint(c, number, value); }

pipeline host_bool(c: Line, number: uint, value: bool) -> bool { return await device_uint(c, number, 1u) == 1u && value; }
"""


def program(name, makers):
    return "\n".join([f"module {name};", PRELUDE] + [maker.text() for maker in makers])


class Runner:
    def __init__(self, options, folder):
        self.options, self.folder = options, folder
        self.environment = dict(os.environ, GLIFT_CACHE_DIR=str(folder / "cache"), NO_COLOR="1")
        self.environment.setdefault("LP_NUM_THREADS", "1")

    def output(self, name, text):
        """What is printed where the program fails; none if it passes."""
        path = self.folder / f"{name}.glift"
        path.write_text(text)
        words = [self.options.gliftc, "test", str(path)]
        if self.options.device:
            words[2:2] = ["--device", self.options.device]
        try:
            done = subprocess.run(words, capture_output=True, text=True, errors="replace", timeout=SECONDS, env=self.environment,
                                  check=False)
        except subprocess.TimeoutExpired:
            return "timed out"
        return None if done.returncode == 0 else done.stdout + done.stderr

    def run(self, seed):
        """Whether the program passes. Prints one that fails, shrunk to a body."""
        random, name = Random(seed), f"evaluation_{seed}"
        makers = []
        for number in range(self.options.bodies):
            makers += [KernelMaker(random, f"k{number}"), PipelineMaker(random, f"p{number}")]
        output = self.output(name, program(name, makers))
        if output is None:
            return True
        print(f"FAIL  {name}", flush=True)
        failed = re.search(r"^FAIL  (\w+) ", output, re.MULTILINE)
        makers = [maker for maker in makers if failed and maker.name == failed[1]] or makers

        def fails():
            text = self.output(name, program(name, makers))
            return text is not None and bool(re.search(r"^FAIL  ", text, re.MULTILINE)) == bool(failed)
        if len(makers) == 1 and self.options.shrink:
            shrunk(makers[0].body, fails)
        text = program(name, makers)
        output = self.output(name, text) or output
        shown = [line for line in output.splitlines() if not line.startswith("pass") and "warning" not in line]
        print("\n".join(shown[:30]), makers[0].text() if len(makers) == 1 else "", flush=True)
        if self.options.keep:
            pathlib.Path(self.options.keep, f"{name}.glift").write_text(text)
        return False


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gliftc")
    parser.add_argument("--seeds", default="1..1000000", help="FIRST..LAST, both included")
    parser.add_argument("--bodies", type=int, default=25, help="kernels, and pipelines, of a program")
    parser.add_argument("--minutes", type=float, help="no program begins later than this")
    parser.add_argument("--device", default="", help="what the host device is compared with")
    parser.add_argument("--keep", help="a folder for programs that fail")
    parser.add_argument("--shrink", action="store_true", help="shrink the first body that fails")
    options = parser.parse_args()
    options.gliftc = os.path.abspath(options.gliftc)
    first, last = (int(part) for part in options.seeds.split(".."))
    start, ran, failed = time.monotonic(), 0, 0
    with tempfile.TemporaryDirectory(prefix="glift-evaluation-") as name:
        runner = Runner(options, pathlib.Path(name))
        for seed in range(first, last + 1):
            if options.minutes and time.monotonic() - start > options.minutes * 60:
                break
            ran += 1
            failed += not runner.run(seed)
    print(f"{ran} programs, {failed} failed; {time.monotonic() - start:.0f} s")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
