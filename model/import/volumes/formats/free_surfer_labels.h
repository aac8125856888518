// SPDX-License-Identifier: Apache-2.0
// Tells the meaning of FreeSurfer's numbers in a volume that brings no table of its own.
#pragma once

#include <filesystem>
#include <string_view>

#include "model/import/volumes/formats/label_names.h"

namespace sline::model {

/// Returns names and colours by the numbers of resources/anatomy/freesurfer.tsv where the volume is
/// one of FreeSurfer's: its file's name says so (aseg, aparc, wmparc, synthseg), or it has white
/// matter or cortex of both hemispheres under their numbers and none below 1,000 that FreeSurfer
/// does not use. Otherwise returns nothing: a 4 is no ventricle in the volumes of other programs.
LabelNames freeSurferLabels(const LabelVolume& volume, const std::filesystem::path& file);

/// Returns the table as it is compiled in.
std::string_view freeSurferTable();

}  // namespace sline::model
