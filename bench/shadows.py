#!/usr/bin/env python3
"""Tables and plots of frames with shadow maps (section 11.4.3 of Lefohn's thesis, 2006), from what bench_shadows writes.

    bench/shadows.py FILE.json [-o FOLDER]      FOLDER gets shadows_times.png and shadows_distribution.png; shadows_parts.png if passes
                                                were timed; shadows_pages.png if pages of other sizes than 32 were measured
"""
import argparse
import json
import os
import statistics
import sys

import plot

METHODS = {"standard": "standard map", "asm": "ASM", "rmsm": "RMSM"}
THESIS = {"asm / rmsm": "2 to 10", "rmsm / standard": "2 to 4", "asm / rmsm static": "1 to 3", "rmsm / standard static": "1 to 2"}
# How the passes of a frame are divided into parts; the first part is "project". BEGINS: a kernel with which the named part begins. ENDS: a
# kernel after which the named part begins. All other kernels count for the part that began last, so that library kernels, which several
# parts call, count for the right one. WITHIN: in "fill", these kernels of std.draw_pages count for two parts of their own.
ENDS = {"project": "look", "find_surface": "standard map", "draw_light": "ask", "ask_all": "allocate", "ask_at_edges": "allocate",
        "ask_coarse": "allocate", "find_lit": "ask"}
BEGINS = {"mark": "fill", "find_lit": "find_lit", "shade": "shade"}
WITHIN = {("fill", name): part for part, names in {"fill: walk": ("begin", "go_down"), "fill: draw": ("draw_pairs", "draw_rows")}.items() for name in names}
PARTS = ["project", "look", "standard map", "ask", "allocate", "fill: walk", "fill: draw", "fill", "find_lit", "shade"]


def parts_of(passes):
    """{part: seconds} of a frame's passes, which are in their order."""
    found = dict.fromkeys(PARTS, 0.0)
    part = "project"
    for one in passes:
        part = BEGINS.get(one["name"], part)
        found[WITHIN.get((part, one["name"]), part)] += one["seconds"]
        part = ENDS.get(one["name"], part)
    return found


def by_scene(data):
    """{scene: {case: row}}, in the order of the file."""
    scenes = {}
    for row in data["rows"]:
        scenes.setdefault(row["scene"], {})[row["case"]] = row
    return scenes


def ms(seconds):
    return f"{1e3 * seconds:.3f}"


def markdown(head, rows):
    return "\n".join([f"| {' | '.join(head)} |", "| --- |" + " ---: |" * (len(head) - 1)] + [f"| {' | '.join(row)} |" for row in rows])


def short_frames(row):
    """How many frames of a row had coarser pages, or none, in place of those they asked for; of ASM also those that filled the pool."""
    return row.get("pool_too_small", 0)


def mark(row):
    return f" (POOL TOO SMALL in {short_frames(row)} of {len(row['seconds'])})" if short_frames(row) else ""


def sample(rows, runs):
    """A sentence that says of how many frames and runs the figures of these rows are."""
    numbers = sorted({len(row["seconds"]) for row in rows})
    return f"Of {' or '.join(map(str, numbers))} frames each, of which each is the median of {runs} run{'s' if runs > 1 else ''}."


def times(scenes, end, runs):
    """Median and 95th percentile by method, and the ratios that the thesis states; `end` is "" or " static"."""
    rows = []
    for scene, cases in scenes.items():
        if not all(name + end in cases for name in METHODS):
            continue
        own = {name: cases[name + end] for name in METHODS}
        rows.append([scene] + [f"{ms(row['median'])}, {ms(row['percentile_95'])}{mark(row)}" for row in own.values()]
                    + [f"{own['asm']['median'] / own['rmsm']['median']:.2f}", f"{own['rmsm']['median'] / own['standard']['median']:.2f}"])
    head = ["scene"] + [f"{name}: median, 95 %, ms" for name in METHODS.values()]
    table = markdown(head + [f"ASM / RMSM (thesis: {THESIS['asm / rmsm' + end]})", f"RMSM / standard (thesis: {THESIS['rmsm / standard' + end]})"], rows)
    counted = [cases[name + end] for cases in scenes.values() for name in METHODS if name + end in cases]
    return f"{table}\n\n{sample(counted, runs)}" if rows else table


