// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/label_surfaces.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "model/base/parallel.h"
#include "model/import/source/stated_unit.h"
#include "model/import/volumes/label_mesh.h"
#include "model/import/volumes/net_relaxation.h"
#include "model/import/volumes/surface_net.h"

namespace sline::model {

namespace {

Error surfaceFault(std::string reason, std::string remedy) {
  return Error{{}, {}, std::move(reason), std::move(remedy)};
}

Error cancelled() {
  return surfaceFault("the import was cancelled", "Import it again");
}

/// Tells whether the matrix can be used. The finest voxels are an electron microscope's; and
/// lengths computed in single precision must not vanish beside the longest side.
bool isUsable(const glm::dmat4& matrix) {
  constexpr double shortest = 1e-9;  // mm
  constexpr double farthest = 1e7;
  constexpr double mostOblong = 1e5;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!(std::abs(matrix[column][row]) < farthest))
        return false;
  const glm::dvec3 sides(glm::length(glm::dvec3(matrix[0])), glm::length(glm::dvec3(matrix[1])),
                         glm::length(glm::dvec3(matrix[2])));
  const auto [least, most] = std::minmax({sides.x, sides.y, sides.z});
  // A sheared grid is fine, one with axes in a plane is not.
  return least >= shortest && most <= mostOblong * least &&
         std::abs(glm::determinant(glm::dmat3(matrix))) > 1e-4 * sides.x * sides.y * sides.z;
}

/// Returns the relaxation; millions of points take fewer steps, so that no volume takes minutes.
Relaxation relaxationOf(const Smoothing& smoothing, std::size_t points) {
  constexpr std::size_t pointSteps = 120'000'000;
  Relaxation relaxation;
  relaxation.steps = std::clamp(int(pointSteps / (points + 1)), 30, relaxation.steps);
  if (smoothing.mode == Smoothing::Mode::off)
    relaxation = {0, 0};
  else if (smoothing.mode == Smoothing::Mode::steps)
    relaxation = {smoothing.steps, 0};
  return relaxation;
}

class Surfacer {
 public:
  Surfacer(const LabelVolume& volume, const ReadOptions& options)
      : m_volume(volume), m_options(options), m_box(volume) {}

  Result<RawMeshes> run(const NetPlacement& placement) {
    if (m_box.empty())
      return surfaceFault("the volume holds nothing but background",
                          "Choose a volume with structures");
    const std::optional<SurfaceNet> net =
        surfaceNet(m_box, m_options.limits.vertices, m_options.goesOn);
    if (!net)
      return m_options.goesOn()
                 ? surfaceFault("the borders of its structures have more than " +
                                    std::to_string(m_options.limits.vertices) + " vertices",
                                "Check that it is a label volume, or export it with larger voxels")
                 : cancelled();
    for (int axis = 0; axis < 3; ++axis)
      m_spacing[axis] = float(glm::length(glm::dvec3(m_volume.toLps[axis])));
    const LabelSheets sheets =
        labelSheets(m_box, *net, m_volume.labels.size(), m_options.limits.triangles / 2);
    if (sheets.quads.empty())
      return surfaceFault("its structures have more than " +
                              std::to_string(m_options.limits.triangles) + " triangles",
                          "Check that it is a label volume, or export it with larger voxels");
    const std::vector<glm::vec3> at = placement({m_box, *net, sheets, m_spacing});
    if (at.empty())
      return cancelled();
    return meshes(*net, sheets, at);
  }

 private:
  Result<RawMeshes> meshes(const SurfaceNet& net, const LabelSheets& sheets,
                           const std::vector<glm::vec3>& at) const {
    std::vector<RawMesh> all(m_volume.labels.size());
    const std::vector<std::size_t> counts = voxelCounts();
    const double voxel = std::abs(glm::determinant(glm::dmat3(m_volume.toLps)));
    std::atomic<bool> stopped = false;
    parallelFor(all.size(), 1, [&](std::size_t i) {
      if (stopped || !m_options.goesOn())
        stopped = true;
      else if (!sheets.quadsOf(i + 1).empty()) {
        all[i] = mesh(net, sheets, labelMesh(m_box, net, sheets, i + 1, at), m_volume.labels[i]);
        all[i].voxelVolume = double(counts[i + 1]) * voxel;
        toFileUnit(all[i]);
      }
    });
    if (stopped)
      return cancelled();
    std::erase_if(all, [](const RawMesh& mesh) { return mesh.triangles.empty(); });
    return RawMeshes{std::move(all), {}};
  }

  /// Gives the surface, which was made in millimetres, in the unit that the file's header states.
  static void toFileUnit(RawMesh& mesh) {
    const double unit = statedMillimetres(mesh.unitReason);
    if (unit == 1.0)
      return;
    mesh.millimetresPerUnit = float(unit);
    for (glm::vec3& p : mesh.positions)
      p = glm::vec3(glm::dvec3(p) / unit);
    mesh.displacement = float(double(mesh.displacement) / unit);
    mesh.sliceDistance = float(double(mesh.sliceDistance) / unit);
    *mesh.voxelVolume /= unit * unit * unit;
  }

