#!/usr/bin/env python3
"""Runs the benches of a build and prints their tables as Markdown.

    bench/run.py BUILD_FOLDER [--only PART] [--json FILE] [--plots FOLDER] [--runs N] [options of algorithms.py]

The Vulkan device is the one that GLIFT_DEVICE names, or the best there is; some benches run on the host device, too. Not run are
bench_blocks and bench/edit_loop.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import algorithm_tables
import algorithms
import compile_speed
import depth_of_field
import pages
import plot
import shadows

DISPATCH_ROWS = {
    "record_passes": "runtime call, into the device's stream",
    "record_a_recording": "runtime call, into a recording",
    "generated_each_1d": "generated kernel (each, 1-D), into the device's stream",
    "generated_near_3d": "generated kernel (near, 3-D), into the device's stream",
    "generated_pipeline_record": "generated pipeline of 1,000 passes, into a recording",
    "generated_pipeline_replay": "the same, replayed",
}


def run_bench(command, file):
    """Runs a bench that prints its tables itself and writes JSON to `file`; returns the JSON, and whether it succeeded."""
    sys.stdout.flush()
    good = subprocess.run(command).returncode == 0
    with open(file, encoding="utf-8") as text:
        return json.load(text), good


def dispatch(program, folder):
    file = os.path.join(folder, "dispatch.json")
    subprocess.run([program, "--benchmark_repetitions=15", "--benchmark_min_time=0.02", "--benchmark_report_aggregates_only=true",
                    f"--benchmark_out={file}", "--benchmark_out_format=json"],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open(file, encoding="utf-8") as text:
        found = json.load(text)["benchmarks"]
    medians = {one["run_name"].split("/")[0]: one for one in found if one.get("aggregate_name") == "median"}
    return [{"name": name, "what": what, "seconds_per_pass": medians[name]["s/pass"],
             "submissions": medians[name].get("submissions")} for name, what in DISPATCH_ROWS.items()]


def dispatch_table(rows):
    lines = ["| what is recorded | host time a pass | submissions |", "| --- | ---: | ---: |"]
    for row in rows:
        submissions = "" if row["submissions"] is None else f"{row['submissions']:g}"
        lines.append(f"| {row['what']} | {row['seconds_per_pass'] * 1e6:.3f} us | {submissions} |")
    return "\n".join(lines)


def print_twins(bench, options, folder):
    print("## Generated shaders beside shaders written by hand\n")
    file = os.path.join(folder, "twins.json")
    return run_bench([os.path.join(bench, "glift_bench"), "--runs", str(options.runs), "--json", file], file)


def print_dispatch(bench, _, folder):
    print("\n## What a pass costs the host\n")
    passes = dispatch(os.path.join(bench, "bench_dispatch"), folder)
    print(dispatch_table(passes))
    return passes, True


def print_host(bench, options, folder):
    print("\n## Diffusion on the host device beside a loop written by hand\n")
    file = os.path.join(folder, "host.json")
    return run_bench([os.path.join(bench, "bench_host"), "--runs", str(options.runs), "--json", file], file)


def print_algorithms(bench, options, folder):
    print("\n## Algorithms: Glift / rival = ratio, G elements/s\n")
    groups = algorithms.measure(bench, options, folder)
    for group in groups:
        for part in (group["device"] + ":", algorithm_tables.speeds(group), algorithm_tables.systems(group)):
            if part:
                print(part + "\n")
    if options.plots:
        draw_or_say(lambda: draw(groups, options.plots), options.plots)
    return groups, True


def draw(groups, folder):
    for group in groups:
        plot.draw(group, os.path.join(folder, plot.file_name(group["device"]) + ".svg"))


def draw_or_say(drawing, folder):
    os.makedirs(folder, exist_ok=True)
    try:
        drawing()
    except plot.NothingToDrawWith as error:
        print(f"\nNothing is drawn: {error}. The figures of --json can be drawn elsewhere: bench/plot.py, bench/pages.py, bench/depth_of_field.py, bench/shadows.py.")


def print_depth_of_field(bench, options, folder):
    print("\n## Two layers of depth of field beside a copy of the bytes that have to be moved\n")
    groups = depth_of_field.measure(bench, options, folder)
    for group in groups:
        print(f"{group['device']}:\n\n{depth_of_field.table(group)}\n")
    if options.plots:
        draw_or_say(lambda: depth_of_field.draw(groups, os.path.join(options.plots, "depth_of_field.png")), options.plots)
    return groups, True


def print_moving_band(bench, options, folder):
    print("\n## A moving band: pages come and go, two stencils over what is there\n")
    file = os.path.join(folder, "moving_band.json")
    return run_bench([os.path.join(bench, "bench_moving_band"), "--json", file], file)


def print_neighbours(bench, options, folder):
    print("\n## A million points: a grid of lists, and what lies within a radius of each\n")
    file = os.path.join(folder, "neighbours.json")
    return run_bench([os.path.join(bench, "bench_neighbours"), "--json", file], file)


def print_lookups(bench, options, folder):
    print("\n## Reads through address translators beside reads by hand: thesis table 6.1\n")
    file = os.path.join(folder, "lookups.json")
    return run_bench([os.path.join(bench, "bench_lookups"), "--runs", str(options.runs), "--json", file], file)


def print_pages(bench, options, folder):
    print("\n## Reads of arrays in pages, by the size of a page: thesis figure 6.1")
    file = os.path.join(folder, "pages.json")
    devices, good = run_bench([os.path.join(bench, "bench_pages"), "--json", file], file)
    if options.plots:
        draw_or_say(lambda: pages.draw(devices, os.path.join(options.plots, "pages.png")), options.plots)
    return devices, good


def print_shadows(bench, options, folder):
    print("\n## Shadow maps: thesis section 11.4.3\n")
    file = os.path.join(folder, "shadows.json")
    command = [os.path.join(bench, "bench_shadows"), "--json", file]
    if not algorithms.is_gpu(os.path.join(bench, "bench_algorithms"), folder):
        command += ["--frames", "2", "--static-frames", "3", "--runs", "1", "--size", "128", "--scenes", "robot,trees", "--cases", "standard,asm,rmsm,rmsm static"]
    data, good = run_bench(command, file)
    print("\n" + shadows.tables(data))
    if options.plots:
        draw_or_say(lambda: shadows.draw(data, options.plots), options.plots)
    return data, good


def print_paint(bench, options, folder):
    print("\n## A painted model drawn beside the same model without paint, and with a dense image of it\n")
    file = os.path.join(folder, "paint.json")
    return run_bench([os.path.join(bench, "bench_paint"), "--runs", str(options.runs), "--json", file], file)


def print_compiler(bench, *_):
    print("\n## Compiling, all outputs but SPIR-V\n")
    compiling = compile_speed.measure(os.path.join(bench, "..", "bin", "gliftc"))
    print(compile_speed.table(compiling))
    return compiling, True


PARTS = {"twins": print_twins, "dispatch": print_dispatch, "host": print_host, "algorithms": print_algorithms,
         "depth_of_field": print_depth_of_field, "moving_band": print_moving_band,
         "neighbours": print_neighbours, "lookups": print_lookups, "pages": print_pages, "shadows": print_shadows,
         "paint": print_paint,
         "compiler": print_compiler}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build")
    parser.add_argument("--only", choices=PARTS)
    parser.add_argument("--json", help="where all figures go")
    parser.add_argument("--plots", help="folder for plots: of the algorithms of each device, depth of field, pages, shadows")
    parser.add_argument("--runs", type=int, default=20, help="of shaders and loops beside those by hand (%(default)s)")
    algorithms.add_options(parser)
    options = parser.parse_args()
    figures, all_good = {}, True
    with tempfile.TemporaryDirectory() as folder:
        for name in [options.only] if options.only else PARTS:
            figures[name], good = PARTS[name](os.path.join(options.build, "bench"), options, folder)
            all_good = all_good and good
    if options.json:
        with open(options.json, "w", encoding="utf-8") as out:
            json.dump(figures, out, indent=2)
            out.write("\n")
    return 0 if all_good else 1


if __name__ == "__main__":
    sys.exit(main())
