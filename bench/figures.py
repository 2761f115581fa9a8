"""Figures of algorithms: groups of rows of one device, as bench_algorithms, bench_rivals and the CUDA rivals write them.

A group is {"device": name, "rows": [...]}; a row has by, algorithm, variant, elements, seconds, bytes_moved, runs, and where
results are not exact the largest relative error.
"""
import json
import statistics

OURS = "Glift"


def load(file, part="algorithms"):
    """The groups of a file: one that a bench wrote, or that of `run.py --json`, of which a part."""
    with open(file, encoding="utf-8") as text:
        found = json.load(text)
    return found[part] if isinstance(found, dict) else found


def key_of(row):
    return row["by"], row["algorithm"], row["variant"], row["elements"]


def joined(groups):
    """One group a device; of rows that were measured several times, the median."""
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
    """The panel and the line that a row is drawn in: systems of all sizes in one panel, sorts of keys and of pairs in two."""
    if row["algorithm"] != "tridiagonal":
        return row["algorithm"] + ", " + row["variant"].replace("_", " ")
    return "tridiagonal, " + ("three right-hand sides" if row["variant"].endswith("_three") else "one right-hand side")


def panels(group):
    """{panel: {by: [rows, by size]}}, where there are figures of ours. Systems solved from memory are only in a table."""
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
    """G elements/s."""
    return row["elements"] / row["seconds"] * 1e-9
