"""What mkdocs does beside its own work: colours for Glift, and lists of pages in the navigation."""
import pathlib
import re
import sys

from pygments.lexers import LEXERS

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import glift_lexer  # noqa: F401  mkdocs takes the folder off the path again; the module stays loaded

LEXERS["GliftLexer"] = ("glift_lexer", "Glift", ("glift",), ("*.glift",), ())


def pages_of(folder):
    """The pages of a folder: the index, those that it links, in its order, then all others."""
    index = (folder / "index.md").read_text(encoding="utf-8")
    linked = [folder / name for name in dict.fromkeys(re.findall(r"\]\(([\w.-]+\.md)\)", index)) if (folder / name).exists()]
    return list(dict.fromkeys([folder / "index.md", *linked, *sorted(folder.glob("*.md"))]))


def on_config(config):
    """Replaces `folder/*` in the navigation by the pages of that folder."""
    source = pathlib.Path(config["docs_dir"])
    for entry in config["nav"]:
        for title, pages in entry.items():
            if str(pages).endswith("/*"):
                entry[title] = [str(page.relative_to(source)) for page in pages_of(source / pages[:-2])]
    return config