  /// Returns how many voxels each label has, the background first.
  std::vector<std::size_t> voxelCounts() const {
    std::vector<std::size_t> counts(m_volume.labels.size() + 1);
    for (const std::uint16_t voxel : m_volume.voxels)
      if (voxel < counts.size())
        ++counts[voxel];
    return counts;
  }

  RawMesh mesh(const SurfaceNet& net, const LabelSheets& sheets, LabelMesh&& found,
               const Label& label) const {
    RawMesh mesh;
    mesh.name = label.name;
    mesh.groups = label.groups;
    mesh.colour = label.colour;
    mesh.frame = m_volume.frame;
    mesh.frameReason = m_volume.frameReason;
    mesh.onlySideOpen = m_volume.onlySideOpen;
    mesh.unitReason = m_volume.unitReason;
    mesh.smooth = true;
    mesh.triangles = std::move(found.triangles);
    mesh.positions.reserve(found.positions.size());
    // Files in RAS get coordinates back in RAS: half a turn, which keeps handedness.
    const double turn = m_volume.frame == Frame::ras ? -1.0 : 1.0;
    const glm::dmat3 axes(m_volume.toLps);
    double farthest = 0.0;
    for (std::size_t i = 0; i < found.positions.size(); ++i) {
      const glm::dvec3 index = glm::dvec3(found.positions[i]) / glm::dvec3(m_spacing);
      const glm::dvec3 p =
          glm::dvec3(m_volume.toLps * glm::dvec4(index + glm::dvec3(m_box.low()), 1.0));
      mesh.positions.emplace_back(turn * p.x, turn * p.y, p.z);
      if (i >= found.points.size())
        continue;
      const SurfaceNet::Cell& cell = net.cells[sheets.cellOf[found.points[i]]];
      const glm::dvec3 middle = glm::dvec3(cell.x, cell.y, cell.z) - 0.5;
      farthest = std::max(farthest, glm::length(axes * (index - middle)));
    }
    mesh.displacement = float(farthest);
    if (m_options.smoothing.mode != Smoothing::Mode::off)
      mesh.sliceDistance = std::max({m_spacing.x, m_spacing.y, m_spacing.z});
    if (glm::determinant(axes) < 0.0)
      for (Triangle& t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
  }

  const LabelVolume& m_volume;
  const ReadOptions& m_options;
  VoxelBox m_box;
  glm::vec3 m_spacing{1.0f};
};

}  // namespace

namespace {

/// Returns the surfaces without looking at what is there already.
Result<RawMeshes> allSurfaces(const LabelVolume& volume, const ReadOptions& options) {
  return placedSurfaces(volume, options, [&options](const LabelNet& made) {
    return relaxed(made.net, made.sheets, made.spacing,
                   relaxationOf(options.smoothing, made.sheets.cellOf.size()), options.goesOn);
  });
}

}  // namespace

Result<RawMeshes> labelSurfaces(const LabelVolume& volume, const ReadOptions& options) {
  std::vector<bool> there(volume.labels.size() + 1);
  for (std::size_t i = 0; i < volume.labels.size(); ++i)
    there[i + 1] = options.isThere(volume.labels[i].name);
  if (std::find(there.begin(), there.end(), true) == there.end())
    return allSurfaces(volume, options);
  LabelVolume rest = volume;
  std::vector<bool> found(there.size());
  bool any = false;
  for (std::uint16_t& voxel : rest.voxels) {
    const std::size_t label = std::min(std::size_t(voxel), there.size() - 1);
    found[label] = found[label] || there[label];
    if (there[label])
      voxel = 0;
    any = any || voxel != 0;
  }
  const auto count = std::uint64_t(std::count(found.begin(), found.end(), true));
  Result<RawMeshes> made =
      any || count == 0 ? allSurfaces(rest, options) : Result<RawMeshes>(RawMeshes{});
  if (made.ok())
    made->thereAlready = count;
  return made;
}

Result<RawMeshes> placedSurfaces(const LabelVolume& volume, const ReadOptions& options,
                                 const NetPlacement& placement) {
  constexpr int longestSide = 65'000;
  const glm::ivec3 size = volume.size;
  const bool fits =
      size.x > 0 && size.y > 0 && size.z > 0 && size.x <= longestSide && size.y <= longestSide &&
      size.z <= longestSide &&
      volume.voxels.size() == std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z);
  if (!fits)
    return surfaceFault("the volume's size is not one of voxels", "Export the volume again");
  if (!isUsable(volume.toLps))
    return surfaceFault(
        "the sides of its voxels do not span space, or are too small, too large or too "
        "unlike to be computed with",
        "Export the volume again with its directions and spacings");
  return Surfacer(volume, options).run(placement);
}

}  // namespace sline::model
