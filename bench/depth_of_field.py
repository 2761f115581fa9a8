#!/usr/bin/env python3
"""Depth of field in two layers on the Vulkan device and on the host: its time, the time of a copy of the bytes that it has
to move (the copy bound) as a share of it, and cuSPARSE's time.

    bench/depth_of_field.py FILE.json... -o FILE.png      prints tables and draws time against pixels; files as bench_depth_of_field,
                                                          the CUDA rivals and run.py write them
"""
import argparse
import os
import sys

import algorithms
import figures
import plot

CPU_SIZES, GPU_SIZES = "256x256,512x512,1024x1024,1920x1080", "256x256,512x512,1024x1024,1920x1080,2048x2048,4096x4096"


def measure(bench, options, folder):
    """The groups of figures (figures.py) of the Vulkan device, on a GPU with nvcc also those of cuSPARSE, and of the host, joined over
    the rounds."""
    ours = os.path.join(bench, "bench_depth_of_field")
    gpu = algorithms.is_gpu(os.path.join(bench, "bench_algorithms"), folder)
    cuda = algorithms.build_cuda(os.path.join(folder, "cuda")) if gpu else None
    runs = ["--runs", str(options.algorithm_runs)]
    groups = []
    for _ in range(options.rounds):
        groups += algorithms.run([ours, "--sizes", GPU_SIZES if gpu else CPU_SIZES] + runs, folder)
        groups += algorithms.run([ours, "--device", "host", "--sizes", CPU_SIZES] + runs, folder)
        if cuda:
            groups += algorithms.run([cuda, "--only", "diffusion"] + runs, folder)
    return figures.joined(groups)


def by_size(group, algorithm, by=None):
    return {row["variant"]: row for row in group["rows"] if row["algorithm"] == algorithm and by in (None, row["by"])}


def solves(group):
    """{size: seconds} of cuSPARSE: the time of rows plus that of columns, each by the quicker of the two solvers."""
    ways = {direction: [by_size(group, f"{direction}_{way}") for way in ("strided", "interleaved")] for direction in ("rows", "columns")}
    return {size: sum(min(way[size]["seconds"] for way in both) for both in ways.values()) for size in ways["rows"][0]}


def table(group):
    ours, copies = by_size(group, "two_layers", figures.OURS), by_size(group, "two_layers", "copy")
    alone, rival = by_size(group, "one_image"), solves(group)
    lines = ["| picture | two layers | ns per pixel | copy bound | share of it | cuSPARSE, only the solves | pictures per second, one by one |",
             "| --- |" + " ---: |" * 6]
    for size, row in ours.items():
        bound = copies[size]["seconds"]
        beside = f"{rival[size] * 1e3:.3f} ms" if size in rival else ""
        lines.append(f"| {size.replace('x', ' x ')} | {row['seconds'] * 1e3:.3f} ms | {row['seconds'] / row['elements'] * 1e9:.3g} "
                     f"| {bound * 1e3:.3f} ms | {bound / row['seconds']:.2g} | {beside} | {1 / alone[size]['seconds']:.0f} |")
    return "\n".join(lines)


def lines_of(group):
    """{name of the line: [(pixels, milliseconds)]}, sorted by pixels."""
    found = {}
    for name, rows in (("two layers, all passes", by_size(group, "two_layers", figures.OURS)),
                       ("copy of the bytes to be moved", by_size(group, "two_layers", "copy"))):
        found[name] = sorted((row["elements"], row["seconds"] * 1e3) for row in rows.values())
    rival = solves(group)
    if rival:
        pixels = {row["variant"]: row["elements"] for row in group["rows"]}
        found["cuSPARSE, only the solves"] = sorted((pixels[size], seconds * 1e3) for size, seconds in rival.items())
    return found


def draw_panel(axes, group):
    for k, (name, points) in enumerate(lines_of(group).items()):
        axes.plot(*zip(*points), label=name, color=plot.COLOURS[k], marker=plot.MARKERS[k], markersize=4)
    pixels, first = lines_of(group)["two layers, all passes"][-1]
    least = min(row["elements"] for row in group["rows"])
    axes.plot([least, pixels], [first * least / pixels, first], label="linear in pixels", color="grey", linewidth=0.8, linestyle="--")
    axes.set_xscale("log", base=2)
    axes.set_yscale("log")
    axes.set_title(group["device"], fontsize=10)
    axes.set_xlabel("pixels")
    axes.set_ylabel("milliseconds")
    axes.grid(True, which="major", linewidth=0.4, alpha=0.6)
    axes.legend(fontsize=8)


def draw(groups, file):
    """Draws a panel for each device; the extension of the file gives the format."""
    plt = plot.pyplot()
    groups = [group for group in groups if by_size(group, "two_layers", figures.OURS)]
    figure, axes = plt.subplots(1, len(groups), figsize=(5.2 * len(groups), 4), squeeze=False, layout="constrained")
    for one, group in zip(axes[0], groups):
        draw_panel(one, group)
    figure.savefig(file, dpi=110)
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+")
    parser.add_argument("-o", dest="output", required=True)
    options = parser.parse_args()
    groups = figures.joined([group for file in options.files for group in figures.load(file, "depth_of_field")])
    for group in groups:
        print(f"{group['device']}:\n\n{table(group)}\n")
    try:
        draw(groups, options.output)
    except plot.NothingToDrawWith as error:
        sys.exit(f"depth_of_field.py: {error}")


if __name__ == "__main__":
    main()
