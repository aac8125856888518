// SPDX-License-Identifier: Apache-2.0
// Writes what the views of a tour say as subtitles that players show (WebVTT, W3C).
#pragma once

#include <string>

#include "render/export/motion/film.h"

namespace sline::render {

/// Returns a WebVTT file in UTF-8 with a cue for each view that says something, its title in bold,
/// in that language. Texts stay text: signs of WebVTT's own are escaped.
std::string webVtt(const Film& film, const std::string& language);

}  // namespace sline::render
