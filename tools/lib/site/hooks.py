"""What mkdocs does beside its own work: colours for Glift, and lists of pages in the navigation."""
import pathlib
import sys

from pygments.lexers import LEXERS

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import glift_lexer  # noqa: F401  mkdocs takes the folder off the path again; the module stays loaded

LEXERS["GliftLexer"] = ("glift_lexer", "Glift", ("glift",), ("*.glift",), ())


def on_config(config):
    """Replaces `folder/*` in the navigation by the pages of that folder, its index first."""
    source = pathlib.Path(config["docs_dir"])
    for entry in config["nav"]:
        for title, pages in entry.items():
            if isinstance(pages, list) and str(pages[0]).endswith("/*"):
                found = sorted((source / pages[0][:-2]).glob("*.md"), key=lambda page: (page.stem != "index", page.stem))
                entry[title] = [str(page.relative_to(source)) for page in found]
    return config
