// SPDX-License-Identifier: Apache-2.0
// Slices of CT, MR and PET as volumes; see dicom.h for what holds of both functions.
#pragma once

#include "model/import/dicom/dicom.h"

namespace sline::model {

std::vector<DicomSeries> imageSeries(std::span<const std::filesystem::path> files,
                                     const ReadOptions& options);

Result<GreyVolume> seriesVolume(std::span<const std::filesystem::path> files,
                                const ReadOptions& options);

}  // namespace sline::model
