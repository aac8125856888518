// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/reload.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "model/fairing/windowed_sinc.h"
#include "model/geometry/nearest_point.h"
#include "model/geometry/paint.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/naming/file_marks.h"
#include "model/import/plan/load_parts.h"
#include "model/import/plan/patients.h"
#include "model/import/plan/reload_patients.h"
#include "model/import/plan/shape_parts.h"
#include "model/lengths/measured_extent.h"
#include "model/lengths/told_length.h"
#include "model/meshing/repair.h"
#include "model/scene/scene_limits.h"
#include "model/scene_file/fingerprint.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;
using Fate = ReloadedFile::Fate;

/// Limits the files below a folder that are looked at: a search in a whole disk ends.
constexpr std::size_t mostFiles = 200'000;
constexpr const char* otherOfThisName =
    "another file of this name is not as it was read; name its folder if that one is meant";
/// It is said where more than this share of what was painted is lost.
constexpr float muchPaint = 0.05f;

/// Returns the files that have one of the names or marks (file_marks.h), by these.
std::map<std::string, std::set<fs::path>> filesNamed(const std::set<std::string>& names,
                                                     std::span<const fs::path> places,
                                                     std::vector<ImportWarning>& warnings) {
  std::map<std::string, std::set<fs::path>> found;
  const auto search = [&](const fs::path& file) {
    std::error_code fault;
    for (const std::string& name : std::set{file.filename().string(), fileMark(file)})
      if (names.contains(name) && fs::is_regular_file(file, fault))
        found[name].insert(fs::weakly_canonical(file, fault));
  };
  for (const fs::path& place : places) {
    std::error_code fault;
    if (!fs::is_directory(place, fault)) {
      search(place);
      continue;
    }
    std::size_t count = 0;
    fs::recursive_directory_iterator entry(place, fs::directory_options::skip_permission_denied,
                                           fault);
    for (const fs::recursive_directory_iterator end; !fault && entry != end && count < mostFiles;
         entry.increment(fault), ++count)
      search(entry->path());
    if (fault || count == mostFiles)
      warnings.push_back(
          {place.string(), "the folder was not searched to its end: " +
                               (fault ? fault.message() : std::string("it holds too many files"))});
  }
  return found;
}

/// Holds the structures that came from one state of one file.
struct Origin {
  std::string file;
  Fingerprint fingerprint;
  std::vector<std::size_t> nodes;  ///< in Scene::nodes
  std::string shown = file;        ///< the name of the file that was found, else what is known
};

std::vector<Origin> originsOf(const Scene& scene) {
  std::vector<Origin> origins;
  for (std::size_t i = 0; i < scene.nodes().size(); ++i) {
    const Node& node = scene.nodes()[i];
    const Provenance& from = node.provenance;
    if (node.isGroup() || from.file.empty() || !from.fingerprint)
      continue;
    const auto known = std::find_if(origins.begin(), origins.end(), [&](const Origin& o) {
      return o.file == from.file && o.fingerprint == *from.fingerprint;
    });
    if (known != origins.end())
      known->nodes.push_back(i);
    else
      origins.push_back({from.file, *from.fingerprint, {i}, from.file});
  }
  std::stable_sort(origins.begin(), origins.end(),
                   [](const Origin& a, const Origin& b) { return a.file < b.file; });
  return origins;
}

/// Returns the index of the file's surface that has the name or the mark (file_marks.h).
std::optional<std::size_t> partNamed(const std::vector<std::string>& parts,
                                     const std::string& wanted) {
  if (wanted.empty())
    return parts.size() == 1 ? std::optional<std::size_t>(0) : std::nullopt;
  const auto found = std::find_if(parts.begin(), parts.end(), [&wanted](const std::string& part) {
    return part == wanted || partMark(part) == wanted;
  });
  if (found == parts.end())
    return std::nullopt;
  return std::size_t(found - parts.begin());
}

/// Describes a file as it is now.
struct FileNow {
  Fingerprint fingerprint;
  const std::vector<RawMesh>& meshes;
  std::vector<std::string> parts;  ///< the names of the meshes
};

