// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace sline::render {

/// Returns an ICC profile (version 2.1) of sRGB, IEC 61966-2-1.
std::string srgbProfile();
/// Returns such a profile for pictures in grey: sRGB's tone curve.
std::string greyProfile();

}  // namespace sline::render
