// SPDX-License-Identifier: Apache-2.0
// Tells which labels the picture in the window lacks, or has with a dashed leader, and why.
#pragma once

#include <QString>
#include <map>

#include "model/scene/annotation.h"

namespace sline::widgets {

/// Tells why a label that is ticked is not in the picture, or that it points at what is hidden.
enum class LabelSight { hidden, withoutRoom, offPicture, notDrawn };

/// The labels of a picture by their ids; those that stand there as usual are left out.
using LabelSightsById = std::map<std::uint64_t, LabelSight>;

/// Returns a sentence that says so of the annotation.
QString sightText(LabelSight sight, const model::Annotation& annotation);

}  // namespace sline::widgets