/// Applies to a surface the steps that the import did to it before.
Result<MeshPtr> repeatImport(RawMesh raw, Provenance& as, const ReadOptions& options) {
  if (raw.molecule)
    return Error{.reason = "a molecule may have been laid over another one; import both again"};
  as.repairedFaces = repair(raw.positions, raw.triangles).faces();
  if (raw.triangles.empty())
    return Error{.reason = "it has no face with area any more"};
  const std::optional<ReadExtent> before = extentAsRead(raw, as);
  float displacement = raw.displacement;
  const float sliceMm = raw.smooth ? raw.sliceDistance * as.mmPerUnit : as.sliceMm;
  if (!raw.smooth) {
    // The automatic mode, which looks for the grid of a label map, takes just as many steps.
    const bool automatic = as.smoothingSteps == SincFilter().iterations;
    const VoxelGrid grid =
        automatic ? commonGrids(std::array{measureSurface(raw.positions, raw.triangles)}).front()
                  : VoxelGrid();
    const Smoothed smoothed =
        smooth(raw.positions, raw.triangles, grid, {Smoothing::Mode::steps, as.smoothingSteps}, 0);
    // Without a grid the automatic mode refines alone.
    const Smoothed refined =
        smooth(raw.positions, raw.triangles, {}, {Smoothing::Mode::automatic}, as.refinementSteps);
    as.refinementSteps = refined.refinementSteps;
    displacement = smoothed.displacement + refined.displacement;
  }
  as.displacementMm = displacement * as.mmPerUnit;
  const bool known = !raw.smooth;
  as.sliceMm = sliceMm;
  Result<MeshPtr> mesh = placedMesh(std::move(raw), as);
  if (known)
    as.sliceMm = sliceMm;  // in millimetres of the scene already
  if (!mesh)
    return mesh;
  // As many triangles are removed as before, within the bound of the earlier decimation.
  if (as.decimatedFrom > 0 && as.decimationMm > 0.0f)
    mesh = decimated(*mesh, as.decimationMm, as, options.goesOn);
  as.asRead = isAsRead(as) ? std::nullopt : before;
  return mesh;
}

class Reloader {
 public:
  Reloader(const Scene& scene, const ReadOptions& options, PatientsWanted patients)
      : m_options(options), m_patients(patients), m_nodes(scene.nodes()) {
    m_result.scene = scene;
    m_sorter.add(TracedScene{openSceneName, scene.traces()});
  }

  Reloaded run(std::span<const fs::path> places) {
    compare(places);
    for (std::size_t i = 0; i < m_origins.size() && m_options.goesOn(); ++i)
      if (m_fates[i].fate == Fate::replaced)
        read(m_origins[i], m_fates[i].file, m_fates[i].now);
      else
        tell(m_origins[i], m_fates[i].fate, m_fates[i].reason);
    m_result.changed = !m_result.meshes.empty();
    if (m_result.changed) {
      m_result.scene = withNewMeshes(m_result.scene, m_result.meshes);
      std::vector<SourceTrace> traces = m_result.scene.traces();
      addTraces(traces, newTraces(m_marks, traces));
      m_result.scene.setTraces(std::move(traces));
    }
    return std::move(m_result);
  }

  Patients patients(std::span<const fs::path> places) {
    compare(places);
    for (const Compared& each : m_fates)
      if (each.fate == Fate::replaced)
        m_sorter.add(each.file, patientMarks(each.file, m_options.limits));
    return m_sorter.patients();
  }

 private:
  /// What is to become of the structures of a file; `replaced` where it is to be read again.
  struct Compared {
    Fate fate = Fate::failed;
    std::string reason;
    fs::path file = {};
    Fingerprint now = {};
  };

  /// Finds the files of the scene's structures and what has become of them.
  void compare(std::span<const fs::path> places) {
    std::vector<Origin>& origins = m_origins;
    origins = originsOf(m_result.scene);
    std::set<std::string> names;
    for (const Origin& origin : origins)
      names.insert(origin.file);
    const auto found = filesNamed(names, places, m_result.warnings);
    for (Origin& origin : origins)
      if (const auto candidates = found.find(origin.file); candidates != found.end())
        origin.shown = candidates->second.begin()->filename().string();
    for (const Origin& origin : origins) {
      const auto candidates = found.find(origin.file);
      m_fates.push_back(candidates == found.end()
                            ? Compared{Fate::absent, "no file of this name was found"}
                            : compareFiles(origin, candidates->second, origins));
      // What stays says whose the scene is, as its traces do.
      if (m_fates.back().fate == Fate::unchanged)
        m_sorter.add(m_fates.back().file, patientMarks(m_fates.back().file, m_options.limits));
    }
  }

  void tell(const Origin& origin, Fate fate, std::string reason = {}) {
    ReloadedFile line{origin.shown, fate, std::move(reason), {}};
    for (const std::size_t i : origin.nodes)
      line.structures.push_back(m_nodes[i].id);
    m_result.files.push_back(std::move(line));
  }

