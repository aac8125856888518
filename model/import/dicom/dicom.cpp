// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/dicom.h"

#include <new>

#include "model/import/dicom/dicom_file.h"
#include "model/import/dicom/image_series.h"
#include "model/import/dicom/segmentation.h"
#include "model/import/dicom/structure_set.h"

namespace sline::model {

namespace {

/// Where memory ends in the middle of a file, that file is told of.
template <class Read>
auto withinMemory(const std::filesystem::path& file, const Read& read) -> decltype(read()) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    return Error{file.string(), {}, "needs more memory than there is", "Close other programs"};
  }
}

Result<RawMeshes> surfacesIn(const std::filesystem::path& file, const ReadOptions& options) {
  const Result<DicomFile> dicom = DicomFile::read(file, options.limits);
  if (!dicom)
    return dicom.error();
  const std::string& kind = dicom->sopClass();
  if (kind == structureSetClass)
    return structureSetSurfaces(*dicom, options);
  if (holdsStructures(kind))
    return segmentationSurfaces(*dicom, options);
  const std::string_view name = objectName(kind);
  return dicom->source().whole(
      name.empty() ? "is DICOM of a kind that is not known here and holds no segmentation"
                   : "holds no segmentation: its content is of the kind " + std::string(name),
      "Give the DICOM segmentation or RT structure set that was made from it");
}

}  // namespace

Result<RawMeshes> readDicom(const std::filesystem::path& file, const ReadOptions& options) {
  return withinMemory(file, [&] { return surfacesIn(file, options); });
}

std::vector<DicomSeries> seriesIn(std::span<const std::filesystem::path> files,
                                  const ReadOptions& options) {
  return imageSeries(files, options);
}

Result<GreyVolume> readDicomSeries(std::span<const std::filesystem::path> files,
                                   const ReadOptions& options) {
  const std::filesystem::path first = files.empty() ? std::filesystem::path() : files.front();
  return withinMemory(first, [&] { return seriesVolume(files, options); });
}

}  // namespace sline::model
