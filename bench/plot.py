#!/usr/bin/env python3
"""Draws throughput against size: a panel for each algorithm, a line for Glift and for each rival (other implementation).

    bench/plot.py FILE.json... -o FILE

The files are those of `run.py --json`, bench_algorithms, bench_rivals or the CUDA rivals. FILE ends in .svg or .png. If
there are several devices, each has a file of its own, named after it.
"""
import argparse
import math
import os
import re
import sys

import figures

COLUMNS = 3
COLOURS = ["#d55e00", "#0072b2", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"]   # safe for colour blindness
MARKERS = "osD^vP"


class NothingToDrawWith(Exception):
    pass


def pyplot():
    try:
        import matplotlib
    except ImportError as error:
        raise NothingToDrawWith("python3-matplotlib is not installed") from error
    matplotlib.use("Agg")
    import matplotlib.pyplot
    return matplotlib.pyplot


def styles(panels):
    """The colour and marker of each maker (`by` in a row), the same in every panel; Glift first."""
    makers = [figures.OURS] + sorted({by for lines in panels.values() for by in lines} - {figures.OURS})
    return {by: {"color": COLOURS[k % len(COLOURS)], "marker": MARKERS[k % len(MARKERS)]} for k, by in enumerate(makers)}


def draw_panel(axes, title, lines, style):
    for by, rows in sorted(lines.items(), key=lambda line: line[0] != figures.OURS):
        axes.plot([row["elements"] for row in rows], [figures.throughput(row) for row in rows], label=by,
                  linewidth=2 if by == figures.OURS else 1.2, markersize=4, **style[by])
    axes.set_xscale("log", base=2)
    axes.set_yscale("log")
    axes.set_title(title, fontsize=10)
    axes.grid(True, which="major", linewidth=0.4, alpha=0.6)
    axes.legend(fontsize=8)


def draw(group, file):
    """Draws the figure of a device to a file; the extension gives the format."""
    plt = pyplot()
    panels = figures.panels(group)
    rows = math.ceil(len(panels) / COLUMNS)
    figure, all_axes = plt.subplots(rows, COLUMNS, figsize=(4.2 * COLUMNS, 3.1 * rows), squeeze=False, layout="constrained")
    style = styles(panels)
    flat = [axes for row in all_axes for axes in row]
    for axes, (title, lines) in zip(flat, panels.items()):
        draw_panel(axes, title, lines, style)
    for axes in flat[len(panels):]:
        axes.remove()
    figure.suptitle(group["device"])
    figure.supxlabel("elements", fontsize=10)
    figure.supylabel("G elements/s", fontsize=10)
    figure.savefig(file, dpi=110)
    plt.close(figure)


def file_name(device):
    return re.sub(r"[^a-z0-9]+", "-", device.lower()).strip("-")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+")
    parser.add_argument("-o", dest="output", required=True)
    options = parser.parse_args()
    groups = [group for group in figures.joined([group for file in options.files for group in figures.load(file)])
              if figures.panels(group)]
    if not groups:
        sys.exit("plot.py: no figures of ours in these files")
    stem, end = os.path.splitext(options.output)
    try:
        for group in groups:
            file = options.output if len(groups) == 1 else f"{stem}-{file_name(group['device'])}{end}"
            draw(group, file)
            print(file)
    except NothingToDrawWith as error:
        sys.exit(f"plot.py: {error}")


if __name__ == "__main__":
    main()
