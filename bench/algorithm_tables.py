"""Markdown tables of a device: the standard library's algorithms against their rivals (other implementations)."""
import figures


def number(x):
    """Formats with three significant digits; from 100 on, as a whole number."""
    return f"{x:.0f}" if x >= 100 else f"{x:.3g}"


def size_name(elements):
    return f"2^{elements.bit_length() - 1}" if elements & (elements - 1) == 0 else str(elements)


def cell(our, rival):
    if our is None:
        return "–"
    ours = number(figures.throughput(our))
    if rival is None:
        return ours
    ratio = figures.throughput(our) / figures.throughput(rival)
    return f"{ours} / {number(figures.throughput(rival))} = {ratio:.2f}"


def speeds(group):
    """A row for each algorithm and rival, a column for each size: Glift's speed / rival's = ratio, in G elements/s."""
    rows = [row for row in group["rows"] if row["algorithm"] not in ("tridiagonal", "move_equations")]
    panels = figures.panels({"rows": rows})
    sizes = sorted({row["elements"] for row in rows})
    if not panels:
        return ""
    lines = ["| algorithm | rival | " + " | ".join(size_name(size) for size in sizes) + " |",
             "| --- | --- |" + " ---: |" * len(sizes)]
    for panel, found in panels.items():
        ours = {row["elements"]: row for row in found[figures.OURS]}
        for by in [by for by in found if by != figures.OURS] or [None]:
            rivals = {row["elements"]: row for row in found.get(by, [])}
            cells = [cell(ours.get(size), rivals.get(size)) for size in sizes]
            lines.append(f"| {panel} | {by or ''} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def error_of(row):
    return f"{row['error']:.1e}" if row and "error" in row else ""


def systems(group):
    """Tridiagonal systems with one and three right-hand sides, against a rival's with one: G unknowns/s, largest errors, ratios of
    speeds, and the time that moving the data once takes, as a share of the time of the solution."""
    rows = {(row["by"], row["variant"]): row for row in group["rows"] if row["algorithm"] == "tridiagonal"}
    sides = sorted({int(variant.split("_")[1]) for _, variant in rows})
    if not sides:
        return ""
    moving = {row["variant"]: row for row in group["rows"] if row["algorithm"] == "move_equations"}
    rival = next((by for by, _ in rows if by != figures.OURS), None)
    lines = [f"| n | one right-hand side | error | three | error | {rival or 'rival'}, one | error | ratio, one | ratio, three | of moving the data once, from memory, one | three | from the cache, one | three |",
             "| ---: |" + " ---: |" * 12]
    for n in sides:
        one, three, other = (rows.get(key) for key in ((figures.OURS, f"n_{n}"), (figures.OURS, f"n_{n}_three"), (rival, f"n_{n}")))
        cells = []
        for row in (one, three, other):
            cells += [number(figures.throughput(row)) if row else "", error_of(row)]
        for row in (one, three):
            cells.append(f"{figures.throughput(row) / figures.throughput(other):.2f}" if row and other else "")
        memory = [rows.get((figures.OURS, f"n_{n}{which}_from_memory")) for which in ("", "_three")]
        for row in (*memory, one, three):
            once = moving.get(row["variant"]) if row else None
            cells.append(f"{once['seconds'] / row['seconds']:.2f}" if once else "")
        lines.append(f"| {n} | " + " | ".join(cells) + " |")
    return "\n".join(lines)