def pages(scenes):
    """Medians and maxima over the frames. An ASM frame asks for pages and fills them in rounds: "asked" counts all rounds."""
    def spread(values):
        return f"{statistics.median(values):.0f}, {max(values)}" if values else ""
    rows = []
    for scene, cases in scenes.items():
        for name in ("rmsm", "rmsm static", "asm", "asm static"):
            row = cases.get(name)
            if row is None:
                continue
            touched = f"{100 * row['touched']:.1f} %" if "touched" in row else ""
            rows.append([scene, name, str(len(row["pages"])), spread(row.get("asked")), spread(row["pages"]), spread(row["granted"]), spread(row.get("rounds")),
                         spread(row.get("coarsened")), str(max(row["refused"])), str(short_frames(row)),
                         f"{statistics.median(row['pages']) * row['page_bytes'] / 1e6:.1f} of {row['capacity'] * row['page_bytes'] / 1e6:.1f}", touched])
    return markdown(["scene", "case", "frames", "asked: median, most", "pages there", "new a frame", "rounds", "coarser in place of", "refused, most",
                     "frames with too small a pool", "MB of depths, of the pool", "texels looked up"], rows)


def sized(cases):
    """The rows of RMSM with other sizes of pages and with the usual one, by size."""
    return sorted((cases[name] for name in ("rmsm", "rmsm pages of 16", "rmsm pages of 64") if name in cases), key=lambda row: row["cells"])


def page_sizes(scenes):
    rows = [[scene, f"{row['cells']} x {row['cells']}", f"{ms(row['median'])}{mark(row)}", f"{statistics.median(row['pages']):.0f}",
             f"{statistics.median(row['pages']) * row['page_bytes'] / 1e6:.1f}", f"{100 * row['touched']:.1f} %" if "touched" in row else ""]
            for scene, cases in scenes.items() for row in sized(cases)]
    return markdown(["scene", "cells of a page", "RMSM, ms", "pages", "MB of depths", "texels looked up"], rows)


def parts(scenes):
    rows = []
    for scene, cases in scenes.items():
        for name in ("standard", "asm", "rmsm", "rmsm static"):
            row = cases.get(name)
            if row is None or not row["passes"]:
                continue
            found = parts_of(row["passes"])
            rows.append([scene, name, str(len(row["passes"]))] + [ms(found[part]) for part in PARTS] + [ms(sum(found.values()))])
    return markdown(["scene", "case", "passes"] + [f"{part}, ms" for part in PARTS] + ["all"], rows)


def knobs(scenes):
    """What each knob does to a frame of RMSM."""
    names = list(dict.fromkeys(name for cases in scenes.values() for name in cases
                               if name.startswith("rmsm") and not name.endswith("static")))
    rows = [[scene] + [f"{ms(cases[name]['median'])}, {statistics.median(cases[name]['pages']):.0f}{mark(cases[name])}" if name in cases else ""
                       for name in names] for scene, cases in scenes.items()]
    return markdown(["scene"] + [f"{name}: ms, pages" for name in names], rows)


def lookup_speeds(cases):
    """{case of RMSM: how fast its lookups are}: the time of the kernel find_lit with a standard map, divided by its time with RMSM's
    quadtree of pages."""
    def seconds(name):
        row = cases.get(name)
        return parts_of(row["passes"])["find_lit"] if row and row["passes"] else 0
    names = [name for name in cases if name.startswith("rmsm") and seconds(name) > 0]
    beside = {"rmsm nearest": "standard nearest"}
    speeds = {name: seconds(beside.get(name, "standard")) / seconds(name) for name in names}
    return {name: speed for name, speed in speeds.items() if speed > 0}


def hardware(data):
    """{scene: the time of lookups of a standard map, 2 x 2 texels each, by the hardware's comparison, divided by their time by a gather}.
    Each was timed alone in a submission."""
    return {row["scene"]: row["compare_seconds"] / row["gather_seconds"] for row in data.get("lookups", [])}


