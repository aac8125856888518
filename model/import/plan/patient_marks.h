// SPDX-License-Identifier: Apache-2.0
// Finds what a file says of whose it is, as checksums: enough to tell equal from different, and
// nothing that could be shown, or travel with a scene (but for traces of study and frame of
// reference, source_traces.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "model/import/source/read_options.h"

namespace sline::model {

/// Members are set where the file says something; words that stand for nobody ("anonymous") count
/// as nothing.
struct PatientMarks {
  std::optional<std::uint64_t> id;
  std::optional<std::uint64_t> name;
  std::optional<std::uint64_t> subject;  ///< of a collection: "sub-01" (BIDS)
  std::optional<std::uint64_t> study;
  std::optional<std::uint64_t> frame;  ///< the frame of reference of its coordinates

  bool any() const { return id || name || subject || study || frame; }
  auto operator<=>(const PatientMarks&) const = default;
};

/// Reads no more of the file than tells: DICOM's patient, study and frame of reference; the like
/// among the keys of NRRD and MetaImage and in JSON beside NIfTI; the patient of Analyze and MINC;
/// patients of 3D Slicer's scenes, of which there may be several; BIDS in the path.
std::vector<PatientMarks> patientMarks(const std::filesystem::path& file, const ReadLimits& limits);

}  // namespace sline::model
