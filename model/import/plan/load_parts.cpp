// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/load_parts.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "model/base/letters.h"
#include "model/disk/memory_budget.h"
#include "model/import/credits/source_credit.h"
#include "model/import/kinds/entry_names.h"
#include "model/import/kinds/file_kinds.h"
#include "model/import/naming/file_marks.h"
#include "model/import/naming/laterality.h"
#include "model/import/naming/names.h"
#include "model/import/plan/frame_fit.h"
#include "model/import/volumes/volume_set.h"
#include "model/import/volumes/volume_surfaces.h"
#include "model/import/worker/reading_child.h"
#include "model/meshing/repair.h"
#include "model/scene_file/fingerprint.h"

namespace sline::model {

namespace {

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

/// Holds the data that the surfaces of one file have in common.
struct FileFacts {
  std::optional<Fingerprint> fingerprint;
  int surfaces = 0;
};

/// Returns the facts by the files' names.
std::map<std::string, FileFacts> factsOf(const SourceFile& source,
                                         const std::vector<RawMesh>& meshes) {
  std::map<std::string, FileFacts> facts;
  const auto add = [&facts](const std::filesystem::path& file) {
    if (const Result<Fingerprint> print = fingerprintOfFile(file))
      facts[file.filename().string()].fingerprint = *print;
  };
  // Slices are called after the scanner, not after their files.
  if (!source.slice) {
    add(source.file);
    std::for_each(source.together.begin(), source.together.end(), add);
  }
  const std::string first = source.file.filename().string();
  for (const RawMesh& mesh : meshes)
    ++facts[mesh.file.empty() ? first : mesh.file].surfaces;
  return facts;
}

/// Knows twins: a folder may hold a label volume and the surfaces made of it. A structure that is
/// there as a surface is not taken from the volume as well.
class SurfaceTwins {
 public:
  explicit SurfaceTwins(const Sources& sources) : m_sources(sources) {}

  /// Tells whether what the file holds may be there as a surface, too.
  bool fromVolume(std::size_t file) const {
    const SourceFile& source = m_sources.files[file];
    return m_sources.sources[source.source].kind == ImportSource::Kind::folder &&
           isVolumeFile(source.file);
  }
  void addSurfaces(const std::vector<Part>& parts) {
    for (const Part& part : parts)
      if (!fromVolume(part.file)) {
        const SourceFile& source = m_sources.files[part.file];
        if (!part.name.ends_with(unnamedStructure))
          m_surfaces.insert(key(part.file, part.name));
        m_surfaces.insert(key(part.file, part.given));
        m_silent = m_silent || (!part.raw.frame && !source.model && !source.told);
      }
  }
  /// Tells whether a surface's file does not say its frame, so that a twin shows it.
  bool silent() const { return m_silent; }
  bool holdsSurface(std::size_t file, const std::string& name) const {
    return m_surfaces.contains(key(file, name));
  }
  static ImportWarning leftOut(const std::string& file, std::size_t count) {
    return {file, counted(int(count), "structure", "structures") +
                      " left out that the folder also holds as surfaces"};
  }

 private:
  std::pair<std::size_t, std::string> key(std::size_t file, const std::string& name) const {
    std::string words;
    for (const std::string& word : nameWords(name))
      words += word + ' ';
    return {m_sources.files[file].source, words};
  }

