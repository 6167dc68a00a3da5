"""Reads a .vtu file with VTK and prints what is in it as one JSON object. Ends with 1 when VTK complains.

usage: read_vtu.py FILE
"""
import json
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkStringArray
from vtkmodules.vtkCommonDataModel import VTK_VOXEL
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

complaints = []


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda source, name: complaints.append(name))
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def summary(array, kinds=None):
    if isinstance(array, vtkStringArray):
        return [array.GetValue(i) for i in range(array.GetNumberOfValues())]
    values = vtk_to_numpy(array)
    numbers = values[~numpy.isnan(values)] if values.dtype.kind == "f" else values
    result = {
        "type": array.GetDataTypeAsString(),
        "tuples": array.GetNumberOfTuples(),
        "components": array.GetNumberOfComponents(),
        "nan": int(values.size - numbers.size),
        "range": [numbers.min().item(), numbers.max().item()] if numbers.size else None,
        "vtk_range": list(array.GetRange()),
        "sum": float(numbers.sum()),
    }
    if kinds is not None:
        result["nonzero"] = {str(kind): int(numpy.count_nonzero(values[kinds == kind])) for kind in numpy.unique(kinds)}
    return result


def arrays_of(data, kinds=None):
    return {data.GetAbstractArray(i).GetName(): summary(data.GetAbstractArray(i), kinds)
            for i in range(data.GetNumberOfArrays())}


def tally(values):
    names, counts = numpy.unique(values, return_counts=True)
    return {str(name): int(count) for name, count in zip(names, counts)}


def volumes(grid):
    """The sum of the volumes of the cells of each kind, from the points."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    offsets = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    kinds = vtk_to_numpy(grid.GetCellData().GetArray("kind"))
    first = points[connectivity[offsets[:-1]]]
    last = points[connectivity[offsets[1:] - 1]]
    sizes = numpy.prod(last - first, axis=1)
    return {str(kind): float(sizes[kinds == kind].sum()) for kind in numpy.unique(kinds)}


def crooked_voxels(grid):
    """How many voxels are no boxes: corner c lies at the upper end of axis a where bit a of c is set, else at the lower."""
    points = vtk_to_numpy(grid.GetPoints().GetData())
    connectivity = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    begins = vtk_to_numpy(grid.GetCells().GetOffsetsArray())[:-1]
    voxels = begins[vtk_to_numpy(grid.GetCellTypesArray()) == VTK_VOXEL]
    first, last = points[connectivity[voxels]], points[connectivity[voxels + 7]]
    crooked = numpy.any(first > last, axis=1)
    for corner in range(8):
        upper = numpy.array([corner >> axis & 1 for axis in range(3)], dtype=bool)
        crooked |= numpy.any(points[connectivity[voxels + corner]] != numpy.where(upper, last, first), axis=1)
    return int(numpy.count_nonzero(crooked))


def main():
    grid = read(sys.argv[1])
    if complaints or grid.GetNumberOfCells() == 0:
        sys.exit(f"VTK cannot read {sys.argv[1]}: {complaints}")
    kinds = vtk_to_numpy(grid.GetCellData().GetArray("kind"))
    print(json.dumps({
        "cells": grid.GetNumberOfCells(),
        "points": grid.GetNumberOfPoints(),
        "types": tally(vtk_to_numpy(grid.GetCellTypesArray())),
        "kinds": tally(kinds),
        "bounds": list(grid.GetBounds()),
        "volumes": volumes(grid),
        "crooked_voxels": crooked_voxels(grid),
        "cell_data": arrays_of(grid.GetCellData(), kinds),
        "point_data": arrays_of(grid.GetPointData()),
        "field_data": arrays_of(grid.GetFieldData()),
    }))


main()
