// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/dicom_left_out.h"

#include <algorithm>
#include <cctype>

#include "model/import/kinds/file_kinds.h"
#include "model/import/readers/dicom_kind.h"

namespace sline::model {

bool DicomLeftOut::takes(const std::filesystem::path& file) {
  if (!isDicomFile(file))
    return false;
  const std::string kind = sopClassOf(file);
  const std::string_view name = objectName(kind);
  if (name.empty() || holdsStructures(kind))
    return false;
  ++m_kinds[std::string(name)];
  ++m_count;
  return true;
}

std::string DicomLeftOut::text() const {
  std::string list;
  std::size_t i = 0;
  for (const auto& [name, count] : m_kinds) {
    list += i == 0 ? "" : i + 1 < m_kinds.size() ? ", " : " and ";
    list += std::to_string(count) + " " + name + (count == 1 ? "" : "s");
    ++i;
  }
  return list + (m_count == 1 ? " holds no segmentation" : " hold no segmentation");
}

std::string DicomLeftOut::remedy() {
  return "Structures come from a DICOM segmentation or RT structure set, from label maps and "
         "meshes made of the images, or from a threshold";
}

}  // namespace sline::model
