// SPDX-License-Identifier: Apache-2.0
// Corrects by their names what was found of vessels by their form: a segmentation often ends a
// vessel short of what it feeds, and one that feeds something else may pass by.
#pragma once

#include <span>

#include "model/focus/analysis.h"

namespace sline::model {

/// Makes vessels that are named after a target feeders; one that is named after another structure
/// of the scene alone, and only comes near, feeds that. Vessels whose names tell nothing stay as
/// they were found.
void treatVesselsByWhatTheyFeed(const Scene& scene, std::span<Relation> relations);

}  // namespace sline::model
