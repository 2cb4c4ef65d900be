"""The programs for which files are exported, as readers of what is in them."""

import warnings
import xml.etree.ElementTree as ElementTree

import pytest


def package(name):
    """A package of Debian that reads the files; scripts/test installs it."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of modules that later Pythons will not have
        return pytest.importorskip(name, reason=f"{name} is not installed; scripts/test does that")


def in_ase(path, file_format, **options):
    package("ase")
    import ase.io
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return ase.io.read(path, index=":", format=file_format, **options)


def in_mdanalysis(path, file_format, spheres, **options):
    analysis = package("MDAnalysis")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        universe = analysis.Universe.empty(spheres)
        universe.load_new(str(path), format=file_format, **options)
    return universe


def in_vtk(path):
    """A frame in VTK: points, arrays by their names, field data by their names."""
    vtk = package("vtkmodules.vtkIOXML")
    from vtkmodules.util.numpy_support import vtk_to_numpy
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetErrorCode() == 0
    data = reader.GetOutput()

    def arrays(group):
        return {group.GetArrayName(n): vtk_to_numpy(group.GetArray(n))
                for n in range(group.GetNumberOfArrays())}

    assert data.GetNumberOfVerts() == data.GetNumberOfPoints() == data.GetNumberOfCells()
    return (vtk_to_numpy(data.GetPoints().GetData()), arrays(data.GetPointData()),
            arrays(data.GetFieldData()))


def collection(path):
    """Times and files of a .pvd."""
    entries = ElementTree.parse(path).getroot().findall("./Collection/DataSet")
    return [(float(entry.get("timestep")), path.parent / entry.get("file")) for entry in entries]
