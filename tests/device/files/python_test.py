#!/usr/bin/env python3
"""Reads files of glift::save with h5py and with gliftinfo: python_test.py SAMPLE GLIFTINFO."""
import os
import pathlib
import pty
import subprocess
import sys
import tempfile
import time

try:
    import h5py
    import numpy
except ImportError as missing:
    if sys.executable == "/usr/bin/python3" or not pathlib.Path("/usr/bin/python3").exists():
        print(f"skipped: {missing}")
        sys.exit(0)
    sys.exit(subprocess.call(["/usr/bin/python3", *sys.argv]))

sample, gliftinfo = sys.argv[1:]
folder = pathlib.Path(tempfile.mkdtemp())


def info(*arguments, status=0):
    run = subprocess.run([gliftinfo, *map(str, arguments)], capture_output=True, text=True)
    assert run.returncode == status, (arguments, run.returncode, run.stdout, run.stderr)
    return run.stdout + run.stderr


def expect(wanted, text):
    assert wanted in text, f"'{wanted}' is not in:\n{text}"


file, other = folder / "sample.h5", folder / "other.h5"
for path, more in (file, 0), (other, 5):
    subprocess.run([sample, path, str(more)], check=True)

# h5py.
with h5py.File(file) as saved:
    assert list(saved) == ["grid", "volume"]
    density = saved["volume/data/density"][:]
    assert density.shape == (2, 3, 4) and density.dtype == numpy.float32
    assert density[1, 2, 3] == 123
    assert saved["volume/data/velocity"].shape == (2, 3, 4, 3)
    assert saved["volume/data/on"].dtype == bool and saved["volume/data/on"][0, 0, 1]
    assert saved["volume/data/heat"].dtype == numpy.float16 and saved["volume/data/heat"][0, 0, 3] == 1.5
    assert list(saved["grid"].attrs["extent"]) == [20, 20]
    assert saved["grid"].attrs["background"] == 1.5
    assert not saved["grid/field/frames/data"][:].any()

# gliftinfo.
text = info(file)
expect("volume  Array<3, Cell>", text)
expect("volume/data/velocity", text)
expect("background = 1.5", text)
expect("grid/table", text)
expect("whole", info("check", file, other))
damaged = folder / "damaged.h5"
contents = bytearray(file.read_bytes())
contents[3000] ^= 1
damaged.write_bytes(contents)
expect("damaged", info("check", file, damaged, status=1))
expect("cannot be read", info(damaged, status=2))
assert info("diff", file, file) == ""
expect("volume/data/density: 24 of 24 numbers differ", info("diff", file, other, status=1))
expect("volume/data/density", info("convert", file, "volume/nothing", folder / "x.npy", status=2))
expect(".npy, .vti or .nvdb", info("convert", file, "volume/data/density", folder / "x.xyz", status=2))
for field in "density", "velocity", "on", "heat":
    info("convert", file, f"volume/data/{field}", folder / "x.npy")
    with h5py.File(file) as saved:
        expected = saved[f"volume/data/{field}"][:]
    found = numpy.load(folder / "x.npy")
    assert found.dtype == expected.dtype and numpy.array_equal(found, expected), field

# NumPy arrays as structures, and back: equal, whatever the type, the order and the version of the format.
random = numpy.random.default_rng(3)
for name in "bool int8 int16 int32 int64 uint8 uint16 uint32 uint64 float16 float32 float64".split():
    for shape, axes in ((5,), 0), ((3, 4), 0), ((2, 3, 4), 1), ((2, 3, 4, 5), 0), ((2, 1, 3, 4, 2), 2), ((0, 3), 0):
        array = random.integers(0, 2 if name == "bool" else 100, shape).astype(name)
        for version in (1, 0), (2, 0), (3, 0):
            with open(folder / "in.npy", "wb") as out:
                numpy.lib.format.write_array(out, array, version=version)
            info("convert", "--element-axes", axes, folder / "in.npy", "array", folder / "in.h5")
            info("convert", folder / "in.h5", "array", folder / "out.npy")
            found = numpy.load(folder / "out.npy")
            assert found.dtype == array.dtype and numpy.array_equal(found, array), (name, shape, version)
numpy.save(folder / "in.npy", numpy.zeros((2, 3), order="F"))
expect("ascontiguousarray", info("convert", folder / "in.npy", "array", folder / "in.h5", status=2))
numpy.save(folder / "in.npy", numpy.zeros(3, dtype=">f4"))
expect("newbyteorder('<')", info("convert", folder / "in.npy", "array", folder / "in.h5", status=2))
expect("ends with .h5", info("convert", folder / "in.npy", "array", folder / "out.npy", status=2))

# The line that says how far gliftinfo is: on a terminal alone, and for slow work alone. A pipe that is read late is slow.
numpy.save(folder / "in.npy", numpy.arange(3000000, dtype=numpy.float32))
info("convert", folder / "in.npy", "array", folder / "in.h5")


def on_terminal(*arguments, pipe=None):
    terminal, end = pty.openpty()
    run = subprocess.Popen([gliftinfo, *map(str, arguments)], stderr=end)
    os.close(end)
    if pipe:
        with open(pipe, "rb") as late:
            time.sleep(1.2)
            while late.read(1 << 20):
                pass
    assert run.wait() == 0
    try:
        return os.read(terminal, 1000).decode()
    except OSError:  # nothing was written
        return ""


os.mkfifo(folder / "slow.npy")
expect("\r\x1b[Kconvert:", on_terminal("convert", folder / "in.h5", "array", folder / "slow.npy", pipe=folder / "slow.npy"))
assert on_terminal("convert", folder / "in.h5", "array", folder / "out.npy") == ""
assert info("convert", folder / "in.h5", "array", folder / "out.npy") == ""

print("files are read by Python")