  Compared compareFiles(const Origin& origin, const std::set<fs::path>& files,
                        const std::vector<Origin>& origins) const {
    std::vector<std::pair<fs::path, Fingerprint>> changed;
    std::optional<Compared> unchanged;
    for (const fs::path& file : files) {
      const Result<Fingerprint> now = fingerprintOfFile(file);
      if (!now)
        return {Fate::failed, now.error().reason};
      if (*now == origin.fingerprint) {
        unchanged = {Fate::unchanged, {}, file, *now};
        continue;
      }
      // A file from which another structure of the same file name came is not meant.
      const bool another = std::any_of(origins.begin(), origins.end(), [&](const Origin& o) {
        return o.file == origin.file && o.fingerprint == *now;
      });
      if (!another)
        changed.emplace_back(file, *now);
    }
    if (unchanged && !changed.empty())
      unchanged->reason = otherOfThisName;
    if (unchanged)
      return *unchanged;
    if (changed.empty())
      return {Fate::absent, "only files that other structures came from were found"};
    const auto rivals = std::count_if(origins.begin(), origins.end(),
                                      [&](const Origin& o) { return o.file == origin.file; });
    if (changed.size() > 1 || rivals > 1)
      return {Fate::failed,
              changed.size() > 1
                  ? "there are " + std::to_string(changed.size()) +
                        " files of this name; name the folder of the one that is meant"
                  : "structures from several files of this name are in the scene"};
    return {Fate::replaced, {}, changed.front().first, changed.front().second};
  }

  /// Tells whether the file is of the same patient as those before it, which it then joins.
  bool isOfThePatient(const fs::path& file) {
    PatientSorter with = m_sorter;
    const std::vector<PatientMarks> marks = patientMarks(file, m_options.limits);
    with.add(file, marks);
    // A scene may be of several on purpose: then another one more is not.
    if (m_patients != PatientsWanted::together &&
        with.patients().apart.size() > m_sorter.patients().apart.size())
      return false;
    m_sorter = std::move(with);
    m_marks.insert(m_marks.end(), marks.begin(), marks.end());
    return true;
  }

  /// Returns the smoothing that readers which smooth were told to do: none where nothing moved.
  Smoothing readersSmoothing(const Origin& origin) const {
    float moved = 0.0f;
    int steps = 0;
    for (const std::size_t i : origin.nodes) {
      moved = std::max(moved, m_nodes[i].provenance.displacementMm);
      steps = std::max(steps, m_nodes[i].provenance.smoothingSteps);
    }
    if (moved == 0.0f)
      return {Smoothing::Mode::off};
    return steps > 0 ? Smoothing{Smoothing::Mode::steps, steps} : Smoothing{};
  }

  /// Returns the thresholds by which structures were made of a scan, to make them again.
  std::vector<Threshold> thresholdsOf(const Origin& origin) const {
    std::vector<Threshold> thresholds;
    for (const std::size_t i : origin.nodes)
      if (const auto& range = m_nodes[i].provenance.intensities)
        thresholds.push_back({m_nodes[i].provenance.part, range->low, range->high});
    return thresholds;
  }

  void read(const Origin& origin, const fs::path& file, const Fingerprint& now) {
    if (!isOfThePatient(file))
      return tell(origin, Fate::failed, otherPatientNow);
    ReadOptions options = m_options;
    options.smoothing = readersSmoothing(origin);
    options.thresholds = thresholdsOf(origin);
    Result<RawMeshes> read = readSurfaces(file, options);
    if (!read) {
      Error error = read.error();
      error.file.clear();
      return tell(origin, Fate::failed, error.text());
    }
    for (ImportWarning& warning : read->warnings)
      m_result.warnings.push_back({origin.shown, std::move(warning.reason)});
    const FileNow contents{now, read->meshes, partNames(read->meshes)};
    const std::vector<std::string>& parts = contents.parts;
    std::vector<bool> taken(parts.size(), false);
    for (const std::size_t i : origin.nodes)
      replace(i, origin, contents, taken);
    std::string others;
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (!taken[k])
        others += (others.empty() ? "" : ", ") + parts[k];
    if (!others.empty())
      m_result.warnings.push_back(
          {origin.shown, "no structure of the scene came from these of its surfaces: " + others});
  }

  void replace(std::size_t index, const Origin& origin, const FileNow& file,
               std::vector<bool>& taken) {
    const Node& node = m_nodes[index];
    const Origin alone{origin.file, origin.fingerprint, {index}, origin.shown};
    const std::string& wanted = node.provenance.part;
    const std::optional<std::size_t> k = partNamed(file.parts, wanted);
    if (!k)
      return tell(alone, Fate::failed,
                  wanted.empty()
                      ? "it holds " + std::to_string(file.parts.size()) +
                            " surfaces now, and it is not known which is meant"
                      : "it holds no surface \"" + (wanted.starts_with('#') ? node.name : wanted) +
                            "\" any more");
    taken[*k] = true;
    Provenance as = node.provenance;
    as.fingerprint = file.fingerprint;
    Result<MeshPtr> mesh = repeatImport(file.meshes[*k], as, m_options);
    if (!mesh)
      return tell(alone, Fate::failed, mesh.error().reason);
    doubtOtherSize(node, **mesh, origin.shown, as);
    PaintPtr paint = repainted(node, *mesh, origin.shown);
    m_result.meshes.push_back({.structure = node.id,
                               .before = node.mesh,
                               .mesh = std::move(*mesh),
                               .provenance = std::move(as),
                               .paintBefore = node.paint,
                               .paint = std::move(paint)});
    tell(alone, Fate::replaced);
  }

