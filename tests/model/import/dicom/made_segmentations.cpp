// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/dicom/made_segmentations.h"

#include <QTemporaryDir>

#include "tests/model/import/dicom/surface_facts.h"
#include "tests/model/import/dicom/written_images.h"

namespace sline::test {

void addBox(WrittenSegmentation& written, std::uint16_t segment, const SlicedBox& box,
            std::uint8_t value) {
  for (int z = box.first; z < box.last; ++z) {
    WrittenFrame frame{segment, {-10.0, -20.0, 100.0 + written.sliceSpacing * z}, {}};
    for (int y = 0; y < written.rows; ++y)
      for (int x = 0; x < written.columns; ++x)
        frame.pixels.push_back(
            x >= box.lowX && x < box.highX && y >= box.lowY && y < box.highY ? value : 0);
    written.frames.push_back(std::move(frame));
  }
}

WrittenSegmentation emptySegmentation() {
  WrittenSegmentation written;
  written.columns = 20;
  written.rows = 12;
  written.columnSpacing = 0.5;
  written.segments = {{1, "Liver", "Anatomical Structure", {}}, {2, "Tumour", "Lesion", {}}};
  return written;
}

Result<model::LabelVolumes> volumesOf(const QByteArray& bytes) {
  const QTemporaryDir folder;
  const auto dicom = model::DicomFile::read(put(folder, "seg.dcm", bytes), {});
  if (!dicom)
    return dicom.error();
  return model::segmentationVolumes(*dicom, {});
}

Result<model::LabelVolumes> volumesOf(const WrittenSegmentation& written, const Manner& manner) {
  return volumesOf(dicomFile(segmentation(written), manner));
}

Result<model::RawMeshes> surfacesOf(const WrittenSegmentation& written, const Manner& manner) {
  const QTemporaryDir folder;
  return readDicomBytes(folder, dicomFile(segmentation(written), manner));
}

}  // namespace sline::test
