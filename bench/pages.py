#!/usr/bin/env python3
"""Draws how fast paged arrays are read, by the size of a page: one row of panels per device, like figure 6.1 of Lefohn's
thesis (2006).

    bench/pages.py FILE.json -o FILE

FILE.json is that of bench_pages or of `run.py --json`. FILE ends in .svg or .png.
"""
import argparse
import json
import sys

import plot

ACCESS = ("coherent", "random")
TABLES = {1: "one level", 2: "two levels"}


def load(file):
    with open(file, encoding="utf-8") as text:
        found = json.load(text)
    return found["pages"] if isinstance(found, dict) else found


def draw_panel(axes, device, number, access):
    rows = [row for row in device["rows"] if row["axes"] == number]
    sizes = sorted({row["page"] for row in rows if row["levels"]})
    dense = next(row for row in rows if not row["levels"])
    axes.plot(sizes, [dense[access]] * len(sizes), color="grey", linestyle="--", linewidth=1.2, label="no pages")
    for k, (levels, name) in enumerate(TABLES.items()):
        points = sorted((row["page"], row[access]) for row in rows if row["levels"] == levels)
        axes.plot(*zip(*points), label=name, color=plot.COLOURS[k], marker=plot.MARKERS[k], markersize=4)
    axes.set_xscale("log", base=2)
    axes.set_xticks(sizes, [str(size) for size in sizes])
    axes.set_ylim(bottom=0)
    side = device["plane" if number == 2 else "volume"]
    axes.set_title(f"{device['device']}: {access}, {side}^{number}", fontsize=9)
    axes.set_xlabel(f"side of a page, {number}-D", fontsize=9)
    axes.set_ylabel("GB/s of elements", fontsize=9)
    axes.grid(True, which="major", linewidth=0.4, alpha=0.6)
    axes.legend(fontsize=8)


def draw(devices, file):
    plt = plot.pyplot()
    panels = [(number, access) for number in (2, 3) for access in ACCESS]
    figure, rows = plt.subplots(len(devices), len(panels), figsize=(3.9 * len(panels), 3.2 * len(devices)), squeeze=False,
                                layout="constrained")
    for row, device in zip(rows, devices):
        for axes, (number, access) in zip(row, panels):
            draw_panel(axes, device, number, access)
    figure.savefig(file, dpi=100)
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file")
    parser.add_argument("-o", dest="output", required=True)
    options = parser.parse_args()
    try:
        draw(load(options.file), options.output)
    except plot.NothingToDrawWith as error:
        sys.exit(f"pages.py: {error}")


if __name__ == "__main__":
    main()
