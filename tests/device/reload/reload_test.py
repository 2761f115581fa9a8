#!/usr/bin/env python3
"""Edits drift.glift while program.cpp runs it on the host device and on lavapipe. reload_test.py GLIFTC

CXX names the C++ compiler. Prints the time from each save to the new result.
"""
import os
import pathlib
import queue
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading
import time

compiler = pathlib.Path(sys.argv[1]).resolve()
prefix = compiler.parent.parent
sources = pathlib.Path(__file__).resolve().parent
PATIENCE = 300  # seconds, on a machine with other work
failures = 0


def expect(condition, what, said=""):
    global failures
    if not condition:
        failures += 1
        print(f"not so: {what}\n{said}", flush=True)


class Process:
    """A process whose lines can be waited for."""

    def __init__(self, words, folder):
        self.ran = subprocess.Popen(words, cwd=folder, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT)
        self.lines = queue.Queue()
        threading.Thread(target=self.collect, daemon=True).start()

    def collect(self):
        for line in self.ran.stdout:
            self.lines.put(line.strip())
        self.lines.put(None)

    def until(self, is_last):
        """The lines up to one for which this holds."""
        lines = []
        while True:
            line = self.lines.get(timeout=PATIENCE)
            if line is None:
                sys.exit(f"{self.ran.args[0]} ended with {self.ran.wait()}\n" + "\n".join(lines))
            lines.append(line)
            if is_last(line):
                return lines

    def ask(self, command):
        self.ran.stdin.write(command + "\n")
        self.ran.stdin.flush()
        if command == "poll":
            return self.until(lambda line: line in ("loaded", "same"))
        return self.until(lambda line: True)[0].split()

    def end(self):
        self.ran.kill()
        self.ran.wait()


def build(folder):
    """The program, from C++ that gliftc makes as glift_compile does."""
    out = folder / "out"
    subprocess.run([compiler, "--reload", "--spirv-files", "--target=cpp", "--target=host", "-o", out, "drift.glift"],
                   cwd=folder, check=True)
    library = next(path.parent for path in prefix.glob("lib*/**/libglift.*"))
    subprocess.run([*shlex.split(os.environ.get("CXX", "c++")), "-std=c++20", "-O0", "-ffp-contract=off", "-fwrapv", f"-I{out}",
                    f"-I{prefix}/include", f'-DGLIFT_SPIRV_FOLDER="{out}"', sources / "program.cpp", *out.glob("*.cpp"),
                    f"-L{library}", f"-Wl,-rpath,{library}", "-lglift", "-ltbb", "-o", folder / "program"], check=True)


def main():
    with tempfile.TemporaryDirectory() as held:
        folder = pathlib.Path(held)
        shutil.copy(sources / "drift.glift", folder)
        build(folder)
        watch = Process([compiler, "watch", "drift.glift", "-o", "new"], folder)
        watch.until(lambda line: "watching" in line)
        program = Process([folder / "program", "new"], folder)
        try:
            test(folder, watch, program)
        finally:
            watch.end()
            program.end()
    sys.exit(1 if failures else 0)


def test(folder, watch, program):
    text = (folder / "drift.glift").read_text()

    def save(*changes):
        """Edits the file by pairs of texts, and waits for `gliftc watch`. Returns what it says."""
        nonlocal text
        for before, after in changes:
            expect(before in text, f"drift.glift has '{before}'")
            text = text.replace(before, after)
        (folder / "drift.glift").write_text(text)
        return watch.until(lambda line: "new code" in line)

    def says(command, *values):
        said = program.ask(command)
        expect(said == [str(value) for value in values for _ in range(2)], f"{command} gives {values}", said)

    def loads(word, *words):
        said = program.ask("poll")
        expect(said[-1] == word, f"poll finds '{word}'", said)
        for each in words:
            expect(any(each in line for line in said), f"a message says '{each}'", said)

    def shows(before, after, command, value):
        """An edit changes a result; prints the time from the save to it."""
        begin = time.monotonic()
        save((before, after))
        loads("loaded")
        says(command, value)
        print(f"{time.monotonic() - begin:.2f} s from the save of '{after}' to the result on both devices", flush=True)

    # What was built from the same source changes nothing.
    loads("same")
    says("kernel", 21)
    says("pipeline", 42)
    says("replay", 21)

    # The body of a kernel, a function whose value the host passes, a pipeline. Structures keep their elements, recordings their kernels.
    shows("f + 1.0", "f + 2.0", "kernel", 22)
    loads("same")
    says("pipeline", 44)
    says("replay", 21)
    shows("2.0 * k", "3.0 * k", "kernel", 32)
    shows("add(f, g, k);", "add(f, g, 2.0 * k);", "pipeline", 94)
    save(("f + 2.0", "f + 3.0"))
    loads("loaded", "drift::add")
    says("pipeline", 96)  # as the kernel that a reloaded pipeline calls
    shows("f + 3.0", "f + 1.0", "pipeline", 92)
    says("replay", 21)
    program_values = program.ask("structure")
    expect(program_values == ["7", "8"] * 2, "structures keep their elements", program_values)

    # A save that does not compile.
    said = save(("f + 1.0", "f + one"))
    expect("no new code" in said[-1] and any("unknown name 'one'" in line for line in said), "watch shows errors", said)
    loads("same")
    says("kernel", 31)
    shows("f + one", "f + 4.0", "kernel", 34)

    # Other parameters: the old code stays, and what fits is loaded.
    more = [("to: out each<Line>, k: float) { to", "to: out each<Line>, k: float, j: float) { to = j; to"), ("k);\n", "k, 0.0);\n")]
    save(*more)
    said = program.ask("poll")
    for words in "kernel drift::add keeps its old code, since its parameters changed", "build the program again":
        expect(any(words in line for line in said), f"a message says '{words}'", said)
    says("kernel", 34)
    save(*((after, before) for before, after in more))
    program.ask("poll")
    says("kernel", 34)

    # Another declaration of a structure, or another translator: nothing is loaded.
    save(("f + 4.0", "f + 5.0"), ("buffer<float>[2u * extent]", "buffer<float>[3u * extent]"))
    loads("same", "declarations changed: drift::Wide", "build the program again")
    says("kernel", 34)
    save(("return 2u * a", "return 3u * a"))
    loads("same")
    save(("buffer<float>[3u * extent]", "buffer<float>[2u * extent]"), ("return 3u * a", "return 2u * a"))
    loads("loaded")
    says("kernel", 35)
    program_values = program.ask("structure")
    expect(program_values == ["7", "8"] * 2, "structures keep their elements", program_values)

    # A program that was built after the last save has newer code already.
    later = time.time() + 3600
    os.utime(folder / "program", (later, later))
    save(("f + 5.0", "f + 6.0"))
    loads("same")
    says("kernel", 35)

    # Files that are not complete, or of another version.
    announcement = folder / "new" / "reload"
    whole = announcement.read_text()
    title, version, name, size, end = whole.split()
    (folder / "new" / "half.so").write_bytes((folder / "new" / name).read_bytes()[: int(size) // 2])
    (folder / "new" / "text.so").write_text("text")
    for part, message in [
        (f"{title} {version} half.so {size}", ""),
        (f"{title} {version} half.so {size} {end}", "half.so is not complete"),
        (f"{title} {version} missing.so {size} {end}", "missing.so is not complete"),
        (f"{title} 99.0.0 {name} {size} {end}", "gliftc watch is of version 99.0.0"),
        (f"{title} {version} text.so 4 {end}", "cannot load"),
    ]:
        announcement.write_text(part)
        loads("same", message)
    says("kernel", 35)


main()
