"""Figures of algorithms: groups of rows of one device, as bench_algorithms, bench_rivals, bench_depth_of_field and the CUDA
rivals write them.

A group is {"device": name, "rows": [...]}; a row has by, algorithm, variant, elements, seconds, bytes_moved, runs, and, where it
was measured, error: the largest relative one. docs/internals/measurements.md says what the algorithms and their variants are.
"""
import json
import statistics

OURS = "Glift"


def load(file, part="algorithms"):
    """The groups in a file. `run.py --json` writes a dictionary, of which `part` is taken; the benches write a list of groups."""
    with open(file, encoding="utf-8") as text:
        found = json.load(text)
    return found[part] if isinstance(found, dict) else found


def key_of(row):
    return row["by"], row["algorithm"], row["variant"], row["elements"]


def joined(groups):
    """Joins the groups of each device into one; of rows that were measured several times, the median of the times, the sum of the
    runs and the largest of the errors."""
    devices = {}
    for group in groups:
        rows = devices.setdefault(group["device"], {})
        for row in group["rows"]:
            rows.setdefault(key_of(row), []).append(row)
    return [{"device": device, "rows": [median_row(same) for same in rows.values()]} for device, rows in devices.items()]


def median_row(same):
    row = dict(same[0], seconds=statistics.median(one["seconds"] for one in same), runs=sum(one["runs"] for one in same))
    errors = [one["error"] for one in same if "error" in one]
    if errors:
        row["error"] = max(errors)
    return row


def panel_of(row):
    """The title of the panel that a row is drawn in. Tridiagonal systems of all sizes share a panel, one for each number of
    right-hand sides; every other variant has its own."""
    if row["algorithm"] != "tridiagonal":
        return row["algorithm"] + ", " + row["variant"].replace("_", " ")
    return "tridiagonal, " + ("three right-hand sides" if row["variant"].endswith("_three") else "one right-hand side")


def panels(group):
    """{panel: {by: [rows, sorted by size]}}, for panels that have rows of Glift's. Rows of systems solved from memory are left
    out."""
    found = {}
    for row in group["rows"]:
        if row["variant"].endswith("_from_memory"):
            continue
        found.setdefault(panel_of(row), {}).setdefault(row["by"], []).append(row)
    for lines in found.values():
        for rows in lines.values():
            rows.sort(key=lambda row: row["elements"])
    return {panel: lines for panel, lines in found.items() if OURS in lines}


def throughput(row):
    """Billions of elements a second."""
    return row["elements"] / row["seconds"] * 1e-9
