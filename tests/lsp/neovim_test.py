#!/usr/bin/env python3
"""Holds a session in Neovim, and compares what the editor showed with neovim_session.txt. Ends with 77, which ctest
counts as skipped, if there is no nvim.

    neovim_test.py GLIFTC [--bless]
"""
import difflib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent

WATER = """/// Waves on a grid.
module water;

/// The height of the water.
pub structure Field = Array<2, float>;

pub kernel spread(f: in near<Field, 1>, g: out each<Field>) {
    let middle = f[0];
    var sum = 2.0 * middle;
    for axis in 0..2 {
        sum += f[+unit(axis)] + f[-unit(axis)];
    }
    g = mix(sum, middle, 0.5);
}

test "still water is still" {
    temp f = Field(uint2(8, 8));
    temp g = Field(uint2(8, 8));
    spread(f, g);
    expect_near(await g[uint2(3, 3)], 0.0, 1e-6);
}
"""


def main():
    if not shutil.which("nvim"):
        print("there is no nvim")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "water.glift").write_text(WATER)
        transcript = pathlib.Path(folder) / "transcript.txt"
        environment = {**os.environ, "GLIFT_SOURCE_DIR": str(here.parents[1]), "GLIFTC": str(pathlib.Path(sys.argv[1]).resolve()),
                       "TRANSCRIPT": str(transcript), "HOME": folder, "XDG_STATE_HOME": folder, "XDG_DATA_HOME": folder}
        ran = subprocess.run(["nvim", "--headless", "--clean", "-i", "NONE", "-n",
                              "--cmd", f"set runtimepath+={here.parents[1]}/tools/editors/vim",
                              "-S", str(here / "neovim_session.lua")], cwd=folder, env=environment, text=True, capture_output=True, timeout=300)
        if not transcript.exists():
            print(f"nvim ended with {ran.returncode}:\n{ran.stdout}{ran.stderr}")
            return 1
        shown = transcript.read_text()
    expected = here / "neovim_session.txt"
    if "--bless" in sys.argv[2:]:
        expected.write_text(shown)
    difference = list(difflib.unified_diff(expected.read_text().splitlines(), shown.splitlines(), "expected", "shown",
                                           lineterm=""))
    print("\n".join(difference))
    return 1 if difference else 0


sys.exit(main())
