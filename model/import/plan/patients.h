// SPDX-License-Identifier: Apache-2.0
// Keeps patients apart: files that come together become one scene only where they are of one body,
// or somebody says that they belong together.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "model/import/plan/import.h"
#include "model/import/plan/patient_marks.h"
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
  /// Files of one patient lie in several frames of reference.
  bool framesDiffer = false;

  bool several() const { return !apart.empty(); }
  /// Returns the error of an import that does not say what to do with them.
  Error error() const;
};

/// Tells patients apart by what was found in files.
class PatientSorter {
 public:
  void add(const std::filesystem::path& file, std::span<const PatientMarks> marks);
  Patients patients() const;

 private:
  struct Marked {
    PatientMarks marks;
    std::vector<std::filesystem::path> files;
  };
  using Group = std::vector<const Marked*>;
  std::vector<Group> groups() const;

  std::vector<Marked> m_known;  ///< each different one once, in the order in which they came
};

/// Lets in what the options allow: refuses the sources, or leaves out what is of another patient
/// than the first, or does neither; warns of what was left out and of frames of reference that
/// differ.
Status admitPatients(Sources& sources, const ImportOptions& options);

/// Reads the beginnings of all files among the inputs. A lone file is of one patient; scene files
/// do not say whose they are.
Patients patientsAmong(std::span<const std::filesystem::path> inputs, const ReadLimits& limits,
                       ScannerSlices slices);

}  // namespace sline::model
