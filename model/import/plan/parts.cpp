// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/parts.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "model/base/parallel.h"
#include "model/files/fingerprint.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/naming/laterality.h"
#include "model/import/naming/names.h"
#include "model/import/volumes/volume_set.h"
#include "model/import/volumes/volume_surfaces.h"
#include "model/import/worker/reading_child.h"
#include "model/meshing/repair.h"
#include "model/meshing/simplification.h"

namespace sline::model {

namespace {

constexpr std::size_t atATime = 3;

std::string counted(int count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

void mend(Part& part, const std::string& file, std::vector<ImportWarning>& warnings) {
  part.repair = repair(part.raw.positions, part.raw.triangles);
  part.provenance.repairedFaces = part.repair.faces();
  if (part.repair.notOrientable)
    warnings.push_back({file, "a piece of \"" + part.name +
                                  "\" has no consistent orientation; it stays as it is"});
}

Result<RawMeshes> readTogether(const SourceFile& source, const ReadOptions& options) {
  std::vector<std::filesystem::path> files{source.file};
  files.insert(files.end(), source.together.begin(), source.together.end());
  return source.slice ? readInChild(dicomKind, files, options) : readVolumeSet(files, options);
}

/// What the surfaces of one file have in common.
struct FileFacts {
  std::optional<Fingerprint> fingerprint;
  int surfaces = 0;
};

/// By the files' names.
std::map<std::string, FileFacts> factsOf(const SourceFile& source,
                                         const std::vector<RawMesh>& meshes) {
  std::map<std::string, FileFacts> facts;
  const auto add = [&facts](const std::filesystem::path& file) {
    if (const Result<Fingerprint> print = fingerprintOfFile(file))
      facts[file.filename().string()].fingerprint = *print;
  };
  // Slices are called by what scanned them.
  if (!source.slice) {
    add(source.file);
    std::for_each(source.together.begin(), source.together.end(), add);
  }
  const std::string first = source.file.filename().string();
  for (const RawMesh& mesh : meshes)
    ++facts[mesh.file.empty() ? first : mesh.file].surfaces;
  return facts;
}

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

/// A folder may hold a label volume and the surfaces made of it: what is there as a surface is not
/// taken from the volume as well.
void leaveOutTwins(std::vector<Part>& parts, const Sources& sources,
                   std::vector<ImportWarning>& warnings) {
  const auto key = [&](const Part& part) {
    std::string name;
    for (const std::string& word : nameWords(part.name))
      name += word + ' ';
    return std::pair(sources.files[part.file].source, name);
  };
  const auto fromVolume = [&](const Part& part) {
    const SourceFile& file = sources.files[part.file];
    return sources.sources[file.source].kind == ImportSource::Kind::folder &&
           isVolumeFile(file.file);
  };
  std::set<std::pair<std::size_t, std::string>> surfaces;
  for (const Part& part : parts)
    if (!fromVolume(part))
      surfaces.insert(key(part));
  std::map<std::string, int> leftOut;
  std::erase_if(parts, [&](const Part& part) {
    const bool twin = fromVolume(part) && surfaces.contains(key(part));
    leftOut[part.provenance.file] += twin;
    return twin;
  });
  for (const auto& [file, count] : leftOut)
    if (count > 0)
      warnings.push_back({file, counted(count, "structure", "structures") +
                                    " left out that the folder also holds as surfaces"});
}

/// What the smoothing of itself asks to know of each, where it was not asked while reading.
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

/// Each part's own voxel grid, or the one it shares with the parts of its source.
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

/// Of a surface in (x, anterior, superior), x to the left.
bool isMirrored(const RawMesh& raw, const Provenance& as) {
  return raw.onlySideOpen && as.frame == frameName(Frame::lps);
}

/// File coordinates → millimetres LPS.
glm::vec3 placed(const glm::vec3& p, const Provenance& as, const RawMesh& raw,
                 const std::optional<glm::dmat4>& toWorld) {
  glm::vec3 q = raw.yUp ? uprightToLps(p) : p;
  q *= as.mmPerUnit;
  if (isMirrored(raw, as))
    q.y = -q.y;
  if (as.frame == frameName(Frame::ras))
    q = halfTurn(q);
  if (!toWorld)
    return q;
  const glm::dvec4 ras(-double(q.x), -double(q.y), double(q.z), 1.0);
  const glm::dvec4 world = *toWorld * ras;
  return {float(-world.x), float(-world.y), float(world.z)};
}

ReadOptions readOptions(const ImportOptions& options, ProgressMeter& meter,
                        const std::string& shown) {
  return {.limits = options.limits,
          .smoothing = options.smoothing,
          .assembly = options.assembly,
          .goesOn = [&meter, shown] { return meter.goesOn(shown); },
          .thresholds = options.thresholds,
          .keepScans = options.keepScans};
}

IntensityRange rangeOf(const Threshold& threshold) {
  IntensityRange range;
  if (threshold.low)
    range.low = float(*threshold.low);
  if (threshold.high)
    range.high = float(*threshold.high);
  return range;
}

struct Loading {
  const ImportOptions& options;
  ProgressMeter& meter;
};

/// What a part is called.
std::string partName(const RawMesh& raw, const SourceFile& source, const Sources& sources,
                     bool only) {
  std::string name = raw.molecule ? raw.name : nameInFile(raw.name);
  if (name.empty())
    name = readableName(stemOf(source.file));
  if (!source.model)
    return name;
  const SlicerModel& model = sources.sources[source.source].scene->models[*source.model];
  return model.segments ? name : only ? model.name : model.name + " " + name;
}

/// Mends and measures; false where no face with area is left.
bool prepare(Part& part, const std::string& shown, const ImportOptions& options,
             std::vector<ImportWarning>& warnings) {
  if (options.repair)
    mend(part, shown, warnings);
  if (part.raw.triangles.empty()) {
    warnings.push_back({shown, "\"" + part.name + "\" has no face with area; left out"});
    return false;
  }
  part.raw.positions.shrink_to_fit();
  part.raw.triangles.shrink_to_fit();
  if (options.smoothing.mode == Smoothing::Mode::automatic && !part.raw.smooth)
    part.measure = measureSurface(part.raw.positions, part.raw.triangles);
  return true;
}

/// What was read of a file as parts.
Loaded loadedFrom(const Sources& sources, std::size_t index, Result<RawMeshes>&& read,
                  const Loading& loading) {
  Loaded loaded;
  const SourceFile& source = sources.files[index];
  const std::string shown = source.file.filename().string();
  if (!read) {
    Error error = read.error();
    error.file.clear();
    loaded.warnings.push_back({shown, error.text()});
    return loaded;
  }
  loaded.warnings = std::move(read->warnings);
  loaded.notes = std::move(read->notes);
  for (RawScan& scan : read->scans)
    loaded.scans.push_back({index, std::move(scan)});
  std::vector<RawMesh>& meshes = read->meshes;
  std::map<std::string, FileFacts> facts = factsOf(source, meshes);
  const std::vector<std::string> names = partNames(meshes);
  for (std::size_t i = 0; i < meshes.size() && loading.meter.goesOn(shown); ++i) {
    Part part;
    part.file = index;
    part.surface = names[i];
    part.name = partName(meshes[i], source, sources, meshes.size() == 1);
    part.raw = std::move(meshes[i]);
    const std::string& file = part.raw.file.empty() ? shown : part.raw.file;
    part.provenance.file = part.raw.origin.empty() ? file : part.raw.origin;
    // Without its file's name there is nothing to read again by.
    if (part.raw.origin.empty())
      part.provenance.fingerprint = facts[file].fingerprint;
    if (facts[file].surfaces > 1 || part.raw.threshold)
      part.provenance.part = names[i];
    if (const auto& threshold = part.raw.threshold)
      part.provenance.intensities = rangeOf(*threshold);
    if (prepare(part, shown, loading.options, loaded.warnings))
      loaded.parts.push_back(std::move(part));
  }
  return loaded;
}

}  // namespace

void ProgressMeter::add(double amount, const std::string& what) {
  const std::lock_guard lock(m_mutex);
  m_done += amount;
  if (m_progress && !m_cancelled && !m_progress(float(std::min(1.0, m_done / m_total)), what))
    m_cancelled = true;
}

void forFewAtATime(const std::vector<std::size_t>& order, const ProgressMeter& meter,
                   const std::function<void(std::size_t)>& body) {
  std::atomic<std::size_t> next = 0;
  parallelFor(std::min(atATime, order.size()), 1, [&](std::size_t) {
    for (std::size_t i = next++; i < order.size() && !meter.cancelled(); i = next++)
      body(order[i]);
  });
}

Loaded loadFile(const Sources& sources, std::size_t index, const ImportOptions& options,
                ProgressMeter& meter) {
  const SourceFile& source = sources.files[index];
  const ReadOptions how = readOptions(options, meter, source.file.filename().string());
  Result<RawMeshes> read = source.together.empty() && !source.slice ? readSurfaces(source.file, how)
                                                                    : readTogether(source, how);
  return loadedFrom(sources, index, std::move(read), {options, meter});
}

Loaded loadScan(const Sources& sources, const ReadScan& scan, const ImportOptions& options,
                ProgressMeter& meter) {
  ReadOptions how = readOptions(options, meter, scan.raw.file);
  how.keepScans = false;
  return loadedFrom(sources, scan.file, scanSurfaces(scan.raw, how), {options, meter});
}

Loaded loadParts(const Sources& sources, const ImportOptions& options, ProgressMeter& meter) {
  std::vector<std::size_t> order(sources.files.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  // Large files first, so that none is left to the end while a core waits.
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return sources.files[a].bytes > sources.files[b].bytes;
  });
  std::vector<Loaded> loaded(sources.files.size());
  forFewAtATime(order, meter, [&](std::size_t i) {
    loaded[i] = loadFile(sources, i, options, meter);
    meter.add(double(sources.files[i].bytes) + 1.0, sources.files[i].file.filename().string());
  });
  Loaded all;
  const auto take = [](auto& to, auto& from) {
    std::move(from.begin(), from.end(), std::back_inserter(to));
  };
  for (Loaded& one : loaded) {
    take(all.parts, one.parts);
    take(all.scans, one.scans);
    take(all.warnings, one.warnings);
    take(all.notes, one.notes);
  }
  leaveOutTwins(all.parts, sources, all.warnings);
  numberParts(all.parts);
  return all;
}

void numberParts(std::vector<Part>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i].number = i;
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
    const Smoothing how = asked(part);
    if (part.raw.smooth) {
      part.provenance.displacementMm = part.raw.displacement * part.unit;
      if (how.mode == Smoothing::Mode::steps)
        part.provenance.smoothingSteps = how.steps;
      return;
    }
    const double work = double(part.raw.triangles.size()) * workPerTriangle;
    const Smoothed done = smooth(part.raw.positions, part.raw.triangles, grids[i], how, allowed[i]);
    part.provenance.smoothingSteps = done.smoothingSteps;
    part.provenance.refinementSteps = done.refinementSteps;
    part.provenance.displacementMm = done.displacement * part.unit;
    meter.add(work, part.name);
  });
}

