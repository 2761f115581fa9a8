#!/usr/bin/env python3
"""Runs random programs and compares the results of the host device, other devices and the compile-time evaluator.

    generate.py GLIFTC [--seeds FIRST..LAST] [--kernels N] [--minutes M] [--device NAME ...] [--keep FOLDER]
                [--found FOLDER] [--compile-only] [--shrink-steps N]

A program has N kernels with tests. For functions that the compile-time evaluator can compute, it also has constants
that are calls of them, and tests that a kernel computes the same values.
Each program runs under `gliftc test` as it is, with the general form of each kernel (GLIFT_GENERAL_FORM), and with that form and
physical addresses of 64 bits (--address-bits). With --compile-only it is only compiled. A program that fails is shrunk to a small .glift file, which is
printed and stored in the folder of --found (not with --shrink-steps 0). --keep keeps the built programs that pass, which run without
a compiler.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from program import Program
from shrink import Shrinker

COMPILE_SECONDS = 60   # time limit for gliftc
SECONDS = 600          # time limit to compile, build and run in one mode


# How a program is run: the name of each mode, its options of `gliftc test`, and the environment variables that it sets.
MODES = {"": ([], {}), "general": ([], {"GLIFT_GENERAL_FORM": "1"}),
         "64 bits": (["--address-bits=64"], {"GLIFT_GENERAL_FORM": "1"})}


class Outcome:
    """The result of a program. `kind` is the kind of failure, '' for none. `mode` is a key of MODES, `where` what a
    reader is told of it: the mode and the device."""

    def __init__(self, kind, text, seconds=0.0, mode="", where=""):
        self.kind, self.text, self.seconds, self.mode, self.where = kind, text, seconds, mode, where


class Runner:
    def __init__(self, options):
        self.options = options
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="glift-generator-"))
        self.environment = dict(os.environ, GLIFT_CACHE_DIR=str(self.folder / "cache"), NO_COLOR="1")
        self.environment.setdefault("LP_NUM_THREADS", "1")

    def run_command(self, words, seconds, environment=None):
        try:
            done = subprocess.run(words, capture_output=True, text=True, errors="replace", timeout=seconds,
                                  env=environment or self.environment, check=False)
        except subprocess.TimeoutExpired:
            return 124, "timed out"
        return done.returncode, done.stdout + done.stderr

    def compiled(self, name, text):
        """Checks that gliftc accepts the program within the time limit."""
        path = self.folder / f"{name}.glift"
        path.write_text(text)
        start = time.monotonic()
        code, output = self.run_command([self.options.gliftc, "--target", "spirv", "-o", str(self.folder / "out"), str(path)],
                                        COMPILE_SECONDS)
        seconds = time.monotonic() - start
        if code == 0:
            return Outcome("", "", seconds)
        errors = re.findall(r"error: .*\[([\w-]+)\]|Assertion (.*) failed|(internal error.*)", output)
        kind = "timed out" if code == 124 else f"refused: {code} {errors[0] if errors else ''}"
        return Outcome(kind, "\n".join(l for l in output.splitlines() if "warning" not in l)[-3000:], seconds)

    def tested(self, name, text, modes=tuple(MODES)):
        """Compiles, builds and runs the program in the given modes."""
        outcome = self.compiled(name, text)
        if outcome.kind:
            return outcome
        words = [self.options.gliftc, "test", str(self.folder / f"{name}.glift")]
        devices = [["--device", device] for device in self.options.device] or [[]]
        for mode in modes:
            options, variables = MODES[mode]
            for device in devices:
                code, output = self.run_command(words + device + options, SECONDS, dict(self.environment, **variables))
                if code:
                    where = " ".join([mode, *device[1:]])
                    return Outcome(kind_of(code, output), failures_of(output), outcome.seconds, mode, where)
        self.keep(name)
        return outcome

    def keep(self, name):
        if not self.options.keep:
            return
        for folder in (self.folder / "cache" / "tests").iterdir():
            if (folder / f"{name}.glift.cpp").exists():
                shutil.copy(folder / "program", pathlib.Path(self.options.keep) / name)

    def forget(self, name):
        """Deletes a program's build, to save disk space."""
        for folder in (self.folder / "cache" / "tests").glob("*"):
            if (folder / f"{name}.glift.cpp").exists():
                shutil.rmtree(folder)
        shutil.rmtree(self.folder / "out", ignore_errors=True)


