// SPDX-License-Identifier: Apache-2.0
// Keeps patients apart: files that come together become one scene only where they are of one body,
// or somebody says that they belong together.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/import/plan/import.h"
#include "model/import/plan/patient_marks.h"
#include "model/import/plan/source_traces.h"
#include "model/import/plan/sources.h"

namespace sline::model {

/// Holds files that are of one patient, as far as they say.
struct PatientFiles {
  std::vector<std::filesystem::path> files;  ///< as they were named
  bool operator==(const PatientFiles&) const = default;
};

/// Holds whose files come together: nothing where they may all be of one.
struct Patients {
  std::vector<PatientFiles> apart;  ///< two or more, in the order of the files
  bool certain = false;  ///< false: their studies differ, and nothing tells whose they are
  bool byName = false;   ///< nothing but names of files and folders tells them apart
  /// Files of one patient lie in several frames of reference.
  bool framesDiffer = false;

  bool several() const { return !apart.empty(); }
  /// Returns the error of an import that does not say what to do with them.
  Error error() const;
};

/// What is said of a file that is left out for it.
inline constexpr const char* otherPatient =
    "is of another patient than the files before it; left out";

/// What stands for the file of the scene that files are put into.
inline constexpr const char* openSceneName = "the open scene";

/// Holds what a scene knows of whose it is.
struct TracedScene {
  std::filesystem::path file;
  std::vector<SourceTrace> traces;
};

/// Tells patients apart by what was found in files.
class PatientSorter {
 public:
  void add(const std::filesystem::path& file, std::span<const PatientMarks> marks);
  /// Adds a scene, which is of one patient or was put together on purpose.
  void add(const TracedScene& scene);
  Patients patients() const;

 private:
  /// What was found: marks in files, or the traces of a scene.
  struct Marked {
    PatientMarks marks = {};
    std::vector<SourceTrace> traces = {};
    std::vector<std::filesystem::path> files = {};
  };
  enum class Kinship : std::uint8_t;
  Kinship kinshipOf(const Marked& a, const Marked& b) const;
  Kinship kinshipWithScene(const PatientMarks& marks, const std::vector<SourceTrace>& traces) const;
  bool haveOtherFrames(const Marked& a, const Marked& b) const;
  using Group = std::vector<const Marked*>;
  std::vector<Group> groups() const;

  std::vector<Marked> m_known;  ///< each different one once, in the order in which they came
  mutable TraceMaker m_maker;
};

/// Lets in what the options allow beside the scenes and the open one: refuses the sources, or
/// leaves out what is of another patient than the first, or does neither; warns of what was left
/// out and of frames of reference that differ. Returns the traces of what was let in.
Result<std::vector<SourceTrace>> admitPatients(Sources& sources,
                                               const std::vector<TracedScene>& scenes,
                                               const ImportOptions& options);

/// Reads the beginnings of all files among the inputs, scene files whole where they are not alone,
/// and compares them with each other and with the scene that they go into, if there is one. A lone
/// file is of one patient.
Patients patientsAmong(std::span<const std::filesystem::path> inputs, const ReadLimits& limits,
                       ScannerSlices slices, const Scene* into = nullptr);

}  // namespace sline::model
