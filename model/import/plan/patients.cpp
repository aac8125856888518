// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/patients.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "model/import/plan/named_bodies.h"
#include "model/scene_file/scene_file.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

/// Returns "a.dcm, b.dcm and 12 more".
std::string filesText(const std::vector<fs::path>& files) {
  constexpr std::size_t mostTold = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(files.size(), mostTold); ++i)
    text += (i == 0 ? "" : ", ") + files[i].string();
  if (files.size() > mostTold)
    text += " and " + std::to_string(files.size() - mostTold) + " more";
  return text;
}

/// What one file, as it was named, says.
struct FoundMarks {
  fs::path file;
  std::vector<PatientMarks> marks;
};

std::vector<FoundMarks> marksIn(const Sources& sources, const ReadLimits& limits) {
  std::vector<FoundMarks> found;
  for (const ImportSource& source : sources.sources)
    if (source.kind == ImportSource::Kind::slicer)
      found.push_back(
          {source.path, patientMarks(source.bundle ? source.bundle->scene : source.path, limits)});
  for (const SourceFile& file : sources.files) {
    const ImportSource& source = sources.sources[file.source];
    found.push_back({source.bundle ? source.path : file.file, patientMarks(file.file, limits)});
    for (const fs::path& other : file.together)
      found.push_back({other, patientMarks(other, limits)});
  }
  return found;
}

PatientSorter sorterOf(const std::vector<FoundMarks>& found, const Scene* into,
                       const std::vector<TracedScene>& scenes) {
  PatientSorter sorter;
  if (into)
    sorter.add({openSceneName, into->traces()});
  for (const TracedScene& scene : scenes)
    sorter.add(scene);
  for (const FoundMarks& each : found)
    sorter.add(each.file, each.marks);
  return sorter;
}

/// Returns whose the files are, by what they say or, where they say nothing, by their names.
Patients patientsOf(const Sources& sources, const std::vector<FoundMarks>& found, const Scene* into,
                    const std::vector<TracedScene>& scenes) {
  Patients patients = sorterOf(found, into, scenes).patients();
  if (patients.several())
    return patients;
  std::set<fs::path> marked;
  for (const FoundMarks& each : found)
    if (!each.marks.empty())
      marked.insert(each.file);
  patients.apart = bodiesByName(sources, marked);
  patients.byName = patients.several();
  return patients;
}

/// Leaves out the files, and scenes that are called so.
void leaveOut(Sources& sources, const std::set<fs::path>& others) {
  const auto isOther = [&others](const fs::path& file) { return others.contains(file); };
  const auto warn = [&sources](const fs::path& file) {
    sources.warnings.push_back({file.string(), otherPatient});
  };
  for (ImportSource& source : sources.sources)
    if (source.scene && isOther(source.path)) {
      source.scene->fiducials.clear();
      warn(source.path);
    }
  std::vector<SourceFile> kept;
  for (SourceFile& file : sources.files) {
    const ImportSource& source = sources.sources[file.source];
    if (source.scene && (isOther(source.path) || isOther(file.file)))
      continue;
    std::vector<fs::path> all = std::move(file.together);
    all.insert(all.begin(), file.file);
    std::for_each(all.begin(), all.end(), [&](const fs::path& each) {
      if (isOther(each))
        warn(each);
    });
    std::erase_if(all, isOther);
    if (all.empty())
      continue;
    file.file = all.front();
    file.together.assign(std::next(all.begin()), all.end());
    kept.push_back(std::move(file));
  }
  sources.files = std::move(kept);
}

}  // namespace

/// What marks say of each other, the gravest last.
enum class PatientSorter::Kinship : std::uint8_t { unknown, same, perhapsApart, apart };

