#!/usr/bin/env python3
"""Checks that a container costs what its memory alone costs: the shaders of two kernels are the same text but for names.

    container_cost_test.py GLIFTC
"""
import pathlib
import re
import subprocess
import sys
import tempfile


def normalised(path):
    """The shader's text without comments and line breaks, each name replaced by its number in the order of first uses."""
    text = re.sub(r"\s+", " ", re.sub(r"//.*", "", path.read_text()))
    numbers = {}
    return re.sub(r"[A-Za-z_]\w*", lambda name: f"n{numbers.setdefault(name[0], len(numbers))}", text)


def main():
    source = pathlib.Path(__file__).with_name("container_cost.glift")
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.argv[1], str(source), "--target", "glsl", "-o", folder], check=True)
        container, memory = (normalised(pathlib.Path(folder) / f"container_cost.{kernel}.comp.glsl")
                             for kernel in ("by_container", "by_memory"))
        if container != memory:
            sys.exit("the kernel over the container has other code than that over its memory")


main()
