#!/usr/bin/env python3
"""Checks the links of all Markdown pages, and the pages that other files name. Needs neither a network nor mkdocs.

- A relative link leads to a file or folder of the repository, its anchor to a heading there.
- Every page of docs/ can be reached from docs/index.md by links.
- A comment or message that names `docs/….md`, or a section of such a page as in `docs/reference/language.md, "Blocks"`,
  names one that is there.
"""
import pathlib
import re
import subprocess
import sys
import urllib.parse

root = pathlib.Path(__file__).resolve().parents[2]
FENCE = re.compile(r"^(```|~~~).*?^\1[^\n]*$", re.M | re.S)
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\])*\]\(([^()\s]+(?:\([^()]*\))?[^()\s]*)\)|<img[^>]* src=\"([^\"]+)\"")
HEADING = re.compile(r"^#{1,6} +(.+?) *$", re.M)
NAMED = re.compile(r"docs/[\w./-]*\w\.(?:md|ebnf|json)")
SECTION = re.compile(r"(docs/[\w./-]*\w\.md)\)?,[\s/#*]*\"([^\"]+)\"")


def tracked(*patterns):
    found = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--", *patterns],
                           cwd=root, capture_output=True, text=True, check=True).stdout
    return [root / name for name in found.split("\0") if name and (root / name).is_file()]


def without_code(text):
    """The text with fenced blocks and code spans blanked, so that lines keep their numbers."""
    blank = lambda match: re.sub(r"[^\n]", " ", match[0])
    return re.sub(r"`[^`\n]+`", blank, FENCE.sub(blank, text))


def slug(heading):
    """The anchor that GitHub, and the site, give a heading."""
    plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").replace("*", "").lower()
    return re.sub(r"[^\w\- ]", "", plain).strip().replace(" ", "-")


class Page:
    def __init__(self, path):
        self.path, text = path, path.read_text(encoding="utf-8")
        prose = without_code(text)
        self.headings = [match[1] for match in HEADING.finditer(FENCE.sub("", text))]
        self.anchors = {slug(heading) for heading in self.headings} | set(re.findall(r'<a id="([^"]+)"', text))
        self.terms = set(self.headings) | set(re.findall(r"\*\*([^*\n]+?)\.?\*\*", text))
        self.links = [(prose[: match.start()].count("\n") + 1, match[1] or match[2]) for match in LINK.finditer(prose)]


def check_links(pages, problems):
    reached = {}
    for page in pages.values():
        for line, link in page.links:
            where = f"{page.path.relative_to(root)}:{line}"
            if re.match(r"[a-z]+:", link):
                continue
            target, _, anchor = urllib.parse.unquote(link).partition("#")
            file = (page.path.parent / target).resolve() if target else page.path
            if not file.exists():
                problems.append(f"{where}: there is no {link}")
            elif anchor and (file not in pages or anchor not in pages[file].anchors):
                problems.append(f"{where}: {file.relative_to(root)} has no heading with the anchor #{anchor}")
            reached.setdefault(page.path, set()).add(file)
    return reached


def check_reachable(pages, reached, problems):
    seen, open_pages = set(), [root / "docs/index.md"]
    while open_pages:
        page = open_pages.pop()
        if page not in seen:
            seen.add(page)
            open_pages += [file for file in reached.get(page, ()) if file in pages]
    for path in pages:
        if path.is_relative_to(root / "docs") and path not in seen:
            problems.append(f"{path.relative_to(root)}: no link leads here from docs/index.md")


def check_names(pages, problems):
    for path in tracked(":!:tests/docs/links.py", ":!:CHANGELOG.md", ":!:*.png"):
        try:
            text = path.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        place = lambda match: f"{path.relative_to(root)}:{text[: match.start()].count(chr(10)) + 1}"
        for match in NAMED.finditer(text):
            if not (root / match[0]).exists() and not (path.parent / match[0]).exists():
                problems.append(f"{place(match)}: there is no {match[0]}")
        for match in SECTION.finditer(text):
            page, section = pages.get(root / match[1]), re.sub(r"[\s/#*]+", " ", match[2])
            if page and section not in page.terms:
                problems.append(f'{place(match)}: {match[1]} has no section "{section}"')


def main():
    pages = {path: Page(path) for path in tracked("*.md")}
    problems = []
    check_reachable(pages, check_links(pages, problems), problems)
    check_names(pages, problems)
    print("\n".join(problems), end="\n" if problems else "")
    sys.exit(1 if problems else 0)


main()
