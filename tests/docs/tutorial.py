#!/usr/bin/env python3
"""Does what the tutorial says, in an empty folder: writes its files, runs its commands, compares what they print and draw.

    tutorial.py BUILD_TREE            fails if a page says what is not so
    tutorial.py BUILD_TREE --update   writes the pictures of the pages

- ```LANGUAGE title="NAME"   a file, in full
- ```console                 lines that begin with `$ ` are commands, the others are what they print. A line `…` stands for any
                             lines, `…` within a line for any text. `<!-- not run -->` before a block excludes it.
- `<!-- made: NAME -->`      before a picture: the file that a command wrote, which has the picture's bytes
- `<!-- with: NAME=VALUE -->` before a block: environment of its commands, and of those after it
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
tutorial = root / "docs/tutorial"
STEP = re.compile(r"((?:^<!--[^\n]*-->\n)*)(?:^```(\w+)(?: title=\"([^\"]+)\")?\n(.*?)^```|^!\[[^\]]*\]\(([^)]+)\))", re.S | re.M)


def pages():
    """In the order in which index.md links them."""
    index = (tutorial / "index.md").read_text(encoding="utf-8")
    return [tutorial / name for name in dict.fromkeys(re.findall(r"\]\(([\w-]+\.md)\)", index))]


def matches(expected, printed):
    pattern = "".join(r"(?:.*\n)*?" if line.strip() == "…" else ".*".join(map(re.escape, line.split("…"))) + r"\n" for line in expected)
    return re.fullmatch(pattern, printed)


class Run:
    def __init__(self, build, folder, update):
        self.folder, self.update, self.problems, self.commands, self.pictures = folder, update, [], 0, 0
        self.environment = {**os.environ, "PATH": f"{build / 'bin'}:{os.environ['PATH']}", "GLIFT_QUIET": "1"}
        if shutil.which("ccache"):  # so that only the first run compiles
            self.environment |= {"CMAKE_CXX_COMPILER_LAUNCHER": "ccache", "CCACHE_BASEDIR": str(folder), "CCACHE_NOHASHDIR": "1"}

    def do(self, page, line, comment, language, title, text, picture):
        where = f"{page.relative_to(root)}:{line}"
        for name, value in re.findall(r"with: (\w+)=(\S*)", comment):
            self.environment[name] = value
        if title:
            (self.folder / title).write_text(text)
        elif language == "console" and "not run" not in comment:
            self.run_block(where, text.splitlines())
        elif made := re.search(r"made: (\S+)", comment):
            self.compare_picture(where, self.folder / made[1], page.parent / picture)

    def run_block(self, where, lines):
        at = 0
        while at < len(lines):
            command = lines[at].removeprefix("$ ")
            while command.endswith("\\"):
                at += 1
                command = command[:-1] + lines[at]
            end = next((i for i in range(at + 1, len(lines)) if lines[i].startswith("$ ")), len(lines))
            result = subprocess.run(["bash", "-c", command], cwd=self.folder, env=self.environment, text=True,
                                    stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
            self.commands += 1
            if not matches(lines[at + 1 : end], result.stdout):
                expected = "\n".join(lines[at + 1 : end])
                self.problems.append(f"{where}: '{command}' prints\n{result.stdout}\nand not\n{expected}")
            at = end

    def compare_picture(self, where, made, shown):
        self.pictures += 1
        if not made.is_file():
            self.problems.append(f"{where}: no command wrote {made.name}")
        elif self.update:
            shown.parent.mkdir(exist_ok=True)
            shutil.copyfile(made, shown)
        elif not shown.is_file() or made.read_bytes() != shown.read_bytes():
            self.problems.append(f"{where}: {made.name} is not the picture that the page shows")


def main():
    build, update = pathlib.Path(sys.argv[1]).resolve(), "--update" in sys.argv[2:]
    with tempfile.TemporaryDirectory(prefix="glift-tutorial-") as folder:
        run = Run(build, pathlib.Path(folder), update)
        for page in pages():
            text = page.read_text(encoding="utf-8")
            for step in STEP.finditer(text):
                comment, language, title, body, picture = step.groups()
                run.do(page, text[: step.start()].count("\n") + 1 + comment.count("\n"), comment, language, title, body, picture)
    print(f"{run.commands} commands, {run.pictures} pictures, {len(run.problems)} problems", *run.problems, sep="\n")
    sys.exit(1 if run.problems or not run.commands else 0)


main()
