// SPDX-License-Identifier: Apache-2.0
// Reads RT structure sets (PS3.3 §A.19), regions of interest outlined by contours.
#pragma once

#include "model/import/dicom/dicom_file.h"
#include "model/import/source/read_options.h"

namespace sline::model {

/// Returns one surface per region of interest that has closed planar contours, named, coloured and
/// grouped as the file says. A region without such contours is left out with a warning; it is an
/// error where nothing is left.
Result<RawMeshes> structureSetSurfaces(const DicomFile& file, const ReadOptions& options);

}  // namespace sline::model
