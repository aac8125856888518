// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/dicom.h"

#include "model/import/dicom/dicom_file.h"
#include "model/import/dicom/segmentation.h"
#include "model/import/dicom/structure_set.h"

namespace sline::model {

Result<RawMeshes> readDicom(const std::filesystem::path& file, const ReadOptions& options) {
  const Result<DicomFile> dicom = DicomFile::read(file, options.limits);
  if (!dicom)
    return dicom.error();
  const std::string_view kind = dicom->sopClass();
  if (kind == structureSetClass)
    return structureSetSurfaces(*dicom, options);
  if (kind == segmentationClass)
    return segmentationSurfaces(*dicom, options);
  const std::string_view name = objectName(kind);
  return dicom->source().whole(
      name.empty() ? "is DICOM of a kind that is not known here and holds no segmentation"
                   : "holds no segmentation: its content is of the kind " + std::string(name),
      "Give the DICOM segmentation or RT structure set that was made from it");
}

}  // namespace sline::model
