// SPDX-License-Identifier: Apache-2.0
// Reports the DICOM objects of a folder that hold no structures together, because hundreds of
// slices lie beside one segmentation.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "model/import/source/raw_mesh.h"

namespace sline::model {

class DicomLeftOut {
 public:
  /// Returns true for a DICOM object of a kind that is known to hold no structures, and counts it.
  /// Reads the first kilobytes of files that are called like DICOM files.
  bool takes(const std::filesystem::path& file);
  bool empty() const { return m_count == 0; }
  std::size_t count() const { return m_count; }
  /// Returns "400 CT images and 1 RT plan hold no segmentation".
  std::string text() const;
  static std::string remedy();

 private:
  std::map<std::string, std::size_t> m_kinds;
  std::size_t m_count = 0;
};

}  // namespace sline::model
