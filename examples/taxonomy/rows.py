#!/usr/bin/env python3
"""Writes the table of docs/taxonomy.md: what the compiler infers of each structure of this folder, beside the thesis.

    rows.py GLIFTC            writes it
    rows.py GLIFTC --check    fails if it is not what would be written
"""
import json
import pathlib
import re
import subprocess
import sys

folder = pathlib.Path(__file__).resolve().parent
target = folder.parent.parent / "docs" / "taxonomy.md"
BEGIN, END = "<!-- rows -->\n", "<!-- end of rows -->\n"

# The properties that the thesis gives for each structure: sections 8.1 to 8.5, for trees and lists 3.2.3.
ANALYTIC = "O(1); O(1), uniform; complete, one to one; invertible"
PAGES = "O(n); O(1), uniform; {}; {}"
TREE = "O(n); O(log n), not uniform; {}"
LISTS = "O(n); O(list), not uniform; sparse"
THESIS = {
    "brook_streams": ANALYTIC,
    "flat_3d_texture": ANALYTIC,
    "cube_map": ANALYTIC,
    "polycube_map": "O(n); O(1), uniform; complete",
    "silhouette_map": "O(n); O(1), uniform; complete, not linear",
    "sparse_page_table": PAGES.format("sparse, one to one", "invertible with an inverse table"),
    "adaptive_texture_map": PAGES.format("complete, many to one", "not invertible"),
    "vector_quantisation": PAGES.format("complete, many to one", "not invertible"),
    "texture_atlas_quadtree": TREE.format("complete, many to one"),
    "radiosity_quadtree": TREE.format("complete, many to one"),
    "n_tree": TREE.format("sparse"),
    "grid_of_lists": LISTS,
    "photon_map": LISTS,
    "irregular_z_buffer": LISTS,
    "k_d_tree": TREE.format("complete"),
    "bounding_volume_hierarchy": TREE.format("complete"),
}


def inferred(gliftc, file):
    """What `gliftc explain` says of the first public structure of a file whose translator is not Linear (of brook_streams, whose
    public structure is generic, an instance), and of that translator."""
    text = file.read_text(encoding="utf-8")
    names = re.findall(r"^pub structure (\w+)", text, re.M)
    found = json.loads(subprocess.run([gliftc, "explain", "--json", str(file)], check=True, capture_output=True, text=True).stdout)
    for structure in found["structures"]:
        one = [t for t in structure.get("via", []) if not t["name"].startswith("Linear")]
        if one and (structure["name"] in names or file.stem == "brook_streams"):
            return structure, one[0]
    raise SystemExit(f"rows.py: {file.name}: explain shows no structure of {', '.join(names) or 'the file'}")


def row(gliftc, file):
    structure, via = inferred(gliftc, file)
    memory = re.sub(r": that of .*", "", via["memory_complexity"])
    mapping = re.sub(r" \(.*?\)", "", via["mapping"]).replace("one to one or many to one: not known", "not known whether one to one")
    properties = (f"{memory}; {via['access_complexity']}, {via['access_consistency']}; {via['totality']}, {mapping}; "
                  f"invertible: {via['invertible'].split(' ')[0].strip(':,')}")
    return (f"| [{file.stem}](../examples/taxonomy/{file.name}) | {via['virtual']} to {via['physical'].rstrip('?')} | "
            f"{properties} | {THESIS[file.stem]} |")


def table(gliftc):
    files = sorted(folder.glob("*.glift"), key=lambda file: list(THESIS).index(file.stem))
    return "\n".join(["| structure | addresses | gliftc explain | thesis |", "| --- | --- | --- | --- |"]
                     + [row(gliftc, file) for file in files]) + "\n"


def main():
    text = target.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    after = rest.split(END)[1]
    made = before + BEGIN + table(sys.argv[1]) + END + after
    if "--check" in sys.argv:
        if made != text:
            sys.exit("docs/taxonomy.md is not what explain says: run examples/taxonomy/rows.py GLIFTC")
    else:
        target.write_text(made, encoding="utf-8")


main()
