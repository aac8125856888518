// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/patients.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "model/scene_file/scene_file.h"

namespace sline::model {

namespace {

namespace fs = std::filesystem;

/// What two files' marks say of each other, the gravest last.
enum class Kinship { unknown, same, perhapsApart, apart };

template <class Mark>
Kinship compared(const Mark& a, const Mark& b, Kinship otherwise) {
  return !a || !b ? Kinship::unknown : *a == *b ? Kinship::same : otherwise;
}

Kinship kinshipOf(const PatientMarks& a, const PatientMarks& b) {
  const Kinship person =
      std::max({compared(a.id, b.id, Kinship::apart), compared(a.name, b.name, Kinship::apart),
                compared(a.subject, b.subject, Kinship::apart)});
  if (person != Kinship::unknown)
    return person;
  // Nobody is named in both: two studies may be of two bodies.
  const Kinship study = compared(a.study, b.study, Kinship::perhapsApart);
  return study != Kinship::unknown ? study : compared(a.frame, b.frame, Kinship::perhapsApart);
}

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

PatientSorter sorterOf(const Sources& sources, const ReadLimits& limits) {
  PatientSorter sorter;
  for (const ImportSource& source : sources.sources)
    if (source.kind == ImportSource::Kind::slicer)
      sorter.add(source.path,
                 patientMarks(source.bundle ? source.bundle->scene : source.path, limits));
  for (const SourceFile& file : sources.files) {
    const ImportSource& source = sources.sources[file.source];
    sorter.add(source.bundle ? source.path : file.file, patientMarks(file.file, limits));
    for (const fs::path& other : file.together)
      sorter.add(other, patientMarks(other, limits));
  }
  return sorter;
}

/// Leaves out the files, and scenes that are called so.
void leaveOut(Sources& sources, const std::set<fs::path>& others) {
  const auto isOther = [&others](const fs::path& file) { return others.contains(file); };
  const auto warn = [&sources](const fs::path& file) {
    sources.warnings.push_back(
        {file.string(), "is of another patient than the files before it; left out"});
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

Error Patients::error() const {
  std::string lists;
  for (const PatientFiles& one : apart)
    lists += (lists.empty() ? "" : "; ") + filesText(one.files);
  return {.reason = (certain ? "the files are of " + std::to_string(apart.size()) + " patients: "
                             : "the files are of " + std::to_string(apart.size()) +
                                   " studies, and nothing says that they are of one patient: ") +
                    lists,
          .remedy = "Give the files of one patient, or put them together on purpose (--together)"};
}

void PatientSorter::add(const fs::path& file, std::span<const PatientMarks> marks) {
  for (const PatientMarks& each : marks) {
    const auto known = std::find_if(m_known.begin(), m_known.end(),
                                    [&each](const Marked& one) { return one.marks == each; });
    Marked& to = known == m_known.end() ? m_known.emplace_back(Marked{each, {}}) : *known;
    if (to.files.empty() || to.files.back() != file)
      to.files.push_back(file);
  }
}

std::vector<PatientSorter::Group> PatientSorter::groups() const {
  std::vector<Group> groups;
  for (const Marked& marked : m_known) {
    const auto kin = [&marked](const Marked* other) {
      return kinshipOf(marked.marks, other->marks);
    };
    const auto own = std::find_if(groups.begin(), groups.end(), [&kin](const Group& group) {
      return std::any_of(group.begin(), group.end(),
                         [&kin](const Marked* other) { return kin(other) == Kinship::same; }) &&
             std::none_of(group.begin(), group.end(),
                          [&kin](const Marked* other) { return kin(other) == Kinship::apart; });
    });
    if (own == groups.end())
      groups.push_back({&marked});
    else
      own->push_back(&marked);
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
          const Kinship kin = kinshipOf(a->marks, b->marks);
          if (i != j && kin >= Kinship::perhapsApart)
            apart.insert({i, j});
          found.certain = found.certain || (i != j && kin == Kinship::apart);
          found.framesDiffer = found.framesDiffer || (i == j && a->marks.frame && b->marks.frame &&
                                                      a->marks.frame != b->marks.frame);
        }
  for (const std::size_t i : apart) {
    PatientFiles& files = found.apart.emplace_back();
    for (const Marked* marked : all[i])
      files.files.insert(files.files.end(), marked->files.begin(), marked->files.end());
  }
  return found;
}

Status admitPatients(Sources& sources, const ImportOptions& options) {
  const Patients patients = sorterOf(sources, options.limits).patients();
  if (patients.several() && options.patients == PatientsWanted::one)
    return patients.error();
  if (patients.several() && options.patients == PatientsWanted::first) {
    std::set<fs::path> others;
    for (std::size_t i = 1; i < patients.apart.size(); ++i)
      others.insert(patients.apart[i].files.begin(), patients.apart[i].files.end());
    for (const fs::path& file : patients.apart.front().files)
      others.erase(file);
    leaveOut(sources, others);
  }
  if (patients.framesDiffer)
    sources.warnings.push_back(
        {"",
         "files of one patient lie in different frames of reference: nothing says that what is "
         "laid over each other fits"});
  return Unit{};
}

Patients patientsAmong(std::span<const fs::path> inputs, const ReadLimits& limits,
                       ScannerSlices slices) {
  std::vector<fs::path> meshes;
  std::copy_if(inputs.begin(), inputs.end(), std::back_inserter(meshes),
               [](const fs::path& input) { return !isSceneFile(input); });
  std::error_code ignored;
  const bool lone = meshes.size() < 2 &&
                    std::none_of(meshes.begin(), meshes.end(), [&ignored](const fs::path& input) {
                      return fs::is_directory(input, ignored) || input.extension() == ".mrml" ||
                             input.extension() == ".mrb";
                    });
  if (lone)
    return {};
  return sorterOf(collectSources(meshes, limits, slices), limits).patients();
}

}  // namespace sline::model
