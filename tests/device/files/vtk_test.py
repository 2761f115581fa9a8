#!/usr/bin/env python3
"""Reads files of `gliftinfo convert … .vti` with VTK, and compares all values: vtk_test.py GLIFTINFO. Exit status 77: skipped, since Python
does not have vtk and numpy."""
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLImageDataReader
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

gliftinfo = sys.argv[1]
random = numpy.random.default_rng(5)


def convert(*arguments):
    subprocess.run([gliftinfo, "convert", *map(str, arguments)], check=True)


def check(folder, array, element_axes):
    numpy.save(folder / "in.npy", array)
    convert("--element-axes", element_axes, folder / "in.npy", "volume", folder / "volume.h5")
    convert(folder / "volume.h5", "volume", folder / "volume.vti")
    reader = vtkXMLImageDataReader()
    reader.SetFileName(str(folder / "volume.vti"))
    assert reader.CanReadFile(str(folder / "volume.vti"))
    reader.Update()
    assert reader.GetErrorCode() == 0
    image = reader.GetOutput()
    axes = array.shape[: array.ndim - element_axes]
    assert image.GetDimensions() == (axes[::-1] + (1, 1))[:3], (array.shape, image.GetDimensions())
    assert image.GetPointData().GetNumberOfArrays() == 1
    values = vtk_to_numpy(image.GetPointData().GetArray("data"))
    expected = array.astype(numpy.float32) if array.dtype == numpy.float16 else array.view(numpy.uint8) if array.dtype == bool else array
    assert values.dtype == expected.dtype, (values.dtype, expected.dtype)
    assert numpy.array_equal(values.reshape(expected.shape), expected), (array.dtype, array.shape)


count = 0
with tempfile.TemporaryDirectory() as name:
    for kind in "bool int8 int16 int32 int64 uint8 uint16 uint32 uint64 float16 float32 float64".split():
        for shape, element_axes in ((7,), 0), ((3, 4), 0), ((2, 3, 4), 0), ((2, 3, 4, 3), 1), ((5, 2), 1), ((4, 3, 2, 2, 3), 2), ((120, 110, 100), 0):
            array = (1000 * random.standard_normal(shape)).astype(kind)
            check(pathlib.Path(name), array, element_axes)
            count += 1
print(f"VTK reads {count} arrays, all values equal")