PatientSorter::Kinship PatientSorter::kinshipOf(const Marked& one, const Marked& other) const {
  const auto compared = [](const auto& a, const auto& b, Kinship otherwise) {
    return !a || !b ? Kinship::unknown : *a == *b ? Kinship::same : otherwise;
  };
  if (!one.traces.empty() && !other.traces.empty()) {
    // Under different salts nothing can be compared.
    const auto isShared = [&other](const SourceTrace& trace) {
      return std::any_of(other.traces.begin(), other.traces.end(), [&trace](const SourceTrace& b) {
        return b.salt == trace.salt && b.study == trace.study && b.frame == trace.frame;
      });
    };
    return std::any_of(one.traces.begin(), one.traces.end(), isShared) ? Kinship::same
                                                                       : Kinship::perhapsApart;
  }
  if (!one.traces.empty())
    return kinshipWithScene(other.marks, one.traces);
  if (!other.traces.empty())
    return kinshipWithScene(one.marks, other.traces);
  const PatientMarks& a = one.marks;
  const PatientMarks& b = other.marks;
  const Kinship person =
      std::max({compared(a.id, b.id, Kinship::apart), compared(a.name, b.name, Kinship::apart),
                compared(a.subject, b.subject, Kinship::apart)});
  if (person != Kinship::unknown)
    return person;
  // Nobody is named in both: two studies may be of two bodies.
  const Kinship study = compared(a.study, b.study, Kinship::perhapsApart);
  return study != Kinship::unknown ? study : compared(a.frame, b.frame, Kinship::perhapsApart);
}

PatientSorter::Kinship PatientSorter::kinshipWithScene(
    const PatientMarks& marks, const std::vector<SourceTrace>& traces) const {
  Kinship kinship = Kinship::unknown;
  for (const SourceTrace& trace : traces) {
    const std::optional<SourceTrace> own = m_maker.traceOf(marks, trace.salt);
    if (!own)
      return Kinship::unknown;
    const bool study = !own->study.empty() && !trace.study.empty();
    const bool frame = !own->frame.empty() && !trace.frame.empty();
    if (!study && !frame)
      continue;
    if (study ? own->study == trace.study : own->frame == trace.frame)
      return Kinship::same;
    kinship = Kinship::perhapsApart;
  }
  return kinship;
}

bool PatientSorter::haveOtherFrames(const Marked& a, const Marked& b) const {
  if (a.traces.empty() && b.traces.empty())
    return a.marks.frame && b.marks.frame && a.marks.frame != b.marks.frame;
  const std::vector<SourceTrace>& traces = a.traces.empty() ? b.traces : a.traces;
  const PatientMarks& marks = a.traces.empty() ? a.marks : b.marks;
  bool other = false;
  for (const SourceTrace& trace : traces) {
    const std::optional<SourceTrace> own = m_maker.traceOf(marks, trace.salt);
    if (!own || own->frame.empty() || own->frame == trace.frame)
      return false;
    other = other || !trace.frame.empty();
  }
  return other;
}

Error Patients::error() const {
  std::string lists;
  for (const PatientFiles& one : apart)
    lists += (lists.empty() ? "" : "; ") + filesText(one.files);
  const std::string number = std::to_string(apart.size());
  return {.reason = (byName    ? "the names of the files tell of " + number + " bodies: "
                     : certain ? "the files are of " + number + " patients: "
                               : "the files are of " + number +
                                     " studies, and nothing says that they are of one patient: ") +
                    lists,
          .remedy = "Give the files of one patient, or put them together on purpose"};
}

void PatientSorter::add(const fs::path& file, std::span<const PatientMarks> marks) {
  for (const PatientMarks& each : marks) {
    const auto known = std::find_if(m_known.begin(), m_known.end(), [&each](const Marked& one) {
      return one.traces.empty() && one.marks == each;
    });
    Marked& to = known == m_known.end() ? m_known.emplace_back(Marked{.marks = each}) : *known;
    if (to.files.empty() || to.files.back() != file)
      to.files.push_back(file);
  }
}

void PatientSorter::add(const TracedScene& scene) {
  if (!scene.traces.empty())
    m_known.push_back({.traces = scene.traces, .files = {scene.file}});
}

