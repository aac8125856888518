// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/dicom.h"

#include "model/import/dicom/dicom_file.h"
#include "model/import/dicom/structure_set.h"

namespace sline::model {

Result<RawMeshes> readDicom(const std::filesystem::path& file, const ReadOptions& options) {
  const Result<DicomFile> dicom = DicomFile::read(file, options.limits);
  if (!dicom)
    return dicom.error();
  const std::string_view kind = dicom->sopClass();
  if (kind == structureSetClass)
    return structureSetSurfaces(*dicom, options);
  const std::string_view name = objectName(kind);
  const std::string what =
      name.empty() ? "an object of a kind not known here" : "" + std::string(name);
  return dicom->source().whole("holds no segmentation: it is DICOM, " + what,
                               "Give the segmentation or structure set made from it");
}

}  // namespace sline::model
