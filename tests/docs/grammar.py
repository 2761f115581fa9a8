#!/usr/bin/env python3
"""Checks docs/reference/grammar.ebnf against the tables of the lexer: it lists the same keywords and contextual keywords (words), uses each
of them in a rule except those that are reserved for later, uses every punctuation, and defines each rule that it uses exactly
once."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parents[2]
tokens = (root / "compiler/syntax/tokens.def").read_text()
grammar = (root / "docs/reference/grammar.ebnf").read_text()
table = {kind: set(re.findall(rf"^{kind}\((\w+)\)", tokens, re.M)) for kind in ("KEYWORD", "WORD")}
lists = re.search(r"Keywords are never names.*?\*\)", grammar, re.S)[0]
keywords, words = lists.split("Words mean something", 1)
keywords = set(re.search(r"\n\n(.*?)\n\n", keywords, re.S)[1].split())
words = {word for line in words.splitlines()[2:] for word in re.findall(r"^ {7}\w[\w ]*?  +(.*)", line)[:1] for word in word.replace("*)", "").split()}
rules = re.sub(r"\(\*.*?\*\)", "", grammar, flags=re.S)
quoted = set(re.findall(r'"([^"\n]+)"', rules))
punctuation = set(re.findall(r'^PUNCTUATION\(\w+, "(.*)"\)', tokens, re.M))
later = {"allocator", "activate"}
defined = re.findall(r"^([a-z][a-z-]*) +=", rules, re.M)
used = set(re.findall(r"(?<![\w\"-])[a-z]+(?:-[a-z]+)*(?![\w\"-])", re.sub(r'"[^"\n]*"|\'[^\'\n]*\'|any character[^}|]*', "", rules)))

problems = [f"keywords: {sorted(keywords ^ table['KEYWORD'])}" if keywords != table["KEYWORD"] else "",
            f"words: {sorted(words ^ table['WORD'])}" if words != table["WORD"] else ""]
problems += [f"no rule has '{text}'" for text in sorted((table["KEYWORD"] | table["WORD"] | punctuation) - quoted - later)]
problems += [f"no rule defines {name}" for name in sorted(used - set(defined))]
problems += [f"{name} is defined {defined.count(name)} times" for name in sorted(set(defined)) if defined.count(name) > 1]
problems = [problem for problem in problems if problem]
print("\n".join(problems))
sys.exit(1 if problems else 0)