def lookups(data, scenes):
    """The speed of RMSM's lookups as a share of a standard map's: first of one that the same kernel reads (nearest: one texel, else by
    gathers); then, except for nearest, of one whose 2 x 2 texels the hardware compares, which is the first share times hardware()."""
    names = [name for name in ("rmsm nearest", "rmsm", "rmsm trilinear") if any(name in cases for cases in scenes.values())]
    by_hardware, rows = hardware(data), []
    for scene, cases in scenes.items():
        speeds = lookup_speeds(cases)
        if not speeds:
            continue
        row = [scene]
        for name in names:
            row.append(f"{100 * speeds[name]:.0f} %" if name in speeds else "")
            if name != "rmsm nearest":
                row.append(f"{100 * speeds[name] * by_hardware[scene]:.0f} %" if name in speeds and scene in by_hardware else "")
        rows.append(row)
    against = ["of a map that is gathered", "of one that the hardware compares"]
    heads = {"rmsm nearest": ["the level's page, nearest texel, of a map's nearest"], "rmsm": [f"the level's page, 2 x 2 (thesis: 77 %), {one}" for one in against],
             "rmsm trilinear": [f"between levels (thesis: 74 %), {one}" for one in against]}
    return markdown(["scene"] + [head for name in names for head in heads[name]], rows)


def plain_lookups(data):
    return markdown(["scene", "nearest texel, ms", "2 x 2, gathered, ms", "2 x 2, compared by the hardware, ms", "pixels lit: gathered, compared"],
                    [[row["scene"]] + [f"{1e3 * row[key + '_seconds']:.4f}" for key in ("nearest", "gather", "compare")]
                     + [f"{row['lit_by_gather']:.3f}, {row['lit_by_compare']:.3f}"] for row in data["lookups"]])


def longest(scenes, number=8):
    """The kernels that take longest in a frame of RMSM; the passes of a kernel are added up."""
    rows = []
    for scene, cases in scenes.items():
        if "rmsm" not in cases or not cases["rmsm"]["passes"]:
            continue
        sums = {}
        for one in cases["rmsm"]["passes"]:
            seconds, times_run = sums.get(one["name"], (0.0, 0))
            sums[one["name"]] = seconds + one["seconds"], times_run + 1
        top = sorted(sums.items(), key=lambda item: -item[1][0])[:number]
        rows.append([scene, ", ".join(f"`{name}` {ms(seconds)}" + (f" ({times_run})" if times_run > 1 else "")
                                      for name, (seconds, times_run) in top)])
    return markdown(["scene", "kernels of RMSM: ms (passes)"], rows)


def tables(data):
    scenes = by_scene(data)
    several = [("Scenes that move", times(scenes, "", data["runs"])),
               ("Scenes that stand still, pages kept", times(scenes, " static", data["runs"])),
               ("Pages", pages(scenes)), ("Knobs of RMSM", knobs(scenes))]
    if any(row["cells"] != 32 for row in data["rows"]):
        several.append(("Sizes of pages", page_sizes(scenes)))
    if any(row["passes"] for row in data["rows"]):
        several += [("Parts of a frame, each pass by itself", parts(scenes)), ("Where RMSM's time goes", longest(scenes)),
                    ("Speed of lookups, of a standard map's", lookups(data, scenes))]
    if data.get("lookups"):
        several.append(("Lookups of a standard map alone", plain_lookups(data)))
    return "\n\n".join(f"**{title}**\n\n{table}" for title, table in several)


def new_figure(data, title, columns, label):
    figure, axes = plot.pyplot().subplots(1, columns, figsize=(5.4 * max(columns, 1.5), 4.2), squeeze=False, layout="constrained")
    figure.suptitle(f"{data['device']}, {data['side']} x {data['side']}: {title}", fontsize=10)
    for one in axes[0]:
        one.set_ylabel(label)
        one.grid(True, axis="y", linewidth=0.4, alpha=0.6)
        one.set_axisbelow(True)
    return figure, axes[0]


def bars(axes, scenes, names, value):
    """A group of bars for each scene that has all of the cases."""
    known = [scene for scene, cases in scenes.items() if all(name in cases for name in names)]
    width = 0.8 / len(names)
    for k, name in enumerate(names):
        axes.bar([i + (k - (len(names) - 1) / 2) * width for i in range(len(known))], [value(scenes[scene][name]) for scene in known],
                 width, label=name, color=plot.COLOURS[k % len(plot.COLOURS)])
    axes.set_xticks(range(len(known)), known)
    axes.legend(fontsize=8)


