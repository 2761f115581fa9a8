#!/usr/bin/env python3
"""Checks the code of the pages.

    snippets.py glift GLIFTC            each block in Glift, by gliftc --check
    snippets.py cpp GLIFTC CXX [FLAG…]  all blocks in C++, in one run of the C++ compiler

Without files named after `--`, the pages are README.md and all below docs/ and examples/; those of the tutorial are run by tutorial.py,
internals and pages made from sources are not checked.

A block in C++ is the body of a function. A comment `<!-- given: TYPE NAME, … -->` before it declares what the text around it says is
there; `<!-- fragment -->` excludes a block. It may use the modules of the page's blocks in Glift that begin with `module`.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"((?:^<!--[^\n]*-->\n)?)^```(\w+)([^\n]*)\n(.*?)^```", re.S | re.M)


def pages():
    if "--" in sys.argv:
        return [pathlib.Path(name) for name in sys.argv[sys.argv.index("--") + 1 :]]
    found = [root / "README.md", *sorted((root / "docs").rglob("*.md")), *sorted((root / "examples").rglob("*.md"))]
    made = ["docs/internals", "docs/reference/library", "docs/reference/diagnostics.md"]
    return [page for page in found if not any(page.is_relative_to(root / name) for name in made)]


def blocks(page, language):
    text = page.read_text(encoding="utf-8")
    for block in BLOCK.finditer(text):
        is_file_of_tutorial = language == "cpp" and "title=" in block[3]
        if block[2] == language and "fragment" not in block[1] and not is_file_of_tutorial:
            yield text[: block.start(4)].count("\n") + 1, block[1], block[4]


def check_glift(gliftc):
    """Checks each block by itself, in a folder with the modules of the page and of those beside it, which it may import."""
    passed, failures = 0, []
    for page in pages():
        with tempfile.TemporaryDirectory() as folder:
            sources = []
            for module, source in ((m, s) for other in page.parent.glob("*.md") for m, s in modules_of(other).items()):
                (pathlib.Path(folder) / f"{module}.glift").write_text(source)
            for line, _, source in blocks(page, "glift"):
                name = re.search(r"^module (\w+);", source, re.M)
                path = pathlib.Path(folder) / f"{name[1] if name else f'snippet_{line}'}.glift"
                path.write_text(source if name else f"module snippet_{line};\n{source}")
                sources.append((line, path, path.read_text()))
            for line, path, source in sources:
                path.write_text(source)  # a later block may have the same module in another version
                run = subprocess.run([gliftc, "--check", path], capture_output=True, text=True)
                passed += run.returncode == 0
                if run.returncode != 0:
                    failures.append(f"{page}:{line}: does not compile\n{run.stderr}{run.stdout}")
    return passed, failures


def modules_of(page):
    return {name[1]: source for _, _, source in blocks(page, "glift") if (name := re.search(r"^module (\w+);", source, re.M))}


def function_of(page, line, comment, source):
    """A block as C++ at the top level: its includes, and a function with the rest."""
    given = re.search(r"given: (.*?) *-->", comment)
    includes = "".join(re.findall(r"^#include <[^\n]*\n", source, re.M))
    body = re.sub(r"^#include[^\n]*\n", "", source, flags=re.M)
    place = f'#line {line + source[: source.find(body[:1])].count(chr(10))} "{page}"\n'
    if re.search(r"^int main\(", body, re.M):
        return f"{includes}namespace snippet_{line} {{\n{place}{body}}}\n"
    return f"{includes}inline void snippet_{page.stem.replace('-', '_')}_{line}({given[1] if given else ''}) {{\n{place}{body}}}\n"


def check_cpp(gliftc, compiler, flags):
    with tempfile.TemporaryDirectory() as name:
        folder, modules, text, count = pathlib.Path(name), {}, "", 0
        for page in pages():
            fragments = list(blocks(page, "cpp"))
            if fragments:
                modules |= modules_of(page)
            text += "".join(function_of(page, *fragment) for fragment in fragments)
            count += len(fragments)
        for module, source in modules.items():
            (folder / f"{module}.glift").write_text(source)
        files = [folder / f"{module}.glift" for module in modules]
        run = subprocess.run([gliftc, "-o", folder, "--target=cpp", "--host-only", *files], capture_output=True, text=True)
        if run.returncode != 0:
            return 0, [run.stderr]
        headers = "".join(f'#include "{module}.glift.hpp"\n' for module in modules)
        (folder / "all.cpp").write_text(headers + "#include <glift/glift.h>\n" + text)
        run = subprocess.run([compiler, "-std=c++20", "-fsyntax-only", "-Wno-unused", f"-I{root}/runtime/include", f"-I{root}/files/include", f"-I{folder}",
                              *flags, folder / "all.cpp"], capture_output=True, text=True)
        return (count, []) if run.returncode == 0 else (0, [run.stderr])


def main():
    words = sys.argv[1 : sys.argv.index("--")] if "--" in sys.argv else sys.argv[1:]
    passed, failures = check_glift(words[1]) if words[0] == "glift" else check_cpp(words[1], words[2], words[3:])
    print("\n".join(failures), f"{passed} passed, {len(failures)} failed", sep="\n")
    sys.exit(1 if failures or not passed else 0)


main()
