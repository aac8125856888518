// SPDX-License-Identifier: Apache-2.0
// Makes segmentations of boxes for the tests, and reads them.
#pragma once

#include <QByteArray>
#include <cstdint>

#include "model/import/dicom/segmentation.h"
#include "tests/model/import/dicom/written_dicom.h"
#include "tests/model/import/dicom/written_segmentation.h"

namespace sline::test {

/// Describes a box of pixels [low, high) in slices [first, last).
struct SlicedBox {
  int lowX, highX, lowY, highY, first, last;
};

void addBox(WrittenSegmentation& written, std::uint16_t segment, const SlicedBox& box,
            std::uint8_t value = 1);

/// Returns a segmentation of 20 × 12 pixels of 0.5 × 1 mm and slices of 2 mm, without frames.
WrittenSegmentation emptySegmentation();

Result<model::LabelVolumes> volumesOf(const QByteArray& bytes);

Result<model::LabelVolumes> volumesOf(const WrittenSegmentation& written,
                                      const Manner& manner = {});

Result<model::RawMeshes> surfacesOf(const WrittenSegmentation& written, const Manner& manner = {});

}  // namespace sline::test
