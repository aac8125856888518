// SPDX-License-Identifier: Apache-2.0
// Reads unstructured grids of VTK in XML, through VTK 9.1: the faces that bound their cells.
#include <vtkCellArray.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <exception>
#include <new>

#include "model/import/foreign/foreign.h"
#include "model/import/readers/vtk/vtk_messages.h"
#include "model/import/source/surface_assembly.h"

namespace sline::model {

namespace {

constexpr const char* exportAgain = "Export the outer surface, as VTP or STL";

/// Returns polygons and strips as faces; anything else is lines and points. A wrong face is
/// reported at `place` in the file.
FaceList facesOf(vtkPolyData& surface, const char* place) {
  FaceList faces;
  const vtkIdType* corners = nullptr;
  vtkIdType count = 0;
  std::vector<std::uint32_t> loop;
  const auto take = [&] {
    loop.assign(std::size_t(count), 0);
    for (vtkIdType i = 0; i < count; ++i)
      loop[std::size_t(i)] = indexFrom(corners[i]);
  };
  vtkCellArray* polygons = surface.GetPolys();
  for (polygons->InitTraversal(); polygons->GetNextCell(count, corners);) {
    take();
    for (const std::uint32_t corner : loop)
      faces.add(corner, place);
    faces.close();
  }
  vtkCellArray* strips = surface.GetStrips();
  for (strips->InitTraversal(); strips->GetNextCell(count, corners);) {
    take();
    addStrip(loop, faces, place);
  }
  return faces;
}

Result<RawMeshes> surfaceOf(const Source& source) {
  const VtkMessages messages;
  const vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(source.file().c_str());
  reader->Update();
  const auto said = [&](const std::string& reason) {
    return reason + (messages.any() ? ": " + messages.first() : "");
  };
  vtkUnstructuredGrid* grid = reader->GetOutput();
  if (reader->GetErrorCode() != 0 || messages.any() || !grid)
    return source.whole(said("cannot be read as VTU"), exportAgain);
  if (grid->GetNumberOfCells() == 0 || !grid->GetPoints())
    return source.whole("holds no cells", exportAgain);
  const vtkNew<vtkDataSetSurfaceFilter> outside;
  outside->SetInputData(grid);
  outside->Update();
  vtkPolyData* surface = outside->GetOutput();
  if (messages.any() || !surface || !surface->GetPoints())
    return source.whole(said("has no outer surface"), exportAgain);
  const FaceList faces = facesOf(*surface, source.begin());
  RawMesh mesh;
  mesh.positions.resize(std::size_t(surface->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    double p[3];
    surface->GetPoint(vtkIdType(i), p);
    mesh.positions[i] = {narrowed(p[0]), narrowed(p[1]), narrowed(p[2])};
  }
  std::vector<ImportWarning> warnings;
  if (const vtkIdType left = surface->GetNumberOfVerts() + surface->GetNumberOfLines(); left > 0)
    warnings.push_back(source.warning(std::to_string(left) + " lines or points are left out"));
  if (faces.size() == 0)
    return source.whole("holds only lines or points", exportAgain);
  return assemble(source, std::move(mesh), faces, BadFaces::areErrors, std::move(warnings));
}

}  // namespace

Result<RawMeshes> readVtu(const std::filesystem::path& file, const ReadOptions& options) {
  const Source source = TRY(Source::read(file, options.limits));
  try {
    return surfaceOf(source);
  } catch (const std::bad_alloc&) {
    return source.whole("there is not enough memory for it", "Reduce it or close other programs");
  } catch (const std::exception& e) {
    return source.whole(std::string("cannot be read as VTU: ") + inQuotes(e.what()), exportAgain);
  }
}

}  // namespace sline::model