  const Sources& m_sources;
  std::set<std::pair<std::size_t, std::string>> m_surfaces;
  bool m_silent = false;
};

/// Leaves out what of a volume's structures is there as a surface, and keeps where it was.
void leaveOutTwins(LoadedParts& loaded, const SurfaceTwins& twins, const Sources& sources) {
  std::map<std::string, std::size_t> leftOut;
  std::erase_if(loaded.parts, [&](const Part& part) {
    const bool twin = twins.fromVolume(part.file) && twins.holdsSurface(part.file, part.given);
    leftOut[sources.files[part.file].file.filename().string()] += twin;
    if (twin && part.raw.frame)
      loaded.twins.push_back(
          {part.name, sources.files[part.file].source, middleInPatient(part, *part.raw.frame, {})});
    return twin;
  });
  for (const auto& [file, count] : leftOut)
    if (count > 0)
      loaded.warnings.push_back(SurfaceTwins::leftOut(file, count));
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
  const SurfaceTwins* twins = nullptr;  ///< of the surfaces, where these were read before
};

/// Returns what a surface is called whose file's name has nothing to show but perhaps a side.
std::string unnamed(std::string_view stem) {
  const Side side = sidedName(stem).side;
  return side == Side::none   ? std::string(unnamedStructure)
         : side == Side::left ? "left " + std::string(unnamedStructure)
                              : "right " + std::string(unnamedStructure);
}

/// Holds what a structure is called.
struct PartName {
  std::string name;
  std::string given;  ///< before words were left out that may be a person's name
  bool cut = false;   ///< some were
};

/// Returns what of a name may be shown, or all of it.
PartName shownOf(const std::string& name, bool whole) {
  PartName shown{whole ? name : shownFileName(name), name};
  shown.cut = shown.name != name;
  return shown;
}

/// Tells whether the name is only the value of a label volume's voxels, which is no one's.
bool isLabelValue(const RawMesh& raw) {
  constexpr std::string_view word = "label ";
  constexpr std::size_t mostDigits = 10;  // of 32 bits
  return raw.voxelVolume && raw.name.starts_with(word) && raw.name.size() > word.size() &&
         raw.name.size() <= word.size() + mostDigits &&
         std::all_of(raw.name.begin() + std::ptrdiff_t(word.size()), raw.name.end(), isDigit);
}

/// Returns the name of a part of a molecule. What files that are no published entries call chains
/// has been given by somebody, who may have called them after a patient.
PartName moleculePartName(const RawMesh& raw, bool whole) {
  if (whole || (!raw.groups.empty() && isOfEntry(raw.groups.front())))
    return {raw.name, raw.name};
  const std::string shown = shownMoleculePart(raw.name);
  return {shown, raw.name, shown != raw.name};
}

/// Returns the name of a part: what may be shown of that in its file or, where there is none, of
/// the file's name. What files call their parts has been given to patients' parts, too.
PartName partName(const RawMesh& raw, const SourceFile& source, const Sources& sources, bool only,
                  bool keepNames) {
  const std::filesystem::path file =
      raw.file.empty() ? source.file : std::filesystem::path(raw.file);
  const std::string stem = stemOf(file);
  if (raw.molecule && !source.model)
    return moleculePartName(raw, keepNames);
  std::string given = nameInFile(raw.name);
  if (given.empty())
    given = readableName(stem);
  // Who asks for a threshold names what it makes.
  PartName own = shownOf(given, keepNames || raw.threshold || isLabelValue(raw));
  if (own.name.empty())
    own.name = shownFileName(stem);
  if (own.name.empty())
    own.name = unnamed(sidedName(given).side == Side::none ? stem : given);
  if (!source.model)
    return own;
  const SlicerModel& model = sources.sources[source.source].scene->models[*source.model];
  if (model.segments)
    return own;
  PartName ofScene = shownOf(model.name, keepNames);
  if (ofScene.name.empty())
    ofScene.name = own.name;
  else if (!only)
    ofScene = {ofScene.name + " " + own.name, ofScene.given + " " + own.given,
               ofScene.cut || own.cut};
  return ofScene;
}

/// Mends and measures; returns false where no face with area is left.
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

/// Returns as parts the data that was read from a file.
LoadedParts partsFrom(const Sources& sources, std::size_t index, Result<RawMeshes>&& read,
                      const Loading& loading) {
  LoadedParts loaded;
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
  if (read->thereAlready > 0)
    loaded.warnings.push_back(SurfaceTwins::leftOut(shown, read->thereAlready));
  for (RawScan& scan : read->scans)
    loaded.scans.push_back({index, std::move(scan)});
  std::vector<RawMesh>& meshes = read->meshes;
  std::map<std::string, FileFacts> facts = factsOf(source, meshes);
  const std::vector<std::string> names = partNames(meshes);
  // Whose a published entry is, no folder knows that it was put into.
  const bool entry = !meshes.empty() && meshes.front().molecule && isEntryFile(source.file);
  const SourceCredit credit =
      entry ? SourceCredit{.source = entryCitation(source.file)} : creditOf(source.file);
  for (std::size_t i = 0; i < meshes.size() && loading.meter.goesOn(shown); ++i) {
    Part part;
    part.file = index;
    part.surface = names[i];
    PartName name =
        partName(meshes[i], source, sources, meshes.size() == 1, loading.options.keepFileNames);
    part.name = std::move(name.name);
    part.given = std::move(name.given);
    part.nameCut = name.cut;
    part.raw = std::move(meshes[i]);
    part.unit = part.raw.millimetresPerUnit;  // until units are decided
    const std::string& file = part.raw.file.empty() ? shown : part.raw.file;
    part.provenance.file = part.raw.origin.empty() ? file : part.raw.origin;
    // Without its file's name there is nothing to read again by.
    if (part.raw.origin.empty()) {
      part.provenance.fingerprint = facts[file].fingerprint;
      part.provenance.credit = credit;
    }
    if (facts[file].surfaces > 1 || part.raw.threshold)
      part.provenance.part = names[i];
    if (const auto& threshold = part.raw.threshold)
      part.provenance.intensities = rangeOf(*threshold);
    if (prepare(part, shown, loading.options, loaded.warnings))
      loaded.parts.push_back(std::move(part));
  }
  return loaded;
}

/// Leaves out the file's surfaces where memory has no room for them.
void leaveOutTooLarge(LoadedParts& loaded, const SourceFile& source, MemoryBudget& memory) {
  std::uint64_t triangles = 0;
  for (const Part& part : loaded.parts)
    triangles += part.raw.triangles.size();
  if (const Status room = memory.claim(triangles); !room.ok()) {
    loaded.parts.clear();
    loaded.warnings = {{source.file.filename().string(), room.error().text()}};
  }
}

LoadedParts readFile(const Sources& sources, std::size_t index, const Loading& loading) {
  const SourceFile& source = sources.files[index];
  ReadOptions how = readOptions(loading.options, loading.meter, source.file.filename().string());
  if (const SurfaceTwins* twins = loading.twins;
      twins && !twins->silent() && twins->fromVolume(index))
    how.isThere = [twins, index](const std::string& name) {
      return twins->holdsSurface(index, nameInFile(name));
    };
  Result<RawMeshes> read = source.together.empty() && !source.slice ? readSurfaces(source.file, how)
                                                                    : readTogether(source, how);
  return partsFrom(sources, index, std::move(read), loading);
}

}  // namespace

LoadedParts loadFile(const Sources& sources, std::size_t index, const ImportOptions& options,
                     ProgressMeter& meter) {
  return readFile(sources, index, {options, meter});
}

LoadedParts loadScan(const Sources& sources, const ReadScan& scan, const ImportOptions& options,
                     ProgressMeter& meter) {
  ReadOptions how = readOptions(options, meter, scan.raw.file);
  how.keepScans = false;
  return partsFrom(sources, scan.file, scanSurfaces(scan.raw, how), {options, meter});
}

LoadedParts loadParts(const Sources& sources, const ImportOptions& options, ProgressMeter& meter) {
  std::vector<std::size_t> order(sources.files.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  // Large files first, so that none is left to the end while a core waits.
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return sources.files[a].bytes > sources.files[b].bytes;
  });
  std::vector<LoadedParts> loaded(sources.files.size());
  MemoryBudget memory(options.memoryBytes);
  // Volumes come after surfaces, since what is there as a surface need not be made again.
  SurfaceTwins twins(sources);
  const auto volumes = std::stable_partition(order.begin(), order.end(),
                                             [&](std::size_t i) { return !twins.fromVolume(i); });
  const auto load = [&](const std::vector<std::size_t>& files) {
    forFewAtATime(files, meter, [&](std::size_t i) {
      loaded[i] = readFile(sources, i, {options, meter, &twins});
      leaveOutTooLarge(loaded[i], sources.files[i], memory);
      meter.add(double(sources.files[i].bytes) + 1.0, sources.files[i].file.filename().string());
    });
  };
  load({order.begin(), volumes});
  for (const LoadedParts& one : loaded)
    twins.addSurfaces(one.parts);
  load({volumes, order.end()});
  LoadedParts all;
  const auto take = [](auto& to, auto& from) {
    std::move(from.begin(), from.end(), std::back_inserter(to));
  };
  for (LoadedParts& one : loaded) {
    take(all.parts, one.parts);
    take(all.scans, one.scans);
    take(all.warnings, one.warnings);
    take(all.notes, one.notes);
  }
  leaveOutTwins(all, twins, sources);
  numberParts(all.parts);
  return all;
}

void numberParts(std::vector<Part>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i].number = i;
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

}  // namespace sline::model
