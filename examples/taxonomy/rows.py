#!/usr/bin/env python3
"""Writes the table of docs/explanation/taxonomy.md: what the compiler infers of each structure of this folder, beside the thesis.

    rows.py GLIFTC            writes it
    rows.py GLIFTC --check    fails if it is not what would be written
"""
import json
import pathlib
import re
import subprocess
import sys

folder = pathlib.Path(__file__).resolve().parent
target = folder.parent.parent / "docs" / "explanation" / "taxonomy.md"
BEGIN, END = "<!-- rows -->\n", "<!-- end of rows -->\n"

# The rows of table 8.1 (its text in the thesis is scrambled; these are from the journal version, ACM Transactions on Graphics 25(1), 2006):
# domains; memory; access; mapping. What follows the mapping is from sections 8.1 and 8.2.
TREE = "O(log n); O(log n), not uniform; {}"
LISTS = "O(n); O(list), not uniform; {}"
THESIS = {
    "brook_streams": "1-D to 2-D; O(1); O(1), uniform; complete, one to one; invertible",
    "flat_3d_texture": "3-D to 2-D; O(1); O(1), uniform; complete, one to one; invertible",
    "cube_map": "not in the table",
    "polycube_map": "3-D to 2-D; O(n); O(1), uniform; sparse",
    "silhouette_map": "2-D to 2-D; O(n); O(1), uniform; complete, not linear",
    "sparse_page_table": "3-D to 2-D; O(n); O(1), uniform; sparse, one to one; invertible with an inverse table",
    "adaptive_texture_map": "2–4-D to 2–3-D; O(n); O(1), uniform; sparse",
    "time_varying_volume": "4-D to 2-D; O(n); O(1), uniform; complete",
    "vector_quantisation": "3-D to 3-D; O(n); O(1), uniform; complete, many to one",
    "two_codebooks": "3-D to 3-D; O(n); O(1), uniform; complete, many to one",
    "texture_atlas_quadtree": "3-D to 2-D; " + TREE.format("sparse"),
    "radiosity_quadtree": "3-D to 2-D; " + TREE.format("complete"),
    "n_tree": "3-D to 3-D; " + TREE.format("sparse"),
    "grid_of_lists": "3-D to 2-D; " + LISTS.format("complete"),
    "photon_map": "3-D to 2-D; " + LISTS.format("complete"),
    "irregular_z_buffer": "2-D to 2-D; " + LISTS.format("sparse"),
    "k_d_tree": "3-D to 2-D; " + TREE.format("complete"),
    "bounding_volume_hierarchy": "3-D to 2-D; " + TREE.format("complete"),
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
    return (f"| [{file.stem}](../../examples/taxonomy/{file.name}) | {via['virtual']} to {via['physical'].rstrip('?')} | "
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
            sys.exit("docs/explanation/taxonomy.md is not what explain says: run examples/taxonomy/rows.py GLIFTC")
    else:
        target.write_text(made, encoding="utf-8")


main()
