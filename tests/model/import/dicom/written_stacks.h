// SPDX-License-Identifier: Apache-2.0
// Writes stacks of slices for the tests, and reads them as volumes.
#pragma once

#include <QByteArray>
#include <QTemporaryDir>
#include <filesystem>
#include <functional>
#include <vector>

#include "model/import/dicom/dicom.h"
#include "tests/model/import/dicom/written_images.h"

namespace sline::test {

/// Returns values within 12 bits that no coder keeps by accident.
int pattern(int x, int y, int z);

/// Returns five slices 2.5 mm apart.
std::vector<WrittenImage> stack(const WrittenImage& like = {});

using Writer = std::function<QByteArray(const WrittenImage&)>;

QByteArray plain(const WrittenImage& written);

/// Writes the slices and returns their files in a different order.
std::vector<std::filesystem::path> files(const QTemporaryDir& folder,
                                         const std::vector<WrittenImage>& slices,
                                         const Writer& writer = plain);

Result<model::GreyVolume> volumeOf(const std::vector<WrittenImage>& slices,
                                   const Writer& writer = plain);

}  // namespace sline::test
