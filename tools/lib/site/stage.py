"""Copies the pages to build/site-source: docs/, and README.md of the examples and of the root. A link to another file of the repository
leads to a copy of that file.

    stage.py OUTPUT [DOXYGEN_FOLDER]
"""
import pathlib
import re
import shutil
import sys

root = pathlib.Path(__file__).resolve().parents[3]
output = pathlib.Path(sys.argv[1])
LINK = re.compile(r"(\]\()([^)\s]+)(\))")
FENCE = re.compile(r"^```.*?^```", re.M | re.S)


def staged_names():
    """Where each page of the repository is in the site."""
    names = {page: page.relative_to(root / "docs") for page in (root / "docs").rglob("*") if page.is_file()}
    for page in (root / "examples").rglob("README.md"):
        folder = page.parent.relative_to(root / "examples")
        names[page] = pathlib.Path("examples") / ("index.md" if folder == pathlib.Path(".") else f"{folder}.md")
    for name in ("ARCHITECTURE", "CONTRIBUTING", "CHANGELOG", "README"):
        names[root / f"{name}.md"] = pathlib.Path("internals") / f"{name.lower()}.md"
    return names


def relative(target, page):
    """The path from the folder of a page to a target, both in the site."""
    up = len(page.parent.parts)
    common = 0
    while common < up and common < len(target.parts) - 1 and page.parent.parts[common] == target.parts[common]:
        common += 1
    return "/".join([".."] * (up - common) + list(target.parts[common:]))


def rewritten(text, page, names):
    def replace(match):
        link, _, anchor = match[2].partition("#")
        if not link or re.match(r"[a-z]+:", link):
            return match[0]
        target = (page.parent / link).resolve()
        if target.is_dir():
            return match[0]
        if target not in names:
            names[target] = pathlib.Path("files") / target.relative_to(root).with_name(target.name + ".txt")
            (output / names[target]).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(target, output / names[target])
        return match[1] + relative(names[target], names[page]) + (f"#{anchor}" if anchor else "") + match[3]

    parts, last = [], 0
    for fence in FENCE.finditer(text):
        parts += [LINK.sub(replace, text[last : fence.start()]), fence[0]]
        last = fence.end()
    return "".join(parts) + LINK.sub(replace, text[last:])


def main():
    shutil.rmtree(output, ignore_errors=True)
    names = staged_names()
    doxygen = "The site has [all classes and functions](../cpp/annotated.html), made by Doxygen.\n" if len(sys.argv) > 2 else ""
    for page, name in list(names.items()):
        (output / name).parent.mkdir(parents=True, exist_ok=True)
        if page.suffix != ".md":
            shutil.copyfile(page, output / name)
            continue
        text = rewritten(page.read_text(encoding="utf-8"), page, names)
        (output / name).write_text(text.replace("<!-- doxygen -->\n", doxygen), encoding="utf-8")
    if doxygen:
        shutil.copytree(sys.argv[2], output / "cpp")
    for name in ("glift.css", "iframe-worker.js"):
        shutil.copyfile(pathlib.Path(__file__).parent / name, output / name)


main()
