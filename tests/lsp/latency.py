#!/usr/bin/env python3
"""Measures how long the language server takes from a change to its diagnostics.

    latency.py GLIFTC [FILE…]        without files: the largest of stdlib and of examples

Each file is changed 20 times by one character, in the middle; the table has the median and the largest of the times, as
the client sees them, and the time that the server computes (of its process), in milliseconds.
"""
import os
import pathlib
import statistics
import sys
import time

from client import Document, Server

root = pathlib.Path(__file__).resolve().parents[2]


def largest(folder):
    return max((root / folder).rglob("*.glift"), key=lambda path: path.stat().st_size)


def cpu_ms(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) * 1000 / os.sysconf("SC_CLK_TCK")


def measure(compiler, path):
    text = path.read_text(encoding="utf-8")
    middle = text.index("\n", len(text) // 2)
    with Server(compiler) as server:
        server.start()
        document = Document(server, path, text)
        document.diagnostics()
        server.request("textDocument/documentSymbol", {"textDocument": {"uri": document.uri}})
        times, before = [], cpu_ms(server.process)
        for i in range(20):
            document.change(text[:middle] + " " * (i + 1) + text[middle:])
            start = time.perf_counter()
            document.diagnostics()
            times.append((time.perf_counter() - start) * 1000)
        computed = (cpu_ms(server.process) - before) / 20
    return statistics.median(times), max(times), computed


def main():
    compiler = pathlib.Path(sys.argv[1]).resolve()
    files = [pathlib.Path(name).resolve() for name in sys.argv[2:]] or [largest("stdlib"), largest("examples")]
    print(f"{'file':40} {'bytes':>7} {'median':>8} {'largest':>8} {'computed':>8}")
    for path in files:
        median, most, computed = measure(compiler, path)
        print(f"{str(path.relative_to(root)):40} {path.stat().st_size:7} {median:8.1f} {most:8.1f} {computed:8.1f}")


main()