  /// Warns where the new surface is of another size or lies elsewhere than the one before, as one
  /// of another unit, another body or another organ does.
  void doubtOtherSize(const Node& node, const Mesh& now, const std::string& file, Provenance& as) {
    constexpr float otherUnit = 4.0f;
    const Box before = node.mesh->bounds();
    const Box after = now.bounds();
    const float was = glm::length(before.size());
    const float is = glm::length(after.size());
    const auto length = [](float mm) { return toldLength(double(mm), DrawnUnit::millimetre); };
    if (is > otherUnit * was || was > otherUnit * is) {
      as.unitEvidence = Evidence::conflict;
      m_result.warnings.push_back({file, "\"" + node.name + "\" is " + length(is) +
                                             " large now and was " + length(was) +
                                             ": its file may have another unit"});
    } else if (const float gap = glm::length(glm::max(
                   glm::max(before.low - after.high, after.low - before.high), glm::vec3(0.0f)));
               gap > 0.0f) {
      m_result.warnings.push_back(
          {file, "\"" + node.name + "\" lies " + length(gap) +
                     " away from where it was: it may be another body's, or "
                     "mirrored"});
    }
  }

  /// Returns what is painted on the structure, on its new mesh.
  PaintPtr repainted(const Node& node, const MeshPtr& mesh, const std::string& file) {
    if (!node.paint)
      return nullptr;
    CarriedPaint carried = carriedPaint(node.mesh, *node.paint, mesh);
    if (carried.lost > muchPaint)
      m_result.warnings.push_back(
          {file, std::to_string(std::lround(100.0f * carried.lost)) +
                     " % of what was painted on it is lost: the new surface does not reach there"});
    return std::move(carried.paint);
  }

  const ReadOptions& m_options;
  PatientsWanted m_patients;
  const std::vector<Node>& m_nodes;
  std::vector<Origin> m_origins;
  std::vector<Compared> m_fates;  ///< of the origins
  PatientSorter m_sorter;
  std::vector<PatientMarks> m_marks;  ///< of what was read
  Reloaded m_result;
};

}  // namespace

Scene withNewMeshes(const Scene& scene, std::span<const NewMesh> meshes) {
  std::map<NodeId, const NewMesh*> changes;
  for (const NewMesh& change : meshes)
    if (const Node* node = scene.find(change.structure); node && node->mesh == change.before)
      changes[change.structure] = &change;
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes)
    if (const auto found = changes.find(node.id); found != changes.end()) {
      const NewMesh& now = *found->second;
      // What was painted while the files were read is carried over, too.
      if (node.paint == now.paintBefore)
        node.paint = now.paint;
      else if (node.paint)
        node.paint = carriedPaint(node.mesh, *node.paint, now.mesh).paint;
      node.mesh = now.mesh;
      node.provenance = found->second->provenance;
    }
  std::vector<Annotation> annotations = scene.annotations();
  for (Annotation& annotation : annotations)
    for (Anchor& anchor : annotation.anchors) {
      const auto* point = std::get_if<SurfacePoint>(&anchor);
      const auto place = scene.placeOf(anchor);
      const auto found = point ? changes.find(point->structure) : changes.end();
      if (!place || found == changes.end())
        continue;
      if (const auto nearest = nearestPoint(*found->second->mesh, *place))
        anchor = SurfacePoint{point->structure, nearest->triangle, nearest->weights};
    }
  Scene after = scene;
  after.setNodes(std::move(nodes));
  after.setAnnotations(std::move(annotations));
  return after;
}

Reloaded reload(const Scene& scene, std::span<const fs::path> places, const ReadOptions& options,
                PatientsWanted patients) {
  Reloaded reloaded = Reloader(scene, options, patients).run(places);
  std::vector<SceneMending> mended;
  // As many structures as before cannot be too many.
  static_cast<void>(bringWithinLimits(reloaded.scene, mended));
  for (const SceneMending& each : mended)
    reloaded.warnings.push_back({each.where, each.fault + "; " + each.done});
  for (NewMesh& change : reloaded.meshes)
    change.provenance = reloaded.scene.find(change.structure)->provenance;
  return reloaded;
}

Patients patientsToReload(const Scene& scene, std::span<const fs::path> places,
                          const ReadOptions& options) {
  return Reloader(scene, options, PatientsWanted::one).patients(places);
}

}  // namespace sline::model
