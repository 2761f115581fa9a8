#!/usr/bin/env python3
"""Opens prefixes of library files, as if they were being written, and asks for things at their ends: the server must
answer each time, and never crash.

    prefixes_test.py GLIFTC [--all] [--step BYTES] [FILE…]

Without --all it takes 30 prefixes of each of a few files. With it, every prefix of every file of stdlib, which takes
hours; --step takes every so many bytes only.
"""
import argparse
import pathlib
import sys

from client import Document, Hung, Server

root = pathlib.Path(__file__).resolve().parents[2]
samples = ["structures/sparse", "algorithms/reduce", "structures/image", "math/coverage"]


def prefixes(text, step):
    """Lengths of prefixes in characters; with the sample's long steps also the places behind dots and brackets."""
    return range(1, len(text) + 1, step)


def visit(server, path, text, step):
    document = Document(server, path, "")
    for size in prefixes(text, step):
        document.change(text[:size])
        end = document.position(size)
        try:
            document.diagnostics()
            for method in ["hover", "completion", "signatureHelp", "definition"]:
                document.ask(method, end)
            document.whole("documentSymbol")
            document.whole("semanticTokens/full")
        except (Hung, BrokenPipeError) as error:
            sys.exit(f"{path}: the server ended at the first {size} characters: {error}")
    failures = [line for line in server.logged if "internal error" in line]
    if failures:
        sys.exit(f"{path}: {failures[0]}")
    document.close()
    return len(prefixes(text, step))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("compiler", type=pathlib.Path)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--step", type=int)
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    files = options.files or [root / "stdlib" / (name + ".glift") for name in samples]
    if options.all:
        files = sorted((root / "stdlib").rglob("*.glift"))
    count = 0
    for path in files:
        text = path.read_text(encoding="utf-8")
        step = options.step or (1 if options.all else max(1, len(text) // 30))
        with Server(options.compiler.resolve()) as server:
            server.start()
            count += visit(server, path.resolve(), text, step)
        if options.all:
            print(f"{path.relative_to(root)}: {count} prefixes so far", flush=True)
    print(f"{count} prefixes of {len(files)} files")


main()