def draw_times(data, scenes):
    figure, axes = new_figure(data, "a frame, median", 2, "milliseconds")
    for one, end, title in zip(axes, ("", " static"), ("scenes that move", "scenes that stand still")):
        bars(one, scenes, [name + end for name in METHODS], lambda row: 1e3 * row["median"])
        one.set_title(title, fontsize=10)
    return figure


def draw_distribution(data, scenes):
    figure, axes = new_figure(data, "all frames of a path", 2, "milliseconds")
    for one, end, title in zip(axes, ("", " static"), ("scenes that move", "scenes that stand still")):
        for k, name in enumerate(METHODS):
            rows = [cases[name + end] for cases in scenes.values() if name + end in cases]
            for i, row in enumerate(rows):
                seconds = sorted(row["seconds"])
                x = [i + (k - 1) * 0.25 + 0.2 * (j / max(len(seconds) - 1, 1) - 0.5) for j in range(len(seconds))]
                one.plot(x, [1e3 * value for value in seconds], color=plot.COLOURS[k], marker=".", markersize=3, linewidth=0.8,
                         label=METHODS[name] if i == 0 else None)
        one.set_xticks(range(len(scenes)), list(scenes))
        one.set_yscale("log")
        one.set_title(f"{title}; each line: its frames, sorted", fontsize=10)
        if one.has_data():
            one.legend(fontsize=8)
    return figure


def draw_parts(data, scenes):
    figure, axes = new_figure(data, "parts of a frame, each pass by itself", 1, "milliseconds")
    names = [(scene, name) for scene, cases in scenes.items() for name in ("standard", "rmsm", "rmsm static")
             if name in cases and cases[name]["passes"]]
    below = [0.0] * len(names)
    for k, part in enumerate(PARTS):
        values = [1e3 * parts_of(scenes[scene][name]["passes"])[part] for scene, name in names]
        axes[0].bar(range(len(names)), values, bottom=below, label=part, color=plot.pyplot().get_cmap("tab10")(k))
        below = [a + b for a, b in zip(below, values)]
    axes[0].set_xticks(range(len(names)), [f"{scene}, {name}" for scene, name in names], rotation=60, ha="right", fontsize=8)
    handles, labels = axes[0].get_legend_handles_labels()
    axes[0].legend(handles[::-1], labels[::-1], fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5))   # beside the bars, in their order
    return figure


def draw_pages(data, scenes):
    figure, axes = new_figure(data, "RMSM by cells along a page", 2, "milliseconds")
    axes[1].set_ylabel("MB of depths")
    for k, (scene, cases) in enumerate(scenes.items()):
        rows = sized(cases)
        style = {"label": scene, "color": plot.COLOURS[k % len(plot.COLOURS)], "marker": plot.MARKERS[k % len(plot.MARKERS)]}
        sizes = [row["cells"] for row in rows]
        axes[0].plot(sizes, [1e3 * row["median"] for row in rows], **style)
        axes[1].plot(sizes, [statistics.median(row["pages"]) * row["page_bytes"] / 1e6 for row in rows], **style)
    for one in axes:
        one.set_xticks([16, 32, 64])
        one.set_ylim(bottom=0)
        one.legend(fontsize=8)
    return figure


def draw(data, folder):
    scenes = by_scene(data)
    os.makedirs(folder, exist_ok=True)
    figures = {"times": draw_times, "distribution": draw_distribution}
    if any(row["passes"] for row in data["rows"]):
        figures["parts"] = draw_parts
    if any(row["cells"] != 32 for row in data["rows"]):
        figures["pages"] = draw_pages
    for name, make in figures.items():
        figure = make(data, scenes)
        figure.savefig(os.path.join(folder, f"shadows_{name}.png"), dpi=110)
        plot.pyplot().close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file")
    parser.add_argument("-o", dest="output")
    options = parser.parse_args()
    with open(options.file, encoding="utf-8") as text:
        data = json.load(text)
    data = data.get("shadows", data)   # of run.py, or of bench_shadows
    print(f"{data['device']}, {data['side']} x {data['side']}:\n\n{tables(data)}")
    if options.output:
        try:
            draw(data, options.output)
        except plot.NothingToDrawWith as error:
            sys.exit(f"shadows.py: {error}")


if __name__ == "__main__":
    main()