std::vector<PatientSorter::Group> PatientSorter::groups() const {
  const auto anyKin = [this](const Group& a, const Group& b, Kinship kinship) {
    return std::any_of(a.begin(), a.end(), [&](const Marked* one) {
      return std::any_of(b.begin(), b.end(),
                         [&](const Marked* other) { return kinshipOf(*one, *other) == kinship; });
    });
  };
  std::vector<Group> groups;
  for (const Marked& marked : m_known) {
    // What belongs to several groups shows that they are one, unless something sets them apart.
    Group own{&marked};
    auto place = groups.end();
    for (auto group = groups.begin(); group != groups.end();) {
      const bool joins = anyKin(own, *group, Kinship::same) && !anyKin(own, *group, Kinship::apart);
      if (joins && place == groups.end()) {
        own.insert(own.begin(), group->begin(), group->end());
        place = group++;
      } else if (joins) {
        own.insert(own.end(), group->begin(), group->end());
        group = groups.erase(group);
      } else {
        ++group;
      }
    }
    if (place == groups.end())
      groups.push_back(std::move(own));
    else
      *place = std::move(own);
  }
  return groups;
}

Patients PatientSorter::patients() const {
  Patients found;
  const std::vector<Group> all = groups();
  std::set<std::size_t> apart;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < all.size(); ++j)
      for (const Marked* a : all[i])
        for (const Marked* b : all[j]) {
          const Kinship kin = kinshipOf(*a, *b);
          if (i != j && kin >= Kinship::perhapsApart)
            apart.insert({i, j});
          found.certain = found.certain || (i != j && kin == Kinship::apart);
          found.framesDiffer = found.framesDiffer || (i == j && haveOtherFrames(*a, *b));
        }
  for (const std::size_t i : apart) {
    PatientFiles& files = found.apart.emplace_back();
    for (const Marked* marked : all[i])
      files.files.insert(files.files.end(), marked->files.begin(), marked->files.end());
  }
  return found;
}

Result<std::vector<SourceTrace>> admitPatients(Sources& sources,
                                               const std::vector<TracedScene>& scenes,
                                               const ImportOptions& options) {
  std::vector<FoundMarks> found = marksIn(sources, options.limits);
  const Patients patients = patientsOf(sources, found, options.into.get(), scenes);
  if (patients.several() && options.patients == PatientsWanted::one)
    return patients.error();
  if (patients.several() && options.patients == PatientsWanted::first) {
    std::set<fs::path> others;
    for (std::size_t i = 1; i < patients.apart.size(); ++i)
      others.insert(patients.apart[i].files.begin(), patients.apart[i].files.end());
    for (const fs::path& file : patients.apart.front().files)
      others.erase(file);
    leaveOut(sources, others);
    std::erase_if(found, [&others](const FoundMarks& each) { return others.contains(each.file); });
  }
  if (patients.framesDiffer)
    sources.warnings.push_back(
        {"",
         "files of one patient lie in different frames of reference: nothing says that what is "
         "laid over each other fits"});
  std::vector<PatientMarks> marks;
  for (const FoundMarks& each : found)
    marks.insert(marks.end(), each.marks.begin(), each.marks.end());
  std::vector<SourceTrace> there =
      options.into ? options.into->traces() : std::vector<SourceTrace>();
  for (const TracedScene& scene : scenes)
    addTraces(there, scene.traces);
  return newTraces(marks, there);
}

Patients patientsAmong(std::span<const fs::path> inputs, const ReadLimits& limits,
                       ScannerSlices slices, const Scene* into) {
  std::vector<fs::path> meshes;
  std::vector<TracedScene> scenes;
  for (const fs::path& input : inputs)
    if (!isSceneFile(input))
      meshes.push_back(input);
    else if (into || inputs.size() > 1)
      if (const auto document = readSceneFile(input))
        scenes.push_back({input, document->scene.traces()});
  std::error_code ignored;
  const bool lone = !into && scenes.empty() && meshes.size() < 2 &&
                    std::none_of(meshes.begin(), meshes.end(), [&ignored](const fs::path& input) {
                      return fs::is_directory(input, ignored) || input.extension() == ".mrml" ||
                             input.extension() == ".mrb";
                    });
  if (lone)
    return {};
  const Sources sources = collectSources(meshes, limits, slices);
  return patientsOf(sources, marksIn(sources, limits), into, scenes);
}

}  // namespace sline::model
