// SPDX-License-Identifier: Apache-2.0
// Tells by names alone that files are of two bodies: the same organs come twice, and their files or
// folders differ by words that may be persons'.
#pragma once

#include <filesystem>
#include <set>
#include <vector>

#include "model/import/plan/patients.h"
#include "model/import/plan/sources.h"

namespace sline::model {

/// Returns the files of each body that names tell apart, two or more, in the order of the files;
/// nothing where they may all be of one. One organ that comes twice may be two versions of it,
/// unless what differs is written as persons' names are; what stands under two persons' first and
/// last names, under two numbers of patients or, as names say, is of a woman and of a man, is of
/// two whatever it is. Files that say themselves whose they are (`marked`) are passed over, and so
/// are molecules' entries and what scenes of 3D Slicer name.
std::vector<PatientFiles> bodiesByName(const Sources& sources,
                                       const std::set<std::filesystem::path>& marked);

}  // namespace sline::model
