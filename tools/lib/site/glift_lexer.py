"""Glift for Pygments. Keywords come from the lexer of gliftc (compiler/syntax/tokens.def)."""
import pathlib
import re

from pygments.lexer import RegexLexer, words
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation, String, Text

__all__ = ["GliftLexer"]

tokens_def = (pathlib.Path(__file__).resolve().parents[3] / "compiler/syntax/tokens.def").read_text(encoding="utf-8")
KEYWORDS = re.findall(r"^KEYWORD\((\w+)\)", tokens_def, re.M)
WORDS = re.findall(r"^WORD\((\w+)\)", tokens_def, re.M)
TYPE = r"(?:bool|u?int(?:64)?|float|half|double)(?:[234](?:x[234])?)?|vec|mat"


class GliftLexer(RegexLexer):
    name, aliases, filenames = "Glift", ["glift"], ["*.glift"]
    tokens = {
        "root": [
            (r"\s+", Text),
            (r"///.*", String.Doc),
            (r"//.*", Comment.Single),
            (r"/\*[\s\S]*?\*/", Comment.Multiline),
            (r'"(?:\\.|[^"\\\n])*"', String),
            (r"@\w+", Name.Decorator),
            (r"(?:0x[0-9a-fA-F]+|\d+\.\d+(?:e[+-]?\d+)?|\d+)(?:ul|[ulfhd])?\b", Number),
            (rf"(?:{TYPE})\b", Keyword.Type),
            (words(("true", "false", "none"), suffix=r"\b"), Keyword.Constant),
            (words(KEYWORDS, suffix=r"\b"), Keyword),
            (words(WORDS, suffix=r"\b"), Keyword.Pseudo),
            (r"[A-Z]\w*", Name.Class),
            (r"\w+(?=\()", Name.Function),
            (r"\w+", Name),
            (r"[-+*/%<>=!&|^?~]+|\.\.|…", Operator),
            (r".", Punctuation),
        ]
    }
