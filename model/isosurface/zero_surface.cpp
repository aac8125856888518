// SPDX-License-Identifier: Apache-2.0
#include "model/isosurface/zero_surface.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <array>

namespace sline::model {

ZeroSurface zeroSurface(const SampledBox& box) {
  vtkNew<vtkFloatArray> values;
  // The flying edges filter only reads the values.
  values->SetArray(const_cast<float*>(box.values.data()), vtkIdType(box.values.size()), 1);
  vtkNew<vtkImageData> image;
  image->SetDimensions(box.size.x, box.size.y, box.size.z);
  image->SetOrigin(box.origin.x, box.origin.y, box.origin.z);
  image->SetSpacing(box.step.x, box.step.y, box.step.z);
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  ZeroSurface surface;
  vtkPolyData* out = contour->GetOutput();
  for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i) {
    std::array<double, 3> p{};
    out->GetPoint(i, p.data());
    surface.positions.emplace_back(p[0], p[1], p[2]);
  }
  const auto cells = vtk::TakeSmartPointer(out->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    surface.triangles.push_back(
        {std::uint32_t(ids[0]), std::uint32_t(ids[1]), std::uint32_t(ids[2])});
  }
  return surface;
}

}  // namespace sline::model
