#!/usr/bin/env python3
"""Tests `gliftc test`: failures, translators that cannot be checked, crashes. test_command_test.py GLIFTC"""
import os

from gliftc import Folder, expect, finish, says, sources

wrong = sources / "wrong_translations.glift"
here = Folder()

ran = here.run("test", wrong)
says(ran, 1,
     "FAIL  translation of Folded", "{0} and {1} both map to {0}",
     "FAIL  translation of Curve, as the tests made it", "invert(translate({1, 0})) is {0, 1}",
     "FAIL  translation of Places, as the tests made it", "{2} and {7} both map to {2}",
     "FAIL  translation of Rows", "both map to {0} (domain {4, 4}); if it is meant to be so, declare the translator @many_to_one",
     "FAIL  translation of Backwards", "{0} maps to {16}, outside of the memory, which is {16} (domain {16})",
     "FAIL  translation of Listing, as the tests made it", "pass  translation of Anywhere, as the tests made it",
     "{2} and {7} both map to {2} (domain {16}); whether it may is not checked: it reads tables",
     "expect: 'await list[7] == 3u' is false: list[7] is 2, expected == 3 [host]", " is {0.5, 1}, expected != {0.5, 1} [",
     "'await list[1] == 2u || await list[2] == 3u' is false [",
     "not checked: translation of Unmade", "it is not public, and no test makes one",
     "not checked: translation of MadeInside", "it takes other arguments than an extent, and no test that ran has one at its end",
     "pass  a square", "8 failed, 2 not checked",
     "FAIL  memories are compared where the domain is too large", "big: its domain is {8192, 8200}, too large", "big.data",
     "pass  more elements than are compared", "not compared: rows, which has more than 4 GiB")

expect("list[2] == 9u" not in ran.said, "a condition is evaluated only if those before it are true", ran.said)

ran = here.run("test", "--list", wrong)
says(ran, 0, "a square (wrong_translations.glift:", "translation of Folded (")
expect("pass" not in ran.said, "--list runs nothing", ran.said)
says(here.run("test", "--filter", "typo", wrong), 2, "no test has 'typo' in its title")
# A run that checks nothing does not pass.
says(here.run("test", "--device", "host", "--filter", "Unmade", wrong), 1, "0 tests on the host: 0 failed, 1 not checked")
says(here.run("test", "--filter", "a square", wrong, GLIFT_DEVICE="host"), 0, " on the host: 0 failed")
says(here.run("test", "--filter", "a square", wrong, CXX="no-such-compiler"), 4,
     "there is no 'no-such-compiler' here", "CXX")

# `gliftc test` reuses a program that it built before if the files that it read are unchanged and `use` finds no other file earlier in
# its search order.
here.write("user.glift", "module user;\nuse base;\ntest \"the base\" { expect(base_value() == 1u); }\n")
base = "module base;\npub fn base_value() -> uint {{ return {}u; }}\n"
here.write("late/base.glift", base.format(1))
run_user = ("test", "--device", "host", "-I", here.path / "early", "-I", here.path / "late", here.path / "user.glift")
first = here.run(*run_user)
says(first, 0, "pass  the base")
expect(here.run(*run_user).said == first.said, "a second run says the same", first.said)
here.write("late/base.glift", base.format(2))
says(here.run(*run_user), 1, "FAIL  the base")
here.write("late/base.glift", base.format(1))
says(here.run(*run_user), 0, "pass  the base")
here.write("early/base.glift", base.format(3))
says(here.run(*run_user), 1, "FAIL  the base")
here.write("user.glift", "module user;\nuse base;\ntest \"the base\" { let unused = 1; expect(base_value() == 3u); }\n")
for again in "", " again":
    says(here.run(*run_user), 0, "warning", "pass  the base")

# The title of a remembered test does not take in a part of the file's name.
here.write("two words.glift", "module two_words;\ntest \"one\" { expect(1u == 1u); }\n")
says(here.run("test", "--device", "host", "two words.glift"), 0, "pass  one")
says(here.run("test", "--filter", "words", "two words.glift"), 2, "no test has 'words' in its title")

# The header of an `extern struct` may lie beside an imported module in another folder.
here.write("sub/particle.hpp", "struct Particle { float mass; };\n")
here.write("sub/mesh.glift", "module mesh;\npub extern struct Particle from \"particle.hpp\";\n")
here.write("heavy.glift", """module heavy;
use std.array;
use ./sub/mesh;
structure Particles = Array<1, Particle>;
test "mass" {
    temp all = Particles(3);
    expect(await all[1].mass == 0.0);
}
""")
says(here.run("test", "--device", "host", "heavy.glift"), 0, "pass  mass")

# A program that was built with other options is another one: `-g` names the lines of the source in it, `-O` optimises.
cache = here.path / "cache"
here.write("clean.glift", "module clean;\ntest \"one\" { expect(1u == 1u); }\n")
for options, programs in ((), 1), ((), 1), (("-g",), 2), (("-O",), 3):
    says(here.run("test", "--device", "host", *options, here.path / "clean.glift", GLIFT_CACHE_DIR=str(cache)), 0, "pass  one")
    remembered = len(list(cache.rglob("run-*")))
    expect(remembered == programs, f"programs remembered with {options}", str(remembered))