def kind_of(code, output):
    if code == 124:
        return "timed out"
    if "the C++ compiler refused" in output:
        return "C++ refused"
    signal = re.search(r"ended by signal (\d+)", output)
    if signal:
        return f"signal {signal[1]}"
    return "tests failed" if "FAIL" in output else f"exit {code}"


def failures_of(output):
    found, in_failure = [], False
    for line in output.splitlines():
        in_failure = line.startswith("FAIL") or (in_failure and line.startswith("      "))
        if in_failure or line.startswith("gliftc") or "error:" in line:
            found.append(line)
    return "\n".join(found[:30])


def shrink(runner, program, failure, options):
    """Writes the smallest program that was found to fail in the same way to a file; returns its path."""
    kind = failure.kind

    def fails(text):
        outcome = runner.compiled(program.module, text)
        if kind.startswith(("refused", "timed out")):
            return outcome.kind == kind
        if outcome.kind:
            return False
        outcome = runner.tested(program.module, text, [failure.mode])
        runner.forget(program.module)
        return outcome.kind == kind
    title = re.search(r"^FAIL  (\w+) ", failure.text, re.MULTILINE)
    Shrinker(program, fails, options.shrink_steps).run(title[1] if title else "")
    found = pathlib.Path(options.found)
    found.mkdir(parents=True, exist_ok=True)
    path = found / f"{program.module}.glift"
    path.write_text(program.text())
    runner.run_command([options.gliftc, "fmt", str(path)], COMPILE_SECONDS)
    return path


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("gliftc")
    parser.add_argument("--seeds", default="1..1000000", help="FIRST..LAST, both included")
    parser.add_argument("--kernels", type=int, default=40, help="kernels of a program")
    parser.add_argument("--minutes", type=float, help="no program begins later than this")
    parser.add_argument("--device", action="append", default=[], help="what the host device is compared with; repeatable")
    parser.add_argument("--compile-only", action="store_true", help="compile, and build and run nothing")
    parser.add_argument("--keep", help="a folder for built programs")
    parser.add_argument("--found", default="found", help="a folder for programs that fail")
    parser.add_argument("--shrink-steps", type=int, default=400, help="programs tried while shrinking one")
    return parser.parse_args()


def main():
    options = parse_arguments()
    options.gliftc = os.path.abspath(options.gliftc)
    first, last = (int(part) for part in options.seeds.split(".."))
    runner, start = Runner(options), time.monotonic()
    ran = kernels = failed = 0
    slowest = (0.0, "")
    for seed in range(first, last + 1):
        if options.minutes and time.monotonic() - start > options.minutes * 60:
            break
        program = Program(seed, options.kernels)
        outcome = (runner.compiled if options.compile_only else runner.tested)(program.module, program.text())
        ran, kernels = ran + 1, kernels + program.text().count("\nkernel ")
        slowest = max(slowest, (outcome.seconds, program.module))
        runner.forget(program.module)
        if outcome.kind:
            failed += 1
            print(f"FAIL  {program.module}: {outcome.kind} {outcome.where}\n{outcome.text}", flush=True)
            if options.shrink_steps:
                path = shrink(runner, program, outcome, options)
                print(f"shrunk to {path}:\n{path.read_text()}", flush=True)
    shutil.rmtree(runner.folder)
    print(f"{ran} programs, {kernels} kernels, {failed} failed; the longest compilation took {slowest[0]:.2f} s ({slowest[1]}); "
          f"{time.monotonic() - start:.0f} s")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
