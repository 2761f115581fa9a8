#!/usr/bin/env python3
"""Measures how fast gliftc is, from the start of the process to its exit.

    bench/compile_speed.py GLIFTC [--runs N] [--json FILE]

Times bench/small.glift, compiled for all targets but SPIR-V, and generated files, each also at twice its length: functions
that nothing calls, which are only parsed and checked, whatever the targets; public kernels that are only parsed and
checked, too (--stop-after=sema); and public kernels that are compiled for all targets but SPIR-V.
"""
import argparse
import json
import os
import statistics
import subprocess
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
OUTPUTS = ["--host-only", "--target=glsl", "--target=cpp", "--target=host", "--target=json"]

FUNCTION = """
pub fn f{k}(a: float, b: uint) -> float {{
    var x = a;
    for i in 0..b {{
        x += sqrt(a) * {k}.0;
    }}
    return x;
}}
"""

KERNEL = """
/// Kernel {k}.
pub kernel k{k}(f: in near<Volume, 1>, g: out each<Volume>, dt: float) {{
    var sum = -6.0 * f[0];
    for axis in 0..3 {{
        sum += f[+unit(axis)] + f[-unit(axis)];
    }}
    if sum > {k}.0 {{
        sum = sum * 2.0;
    }} else {{
        sum = sum + dt;
    }}
    let a = sum * dt;
    let b = a + {k}.0;
    var d = sqrt(abs(b));
    for j in 0..10 {{
        d += sin(a * float(j)) + b;
        d = d * 0.5;
    }}
    g = f[0] + dt * d;
}}
"""

HEADERS = {
    "functions": "module large;\n",
    "kernels": "module large;\n\nuse std.address;\nuse std.array;\n\npub structure Volume = Array<3, float>;\n",
}
BODIES = {"functions": FUNCTION, "kernels": KERNEL}
# Name: (what is generated, its number of lines, options of gliftc). Fewer lines of kernels where they are compiled:
# each kernel makes hundreds of lines of output.
CASES = {
    "functions, all outputs": ("functions", 100000, OUTPUTS),
    "kernels, read and checked": ("kernels", 100000, ["--stop-after=sema"]),
    "kernels, all outputs": ("kernels", 10000, OUTPUTS),
}


def generated(kind, lines):
    text = [HEADERS[kind]]
    count = text[0].count("\n")
    per_body = BODIES[kind].count("\n")
    k = 0
    while count + per_body <= lines:
        text.append(BODIES[kind].format(k=k))
        count += per_body
        k += 1
    text.append("//\n" * (lines - count))
    return "".join(text)


def seconds(gliftc, options, file, folder):
    start = time.perf_counter()
    subprocess.run([gliftc, *options, "-o", folder, file], check=True)
    return time.perf_counter() - start


def median_seconds(gliftc, options, file, runs):
    with tempfile.TemporaryDirectory() as folder:
        seconds(gliftc, options, file, folder)
        return statistics.median(seconds(gliftc, options, file, folder) for _ in range(runs))


def small(gliftc, runs):
    file = os.path.join(HERE, "small.glift")
    with open(file, encoding="utf-8") as source:
        lines = sum(1 for _ in source)
    return {"lines": lines, "seconds": median_seconds(gliftc, OUTPUTS, file, runs), "runs": runs}


def large(gliftc, case, runs):
    """Times the file and one of twice its length alternately, so that other load affects both."""
    kind, lines, options = CASES[case]
    with tempfile.TemporaryDirectory() as folder:
        files = []
        for count in (lines, 2 * lines):
            files.append(os.path.join(folder, str(count), "large.glift"))
            os.mkdir(os.path.dirname(files[-1]))
            with open(files[-1], "w", encoding="utf-8") as out:
                out.write(generated(kind, count))
        outputs = os.path.join(folder, "out")
        for file in files:
            seconds(gliftc, options, file, outputs)
        times = [[seconds(gliftc, options, file, outputs) for file in files] for _ in range(runs)]
    one, twice = (statistics.median(column) for column in zip(*times))
    return {"kind": case, "runs": runs, "lines": lines, "seconds": one, "seconds_of_twice": twice,
            "lines_per_second": lines / one, "growth": statistics.median(b / a for a, b in times)}


def measure(gliftc, runs=40, large_runs=15):
    return {"small": small(gliftc, runs), "large": [large(gliftc, case, large_runs) for case in CASES]}


def table(result):
    lines = ["| file | lines | time | lines/s | time for twice the lines |", "| --- | ---: | ---: | ---: | ---: |"]
    one = result["small"]
    lines.append(f"| bench/small.glift | {one['lines']} | {one['seconds'] * 1e3:.1f} ms | | |")
    for one in result["large"]:
        lines.append(f"| generated {one['kind']} | {one['lines']} | {one['seconds'] * 1e3:.0f} ms | "
                     f"{one['lines_per_second']:.0f} | x {one['growth']:.2f} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("gliftc")
    parser.add_argument("--runs", type=int, default=40)
    parser.add_argument("--json")
    options = parser.parse_args()
    result = measure(options.gliftc, options.runs)
    print(table(result))
    if options.json:
        with open(options.json, "w", encoding="utf-8") as out:
            json.dump(result, out, indent=2)
            out.write("\n")


if __name__ == "__main__":
    main()
