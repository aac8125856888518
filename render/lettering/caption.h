// SPDX-License-Identifier: Apache-2.0
// Sets what is said with a view as it stands at the foot of a picture: in pictures and films, and
// in the window while it is typed or presented.
#pragma once

#include <optional>
#include <string>

#include "render/lettering/label_style.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// Tells where a caption may stand; millimetres of the output.
struct CaptionPlace {
  float middle = 0.0f;  ///< of its box, from the left edge
  float foot = 0.0f;    ///< of its box, from the upper edge
  float width = 0.0f;   ///< of its box at most
  float height = 0.0f;  ///< of its box at most
};

/// The widest that a caption is, as a share of the picture.
inline constexpr float captionShare = 0.7f;

struct Caption {
  LetteringItem item;  ///< named "caption": the box and its lines
  LabelBox box;
  bool shortened = false;  ///< lines that found no room are left out
};

/// Returns a text with a title before it, bold on lines of its own: both as `markup.h` describes,
/// the title given as plain text.
std::string captionMarkup(const std::string& title, const std::string& text);

/// Returns the marked-up text in lines at that place, in the style's size and ink; nothing where it
/// says nothing.
std::optional<Caption> captionOf(const std::string& markup, const LabelStyle& style,
                                 const CaptionPlace& place);

}  // namespace sline::render
