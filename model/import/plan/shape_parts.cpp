// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/shape_parts.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <numeric>
#include <utility>

#include "model/geometry/extent.h"
#include "model/import/naming/laterality.h"
#include "model/import/source/values.h"
#include "model/lengths/measured_extent.h"
#include "model/meshing/simplification.h"

namespace sline::model {

namespace {

std::optional<glm::dmat4> matrixOf(const Provenance& as) {
  if (!as.transform)
    return std::nullopt;
  glm::dmat4 matrix(1.0);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      matrix[column][row] = double((*as.transform)[std::size_t(row) * 4 + std::size_t(column)]);
  return matrix;
}

std::array<float, 12> rowsOf(const glm::dmat4& matrix) {
  std::array<float, 12> rows{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      rows[std::size_t(row) * 4 + std::size_t(column)] = float(matrix[column][row]);
  return rows;
}

/// Measures the parts for smoothing, where they were not measured while reading.
void measureParts(std::vector<Part>& parts, ProgressMeter& meter) {
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (!parts[i].raw.smooth && parts[i].measure.vertices == 0)
      unknown.push_back(i);
  forFewAtATime(unknown, meter, [&](std::size_t i) {
    parts[i].measure = measureSurface(parts[i].raw.positions, parts[i].raw.triangles);
    meter.goesOn(parts[i].name);
  });
}

/// Returns each part's own voxel grid, or the one it shares with the parts of its source.
std::vector<VoxelGrid> gridsOf(const std::vector<Part>& parts, const Sources& sources) {
  std::vector<VoxelGrid> grids(parts.size());
  for (std::size_t source = 0; source < sources.sources.size(); ++source) {
    std::vector<std::size_t> members;
    std::vector<SurfaceMeasure> measures;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (sources.files[parts[i].file].source == source) {
        members.push_back(i);
        measures.push_back(parts[i].measure);
      }
    const std::vector<VoxelGrid> common = commonGrids(measures);
    for (std::size_t k = 0; k < members.size(); ++k)
      grids[members[k]] = common[k];
  }
  return grids;
}

}  // namespace

glm::vec3 placed(const glm::vec3& p, const Provenance& as, const RawMesh& raw,
                 const std::optional<glm::dmat4>& toWorld) {
  glm::vec3 q = raw.yUp ? uprightToLps(p) : p;
  q *= as.mmPerUnit;
  const FrameAxes axes = axesIn(axesOf(as.frame).frame, raw.onlySideOpen);
  q.x = axes.left ? q.x : -q.x;
  q.y = axes.posterior ? q.y : -q.y;
  if (!toWorld)
    return q;
  const glm::dvec4 ras(-double(q.x), -double(q.y), double(q.z), 1.0);
  const glm::dvec4 world = *toWorld * ras;
  return {float(-world.x), float(-world.y), float(world.z)};
}

std::optional<glm::dmat4> toWorldOf(const Part& part, const Sources& sources) {
  const SourceFile& source = sources.files[part.file];
  if (source.model)
    return sources.sources[source.source].scene->models[*source.model].toWorld;
  return source.told ? source.told->toWorld : std::nullopt;
}

namespace {

/// Returns the surface alone: names, groups and colours are asked for later.
RawMesh surfaceOf(const RawMesh& raw) {
  return {.positions = raw.positions,
          .triangles = raw.triangles,
          .yUp = raw.yUp,
          .onlySideOpen = raw.onlySideOpen};
}

/// Says in the part's provenance where its surface goes: by frame, unit and the scene around it.
void decidePlace(Part& part, const Sources& sources) {
  part.provenance.frame = frameName(part.frame);
  part.provenance.mmPerUnit = part.unit;
  if (const auto toWorld = toWorldOf(part, sources))
    part.provenance.transform = rowsOf(*toWorld);
}

std::optional<float> finite(std::optional<double> value) {
  return value && std::isfinite(narrowed(*value)) ? std::optional(narrowed(*value)) : std::nullopt;
}

ReadExtent readExtent(const Extent& extent) {
  return {finite(extent.area), finite(extent.volume)};
}

/// Returns what was measured of voxels, which have a volume and no surface.
std::optional<ReadExtent> extentOfVoxels(const RawMesh& raw, const Provenance& as) {
  if (!raw.voxelVolume)
    return std::nullopt;
  const std::optional<glm::dmat4> toWorld = matrixOf(as);
  const double scale = toWorld ? std::abs(glm::determinant(glm::dmat3(*toWorld))) : 1.0;
  return ReadExtent{{}, finite(*raw.voxelVolume * std::pow(double(as.mmPerUnit), 3.0) * scale)};
}

/// Notes what its reader has done to a surface that came smooth.
void noteSmoothed(Part& part, const Smoothing& how) {
  part.provenance.displacementMm = part.raw.displacement * part.unit;
  part.provenance.sliceMm = part.raw.sliceDistance * part.unit;
  if (how.mode == Smoothing::Mode::steps)
    part.provenance.smoothingSteps = how.steps;
  if (!isAsRead(part.provenance))
    part.provenance.asRead = extentAsRead(part.raw, part.provenance);
}

void smoothPart(Part& part, const Smoothing& how, const VoxelGrid& grid, int allowed) {
  const RawMesh before = surfaceOf(part.raw);
  const Smoothed done = smooth(part.raw.positions, part.raw.triangles, grid, how, allowed);
  part.provenance.smoothingSteps = done.smoothingSteps;
  part.provenance.refinementSteps = done.refinementSteps;
  part.provenance.displacementMm = done.displacement * part.unit;
  if (done.smoothingSteps > 0)
    part.provenance.sliceMm = grid.coarsest() * part.unit;
  if (!isAsRead(part.provenance))
    part.provenance.asRead = extentAsRead(before, part.provenance);
}

}  // namespace

std::optional<ReadExtent> extentAsRead(const RawMesh& raw, const Provenance& as) {
  if (raw.smooth)
    return extentOfVoxels(raw, as);
  Provenance placed = as;
  const Result<MeshPtr> mesh = placedMesh(surfaceOf(raw), placed);
  return mesh ? std::optional(readExtent(extentOf(**mesh))) : std::nullopt;
}

void smoothParts(std::vector<Part>& parts, const Sources& sources, const Smoothing& smoothing,
                 ProgressMeter& meter) {
  const auto asked = [&](const Part& part) { return part.choice.smoothing.value_or(smoothing); };
  const auto isAsked = [&](const Part& part) {
    return !part.choice.skipped && asked(part).mode != Smoothing::Mode::off;
  };
  if (std::none_of(parts.begin(), parts.end(), isAsked))
    return;
  const auto automatic = [&](const Part& part) {
    return isAsked(part) && asked(part).mode == Smoothing::Mode::automatic;
  };
  if (std::any_of(parts.begin(), parts.end(), automatic))
    measureParts(parts, meter);
  const std::vector<VoxelGrid> grids = gridsOf(parts, sources);
  std::vector<SurfaceMeasure> all;
  all.reserve(parts.size());
  for (const Part& part : parts)
    all.push_back(part.choice.skipped ? SurfaceMeasure() : part.measure);
  const std::vector<int> allowed = refinementAllowances(all);
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return parts[a].raw.triangles.size() > parts[b].raw.triangles.size();
  });
  forFewAtATime(order, meter, [&](std::size_t i) {
    Part& part = parts[i];
    if (!isAsked(part))
      return;
    const double work = double(part.raw.triangles.size()) * workPerTriangle;
    decidePlace(part, sources);
    if (part.raw.smooth) {
      noteSmoothed(part, asked(part));
    } else {
      smoothPart(part, asked(part), grids[i], allowed[i]);
      meter.add(work, part.name);
    }
  });
}

