#!/usr/bin/env python3
"""Tests `gliftc watch`: saves of files and imports, errors, the files that it writes. watch_test.py GLIFTC"""
import queue
import subprocess
import threading
import time

from gliftc import Folder, compiler, expect, finish, says

PATIENCE = 300  # seconds, on a machine with other work
here = Folder()


class Watch:
    def __init__(self, *words):
        self.ran = subprocess.Popen([compiler, "watch", *words], cwd=here.path, text=True, stdout=subprocess.PIPE,
                                    stderr=subprocess.STDOUT)
        self.lines = queue.Queue()
        threading.Thread(target=lambda: [self.lines.put(line) for line in self.ran.stdout], daemon=True).start()

    def until(self, words):
        """What it says up to a line with these words."""
        said = ""
        while words not in said:
            said += self.lines.get(timeout=PATIENCE)
        return said

    def end(self):
        self.ran.kill()
        self.ran.wait()


def objects():
    return [name for name in here.names("new") if name.endswith(".so")]


def named():
    """The object that the folder's file `reload` names; it has the size that is written there."""
    title, version, name, size, end = (here.path / "new" / "reload").read_text().split()
    expect((title, end) == ("glift-reload", "end"), "'reload' is complete", title + end)
    expect((here.path / "new" / name).stat().st_size == int(size), "the object has the size that 'reload' says", size)
    return name


says(here.run("watch"), 2, "files is required")
says(here.run("watch", "line.glift"), 2, "name a folder, from which programs load")
says(here.run("watch", "-", "-o", "new"), 2, "standard input cannot be watched")
here.write("line.glift", "module line;\nuse std.array;\npub structure Line = Array<1, float>;\n")
says(here.run("watch", "line.glift", "-o", "new", CXX="no-such-compiler", timeout=PATIENCE), 4, "need a C++ compiler", "no-such-compiler")

here.write("parts/rate.glift", "module rate;\npub const rate = 2.0;\n")
here.write("line.glift", """module line;
use std.array;
use rate;
pub structure Line = Array<1, float>;
pub kernel scale(f: inout each<Line>) { f *= rate; }
""")
watch = Watch("line.glift", "-I", "parts", "-o", "new")
try:
    said = watch.until("watching")
    expect("programs load from new" in said, "it names the folder", said)
    first = named()

    def save(name, before, after):
        """Edits a file. Returns what is said then."""
        text = (here.path / name).read_text()
        expect(before in text, f"{name} has '{before}'", text)
        here.write(name, text.replace(before, after))
        return watch.until("new code")

    begin = time.monotonic()
    said = save("line.glift", "f *= rate", "f *= 3.0 * rate")
    print(f"{time.monotonic() - begin:.2f} s from a save to a new object")
    expect("line.glift: new code after" in said, "it says how long the build took", said)
    second = named()
    expect(second != first, "each object has a name of its own", first)

    said = save("parts/rate.glift", "2.0", "4.0")
    expect("rate.glift: new code after" in said, "imports are watched", said)
    third = named()
    expect(third not in (first, second), "each object has a name of its own", third)

    said = save("line.glift", "f *= 3.0", "f *= three")
    expect("line.glift: no new code" in said and "line.glift:5:46: error: unknown name 'three' [unknown-name]" in said, "it shows errors", said)
    expect(named() == third, "a file with errors makes no object")
    said = save("line.glift", "f *= three", "f *= 5.0")
    expect("new code after" in said, "it goes on after an error", said)

    # As editors do: a new file takes the name of the old one.
    text = (here.path / "line.glift").read_text()
    (here.path / "line.glift").rename(here.path / "line.glift~")
    time.sleep(0.1)
    here.write("line.new", text.replace("5.0", "6.0"))
    (here.path / "line.new").rename(here.path / "line.glift")
    expect("new code after" in watch.until("new code"), "a file may be replaced")
    expect(len(objects()) == 3, "it keeps three objects", objects())
finally:
    watch.end()
finish()
