// SPDX-License-Identifier: Apache-2.0
// Says what keys do in a presentation: what they do in other presentation programs, so that a
// presenter's remote works, too.
#pragma once

#include <QKeyCombination>
#include <optional>

namespace sline::widgets {

enum class PresentationWish {
  next,
  back,
  first,
  last,
  enter,  ///< goes to the view whose number was typed, else on
  black,
  white,
  laser,
  pen,
  wipe,    ///< takes away what was drawn
  notes,   ///< the presenter's window
  reveal,  ///< labels come one by one
  quiz,
  end
};

/// Returns what the key asks for; nothing for other keys.
std::optional<PresentationWish> wishOf(QKeyCombination key);
/// Returns the digit of the key; nothing for other keys.
std::optional<int> digitOf(QKeyCombination key);

}  // namespace sline::widgets
