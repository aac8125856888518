// SPDX-License-Identifier: Apache-2.0
// Lets structures that belong together be drawn alike around a focus.
#pragma once

#include <span>

#include "model/focus/analysis.h"

namespace sline::model {

/// Gives pairs and families one relation each, that of the member that matters most: left and right
/// of a structure where the targets lie on the body's middle, and structures whose names differ by
/// a number alone (ribs, vertebrae, discs, fingers, calyces; not vessels), so that they are treated
/// as a whole (METHOD §12.3). Names count in all languages of AnatomicalNames. The body's middle is
/// the plane halfway between the members of the pairs; the targets lie on it if they are on both
/// sides of it.
void treatKinAlike(const Scene& scene, std::span<Relation> relations);

}  // namespace sline::model
