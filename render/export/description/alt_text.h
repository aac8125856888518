// SPDX-License-Identifier: Apache-2.0
// Says in words what a picture shows, for who does not see it: from where, what is labelled and
// where it stands, what lies before what. It says no more than one can see.
#pragma once

#include <cstddef>
#include <string>

#include "render/export/order/export_order.h"

namespace sline::render {

/// The most words of a description that nobody asked to be longer.
inline constexpr std::size_t usualWords = 120;

struct AltText {
  std::string text;      ///< plain, one line of UTF-8; empty: nothing is to be said
  std::string language;  ///< BCP 47; empty: not known
  bool operator==(const AltText&) const = default;
};

/// Returns what is said of the order's picture: what the person says in the order, else what the
/// view says in the language, else a description, which names structures only where the scene has
/// labels: a file does not tell what nobody has written on the picture. Where labels are off, or
/// numbers or lines stand for them, no structure is named, so that no answer is given away: what
/// the view says is not used then, and with numbers and lines not what the order says either. It
/// takes as long as finding places for labels.
AltText altTextOf(const ExportOrder& order);

/// Returns the same of a film, whose first picture the order is of.
AltText altTextOfFilm(const ExportOrder& first);

/// Returns the description of what the order's picture shows, in the first of its languages:
/// English, German, Dutch, Norwegian and Latin; English in others. Structures are named by their
/// labels, all that are labelled and seen before others. Where there are more words than that, the
/// smallest structures are counted instead of named.
std::string describedPicture(const ExportOrder& order, std::size_t mostWords = usualWords);

/// Returns the order's credit with what is said of its picture and, where pictures say it, whose
/// work the surfaces are.
ExportCredit fileCredit(const ExportOrder& order);
ExportCredit fileCredit(const ExportOrder& order, const AltText& said);

}  // namespace sline::render