Result<MeshPtr> placedMesh(RawMesh raw, Provenance& as) {
  if (as.frame != frameName(Frame::file)) {
    const std::optional<glm::dmat4> toWorld = matrixOf(as);
    for (glm::vec3& p : raw.positions)
      p = placed(p, as, raw, toWorld);
    const double scale = toWorld ? glm::determinant(glm::dmat3(*toWorld)) : 1.0;
    as.displacementMm *= float(std::cbrt(std::abs(scale)));
    if ((scale < 0.0) != isMirrored(raw, as))
      for (Triangle& t : raw.triangles)
        std::swap(t[1], t[2]);
  }
  Result<Mesh> mesh = Mesh::create(std::move(raw.positions), std::move(raw.triangles));
  if (!mesh)
    return mesh.error();
  return MeshPtr(std::make_shared<const Mesh>(std::move(*mesh)));
}

std::vector<std::string> partNames(const std::vector<RawMesh>& meshes) {
  std::vector<std::string> names;
  names.reserve(meshes.size());
  for (const RawMesh& mesh : meshes) {
    std::string name = nameInFile(mesh.name);
    names.push_back(name.empty() ? "surface" : std::move(name));
  }
  makeUnique(names);
  return names;
}

void placeParts(std::vector<Part>& parts, const Sources& sources,
                std::vector<ImportWarning>& warnings) {
  for (Part& part : parts) {
    const SourceFile& source = sources.files[part.file];
    part.provenance.frame = frameName(part.frame);
    part.provenance.mmPerUnit = part.unit;
    if (source.model)
      if (const auto& toWorld = sources.sources[source.source].scene->models[*source.model].toWorld)
        part.provenance.transform = rowsOf(*toWorld);
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
    Simplified fewer = simplified(part.mesh, own, [&] { return meter.goesOn(part.name); });
    meter.add(double(before) * workPerTriangle, part.name);
    if (fewer.mesh == part.mesh)
      return;
    part.mesh = std::move(fewer.mesh);
    part.provenance.decimatedFrom = int(before);
    part.provenance.decimationMm = fewer.error;
  });
}

}  // namespace sline::model
