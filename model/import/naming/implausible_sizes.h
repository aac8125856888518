// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/scene/scene.h"

namespace sline::model {

/// Says which structure has a size that no part of a body has, and how many more; empty where none
/// does. Their unit is read wrongly, most likely.
std::string implausibleSizesText(const Scene& scene);

/// Says that molecules lie beside what is not: they are drawn larger than life, and no scale bar
/// holds for both. Empty where they do not.
std::string mixedScalesText(const Scene& scene);

}  // namespace sline::model
