// SPDX-License-Identifier: Apache-2.0
// Abbreviates the words that tell one structure from its like, as anatomists write them.
#pragma once

#include <string>
#include <vector>

namespace sline::render {

/// Returns how else the name is written in notes and on slides: its side abbreviated ("re. Ureter",
/// "A. iliaca externa dext."), its other adjectives, too ("A. iliaca ext. dext."), and a Latin name
/// with the side in a spoken language ("rechte A. iliaca externa"). Empty where there is nothing to
/// abbreviate.
std::vector<std::string> shortForms(const std::string& name);

}  // namespace sline::render