# After an edit of a kernel only its own source is compiled again.
edited = """module edited;
use std.array;
structure Line = Array<1, uint>;
kernel fill(to: out each<Line>) {{ to = {}u; }}
test "filled" {{
    var line = Line(4u);
    fill(line);
    expect(await line[2] == 5u);
}}
"""
objects = 0
for value, exit_code, says_so, compiled in (5, 0, "pass  filled", 4), (6, 1, "FAIL  filled", 1), (5, 0, "pass  filled", 0):
    here.write("edited.glift", edited.format(value))
    says(here.run("test", "--device", "host", here.path / "edited.glift", GLIFT_CACHE_DIR=str(here.path / "objects")), exit_code, says_so)
    expect(len(list((here.path / "objects").rglob("object-*"))) == (objects := objects + compiled), f"compiled for {value}")

# A test that ends the program is named in the report. The signal stands for a driver that crashes when the program exits.
here.write("crash.hpp", "inline void crash() {}\n")
cxx = os.environ.get("CXX", "c++")
here.write("killer", f"#!/bin/sh\nexec {cxx} \"$@\" -include {here.path / 'crash.h'}\n")
here.write("crash.h", "#pragma once\n#include <csignal>\n#include <cstdlib>\n"
           "namespace { struct Killer { Killer() { if (std::getenv(\"GLIFT_TEST_NOW\")) std::atexit([] "
           "{ std::raise(SIGKILL); }); } } killer; }\n")
(here.path / "killer").chmod(0o755)
ran = here.run("test", "--device", "host", "--filter", "halves", wrong, CXX=str(here.path / "killer"))
says(ran, 1, "FAIL  halves (wrong_translations.glift:", "[host]", "ended by signal 9 (Killed)")

# A test that hangs is named, too, with the device, and ends after the time-out; the ones before it have been reported.
here.write("hang.glift", """module hang;
structure Line = Array<1, uint>;
kernel never_ends(to: out each<Line>) {
    var x = 1u;
    while x != 0u {
        x = (x * 1664525u + 1013904223u) | 1u;
    }
    to = x;
}
test "quick" { expect(1u == 1u); }
test "endless" {
    temp line = Line(1u);
    never_ends(line);
    expect(await line[0] == 0u);
}
""")
ran = here.run("test", "--device", "host", "--timeout", "2", "hang.glift", timeout=300)
says(ran, 1, "pass  quick", "FAIL  endless (hang.glift:11)", "no result after 2 s (--timeout) [host]")

# What the surroundings cause is no bug in gliftc, whatever the compiler says.
here.write("env.glift", "module env;\nuse std.array;\nkernel f(x: out each<Array<1, uint>>) { x = 1u; }\n"
           "test \"one\" { temp x = Array<1, uint>(4u); f(x); expect(await x[3] == 1u); }\n")
here.write("no_tbb", f"""#!/bin/sh
case " $* " in *" -ltbb "*) echo "ld: cannot find -ltbb" >&2; exit 1 ;; esac
exec {cxx} "$@"
""")
here.write("cxx17", f"#!/bin/sh\nexec {cxx} \"$@\" -std=c++17\n")
here.write("starved", "#!/bin/sh\nkill -9 $$\n")
here.write("full", "#!/bin/sh\necho 'Fatal error: No space left on device' >&2; exit 1\n")
# A compiler that compiles Glift's headers and refuses the generated code: that one is gliftc's.
here.write("refuses", f"""#!/bin/sh
for word; do
    case "$word" in */env.glift.cpp) echo "$word:3:1: error: refused" >&2; exit 1 ;; esac
done
exec {cxx} "$@"
""")
for name in "no_tbb", "cxx17", "starved", "full", "refuses":
    (here.path / name).chmod(0o755)
for chosen, code, words in (("./no_tbb", 4, "could not link the tests of env"), ("./cxx17", 4, "C++20"),
                            ("./starved", 4, "signal 9 (Killed) ended it"), ("./full", 4, "there is no space"),
                            ("true", 4, "made no program"), (f"{cxx} -nonsense", 4, "could not compile the tests of env"),
                            ("./refuses", 3, "This is a bug in gliftc")):
    ran = here.run("test", "--device", "host", "env.glift", CXX=chosen, GLIFT_CACHE_DIR=str(here.path / "of" / chosen.strip("./")))
    says(ran, code, words)
    expect(("internal error" in ran.said) == (code == 3), f"CXX={chosen}", ran.said)

# Paths that are quoted for the compiler and the assembler; no folder for temporary files. Both devices: SPIR-V is embedded.
says(here.run("test", "env.glift", GLIFT_CACHE_DIR=str(here.path / 'a "quoted" \\ folder'), TMPDIR="/nonexistent"), 0, "pass  one")
# A blank CXX means c++.
ran = here.run("test", "--device", "host", "env.glift", CXX="  ", PATH="", GLIFT_CACHE_DIR=str(here.path / "blank"))
says(ran, 4, "there is no 'c++' here")
finish()
