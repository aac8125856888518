// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/dicom.h"

#include <iterator>
#include <map>
#include <memory>
#include <new>

#include "model/import/dicom/dicom_file.h"
#include "model/import/dicom/image_series.h"
#include "model/import/dicom/segmentation.h"
#include "model/import/dicom/structure_set.h"
#include "model/import/readers/dicom_kind.h"
#include "model/import/volumes/volume_surfaces.h"

namespace sline::model {

namespace {

/// Reads a file; where memory runs out meanwhile, the error names that file.
template <class Read>
auto withinMemory(const std::filesystem::path& file, const Read& read) -> decltype(read()) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    return Error{file.string(), {}, "needs more memory than there is", "Close other programs"};
  }
}

Result<RawMeshes> surfacesIn(const std::filesystem::path& file, const ReadOptions& options) {
  const DicomFile dicom = TRY(DicomFile::read(file, options.limits));
  const std::string& kind = dicom.sopClass();
  if (kind == structureSetClass)
    return structureSetSurfaces(dicom, options);
  if (holdsStructures(kind))
    return segmentationSurfaces(dicom, options);
  const std::string_view name = objectName(kind);
  return dicom.source().whole(
      name.empty() ? "is DICOM of a kind that is not known here and holds no segmentation"
                   : "holds no segmentation: its content is of the kind " + std::string(name),
      "Give the DICOM segmentation or RT structure set that was made from it");
}

}  // namespace

Result<RawMeshes> readDicom(const std::filesystem::path& file, const ReadOptions& options) {
  return withinMemory(file, [&] { return surfacesIn(file, options); });
}

Result<RawMeshes> readDicomFiles(std::span<const std::filesystem::path> files,
                                 const ReadOptions& options) {
  const bool wanted = !options.thresholds.empty() || options.keepScans;
  const std::vector<DicomSeries> series = wanted && !scannerOf(sopClassOf(files.front())).empty()
                                              ? seriesIn(files, options)
                                              : std::vector<DicomSeries>();
  if (series.empty())
    return readDicom(files.front(), options);
  RawMeshes all;
  std::optional<Error> first;
  std::map<std::string, int> numbers;
  for (const DicomSeries& one : series) {
    const int number = ++numbers[one.scanner];
    const std::string name = one.scanner + (number == 1 ? "" : " " + std::to_string(number));
    Result<GreyVolume> volume = readDicomSeries(one.files, options);
    Result<RawMeshes> made =
        volume
            ? scanSurfaces({name, std::make_shared<const GreyVolume>(std::move(*volume))}, options)
            : Result<RawMeshes>(volume.error());
    if (!made) {
      first = first.value_or(made.error());
      all.warnings.push_back({name, made.error().text()});
      continue;
    }
    std::move(made->meshes.begin(), made->meshes.end(), std::back_inserter(all.meshes));
    std::move(made->warnings.begin(), made->warnings.end(), std::back_inserter(all.warnings));
    std::move(made->notes.begin(), made->notes.end(), std::back_inserter(all.notes));
    std::move(made->scans.begin(), made->scans.end(), std::back_inserter(all.scans));
  }
  if (all.meshes.empty() && all.scans.empty() && first)
    return *first;
  return all;
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
