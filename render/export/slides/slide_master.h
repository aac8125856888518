// SPDX-License-Identifier: Apache-2.0
// Writes what all slides of a presentation follow: theme, master, layouts, and the page of notes
// (ECMA-376 part 1, §13.3, §14.2.7).
#pragma once

#include <string>

#include "render/export/slides/slide_parts.h"

namespace sline::render {

/// Sizes of letters before they are fitted to their boxes.
inline constexpr float slideTitlePoints = 28.0f;
inline constexpr float slideTextPoints = 18.0f;
inline constexpr float slideListPoints = 20.0f;

/// The layouts, in the order of their parts.
inline constexpr std::array slideLayouts{SlideLayout::figure, SlideLayout::text, SlideLayout::list};

/// Returns the theme: the deck's colours and a font that every system has or replaces by one of the
/// same widths.
std::string themePart(const SlideDeck& deck);
std::string slideMasterPart(const SlideDeck& deck);
std::string slideLayoutPart(const SlideDeck& deck, SlideLayout layout);
std::string notesMasterPart();
/// Returns how text that stands in no placeholder is set: in the theme's font, as labels are.
std::string defaultTextStyle();

/// The size of a page of notes.
inline constexpr glm::vec2 notesSizeMm{190.5f, 254.0f};

}  // namespace sline::render
