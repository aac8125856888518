// SPDX-License-Identifier: Apache-2.0
// Reads slices of CT, MR and PET as volumes; dicom.h describes both functions.
#pragma once

#include "model/import/dicom/dicom.h"

namespace sline::model {

std::vector<DicomSeries> imageSeries(std::span<const std::filesystem::path> files,
                                     const ReadOptions& options);

Result<GreyVolume> seriesVolume(std::span<const std::filesystem::path> files,
                                const ReadOptions& options);

}  // namespace sline::model
