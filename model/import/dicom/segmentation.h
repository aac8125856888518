// SPDX-License-Identifier: Apache-2.0
// Reads DICOM segmentations (PS3.3 §A.51) of bits, of fractions and as label maps: one structure
// per segment.
#pragma once

#include "model/import/dicom/dicom_file.h"
#include "model/import/source/read_options.h"
#include "model/import/volumes/formats/label_volume.h"

namespace sline::model {

/// Returns the volumes of the segments. Frames may come in any order; a segment without a frame is
/// empty. Segments that overlap come in volumes of their own. Warnings: frames that lie unevenly or
/// belong to no segment.
Result<LabelVolumes> segmentationVolumes(const DicomFile& file, const ReadOptions& options);

/// Returns the segments' surfaces, as label_surfaces.h makes them.
Result<RawMeshes> segmentationSurfaces(const DicomFile& file, const ReadOptions& options);

}  // namespace sline::model