KeptAtoms placedAtoms(const RawMesh& raw, const Provenance& as) {
  KeptAtoms atoms = raw.molecule ? raw.molecule->atoms : KeptAtoms{};
  if (!atoms.set || as.frame == frameName(Frame::file))
    return atoms;
  const std::optional<glm::dmat4> toWorld = matrixOf(as);
  auto set = std::make_shared<AtomSet>(*atoms.set);
  for (AtomBall& atom : set->atoms) {
    atom.place = placed(atom.place, as, raw, toWorld);
    atom.radius *= as.mmPerUnit;
  }
  return {std::move(set)};
}

Result<MeshPtr> placedMesh(RawMesh raw, Provenance& as) {
  if (as.frame != frameName(Frame::file)) {
    const std::optional<glm::dmat4> toWorld = matrixOf(as);
    for (glm::vec3& p : raw.positions)
      p = placed(p, as, raw, toWorld);
    const double scale = toWorld ? glm::determinant(glm::dmat3(*toWorld)) : 1.0;
    as.displacementMm *= float(std::cbrt(std::abs(scale)));
    as.sliceMm *= float(std::cbrt(std::abs(scale)));
    if ((scale < 0.0) != axesIn(axesOf(as.frame).frame, raw.onlySideOpen).mirrored())
      for (Triangle& t : raw.triangles)
        std::swap(t[1], t[2]);
  }
  Mesh mesh = TRY(Mesh::create(std::move(raw.positions), std::move(raw.triangles)));
  return MeshPtr(std::make_shared<const Mesh>(std::move(mesh)));
}

void placeParts(std::vector<Part>& parts, const Sources& sources,
                std::vector<ImportWarning>& warnings) {
  for (Part& part : parts) {
    decidePlace(part, sources);
    if (part.raw.molecule)
      part.raw.molecule->atoms = placedAtoms(part.raw, part.provenance);
    // Names, groups and colours are asked for later.
    RawMesh surface{.positions = std::move(part.raw.positions),
                    .triangles = std::move(part.raw.triangles),
                    .yUp = part.raw.yUp,
                    .onlySideOpen = part.raw.onlySideOpen};
    Result<MeshPtr> mesh = placedMesh(std::move(surface), part.provenance);
    if (mesh)
      part.mesh = std::move(*mesh);
    else
      warnings.push_back(
          {part.provenance.file, "\"" + part.name + "\" was left out: " + mesh.error().text()});
  }
  std::erase_if(parts, [](const Part& part) { return !part.mesh; });
}

MeshPtr decimated(const MeshPtr& mesh, float bound, Provenance& as,
                  const std::function<bool()>& goesOn) {
  const int before = int(mesh->triangleCount());
  Simplified fewer = simplified(mesh, bound, goesOn);
  const bool same = fewer.mesh == mesh;
  if (!same && isAsRead(as))
    as.asRead = readExtent(extentOf(*mesh));
  as.decimatedFrom = same ? 0 : before;
  as.decimationMm = same ? 0.0f : fewer.error;
  return std::move(fewer.mesh);
}

void decimateParts(std::vector<Part>& parts, float bound, ProgressMeter& meter) {
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return parts[a].mesh->triangleCount() > parts[b].mesh->triangleCount();
  });
  forFewAtATime(order, meter, [&](std::size_t i) {
    Part& part = parts[i];
    const float own = part.choice.decimateMm.value_or(bound);
    if (!(own > 0.0f) || part.choice.skipped)
      return;
    const std::size_t before = part.mesh->triangleCount();
    part.mesh = decimated(part.mesh, own, part.provenance, [&] { return meter.goesOn(part.name); });
    meter.add(double(before) * workPerTriangle, part.name);
  });
}

}  // namespace sline::model
