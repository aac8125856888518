// SPDX-License-Identifier: Apache-2.0
#include "model/demo/polygonise.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/base/parallel.h"
#include "model/geometry/topology.h"

namespace sline::model {

namespace {
constexpr int relaxations = 8;
constexpr int finalNewtonSteps = 3;
constexpr int blockCells = 8;

struct Raw {
  std::vector<glm::vec3> positions;
  std::vector<Triangle> triangles;
};

/// Samples the field on a grid. A block of cells from whose middle the surface is farther than its
/// corners is filled with that one value: most of the box is empty.
void sample(const Field& field, const Box& box, float cell, const glm::ivec3& size, float* values) {
  const glm::ivec3 blocks = (size + blockCells - 1) / blockCells;
  const float reach = 0.5f * std::sqrt(3.0f) * cell * float(blockCells);
  parallelFor(
      std::size_t(blocks.x) * std::size_t(blocks.y) * std::size_t(blocks.z), 8,
      [&](std::size_t block) {
        const int b = int(block);
        const glm::ivec3 first =
            blockCells * glm::ivec3(b % blocks.x, b / blocks.x % blocks.y, b / blocks.x / blocks.y);
        const glm::ivec3 end = glm::min(first + blockCells, size);
        const float middle = field(box.low + cell * (glm::vec3(first) + 0.5f * float(blockCells)));
        const bool empty = std::abs(middle) > 2.0f * reach;
        for (int z = first.z; z < end.z; ++z)
          for (int y = first.y; y < end.y; ++y)
            for (int x = first.x; x < end.x; ++x)
              values[(std::ptrdiff_t(z) * size.y + y) * size.x + x] =
                  empty ? middle : field(box.low + cell * glm::vec3(x, y, z));
      });
}

Raw flyingEdges(const Field& field, const Box& box, float cell) {
  const glm::ivec3 size = glm::ivec3(glm::ceil(box.size() / cell)) + 1;
  vtkNew<vtkImageData> image;
  image->SetDimensions(size.x, size.y, size.z);
  image->SetOrigin(double(box.low.x), double(box.low.y), double(box.low.z));
  image->SetSpacing(double(cell), double(cell), double(cell));
  image->AllocateScalars(VTK_FLOAT, 1);
  float* values = static_cast<float*>(image->GetScalarPointer());
  sample(field, box, cell, size, values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  Raw raw;
  vtkPolyData* out = contour->GetOutput();
  for (vtkIdType i = 0; i < out->GetNumberOfPoints(); ++i) {
    std::array<double, 3> p{};
    out->GetPoint(i, p.data());
    raw.positions.emplace_back(p[0], p[1], p[2]);
  }
  const auto cells = vtk::TakeSmartPointer(out->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    raw.triangles.push_back({std::uint32_t(ids[0]), std::uint32_t(ids[1]), std::uint32_t(ids[2])});
  }
  return raw;
}

/// By differences over the corners of a tetrahedron.
glm::vec3 gradient(const Field& field, const glm::vec3& p, float h) {
  glm::vec3 sum(0.0f);
  for (const glm::vec3 d :
       {glm::vec3(1, 1, 1), glm::vec3(1, -1, -1), glm::vec3(-1, 1, -1), glm::vec3(-1, -1, 1)})
    sum += field(p + h * d) * d;
  return sum / (4.0f * h);
}

/// One Newton step along the gradient towards field = 0.
glm::vec3 projected(const Field& field, const glm::vec3& p, float edge) {
  const glm::vec3 g = gradient(field, p, 0.05f * edge);
  const float squared = glm::dot(g, g);
  return squared > 1e-6f ? p - field(p) / squared * g : p;
}

/// Each vertex to the area-weighted centroid of its triangles, then back onto the surface.
void relax(const Field& field, Raw& raw, const VertexFaces& faces, float edge) {
  std::vector<glm::vec3> moved(raw.positions.size());
  parallelFor(moved.size(), 256, [&](std::size_t v) {
    glm::vec3 sum(0.0f);
    float weights = 0.0f;
    for (const std::uint32_t f : faces[v]) {
      const auto& [a, b, c] = raw.triangles[f];
      const glm::vec3 pa = raw.positions[a];
      const glm::vec3 pb = raw.positions[b];
      const glm::vec3 pc = raw.positions[c];
      const float area = glm::length(glm::cross(pb - pa, pc - pa)) + 1e-6f * edge * edge;
      sum += area * (pa + pb + pc) / 3.0f;
      weights += area;
    }
    moved[v] = weights > 0.0f ? projected(field, sum / weights, edge) : raw.positions[v];
  });
  raw.positions = std::move(moved);
}

float signedVolume(const Raw& raw) {
  double volume = 0.0;
  for (const auto& [a, b, c] : raw.triangles)
    volume += double(glm::dot(raw.positions[a], glm::cross(raw.positions[b], raw.positions[c])));
  return float(volume / 6.0);
}

MeshPtr meshOf(std::vector<glm::vec3> positions, std::vector<Triangle> triangles) {
  auto mesh = Mesh::create(std::move(positions), std::move(triangles));
  return std::make_shared<const Mesh>(std::move(mesh).value());
}
}  // namespace

MeshPtr polygonise(const Field& field, const Box& box, float edge) {
  Raw raw = flyingEdges(field, box, edge);
  const VertexFaces faces(*meshOf(raw.positions, raw.triangles));
  for (int i = 0; i < relaxations; ++i)
    relax(field, raw, faces, edge);
  parallelFor(raw.positions.size(), 256, [&](std::size_t v) {
    for (int step = 0; step < finalNewtonSteps; ++step)
      raw.positions[v] = projected(field, raw.positions[v], edge);
  });
  if (signedVolume(raw) < 0.0f)
    for (Triangle& t : raw.triangles)
      std::swap(t[1], t[2]);
  return meshOf(std::move(raw.positions), std::move(raw.triangles));
}

}  // namespace sline::model
