// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/side_letters.h"

#include <glm/common.hpp>

#include "render/export/plate/mark_text.h"
#include "render/export/plate/marks.h"
#include "render/lettering/label_texts.h"

namespace sline::render {

namespace {

AxisLetters movedTogether(AxisLetters ends, const glm::vec2& way, float points,
                          const FreePlaces& places) {
  if (ends[0].letters.empty() || ends[1].letters.empty())
    return ends;
  if (const auto by = places.shiftTogether(roomOf(ends[0], points), roomOf(ends[1], points), way))
    for (EdgeLetter& end : ends)
      end.at += *by;
  return ends;
}

}  // namespace

LabelBox roomOf(const EdgeLetter& letter, float points) {
  const auto boxWith = [&](const QString& words) {
    return boxOf(LetteringText{.lines = {words},
                               .at = letter.at,
                               .leading = 0.0f,
                               .points = points,
                               .anchor = letter.anchor});
  };
  LabelBox room = boxWith(QString::fromStdString(letter.letters));
  for (const QChar any : QStringLiteral("RLAPSI")) {
    const LabelBox other = boxWith(any);
    room = {glm::min(room.low, other.low), glm::max(room.high, other.high)};
  }
  return room;
}

AxisLetters lettersAcross(const EdgeLetters& letters, const glm::vec2& size, float points,
                          const FreePlaces& places) {
  const float middle = 0.5f * (size.y + capHeightMm(points));
  return movedTogether({{{letters.left, {markMargin, middle}, TextAnchor::start},
                         {letters.right, {size.x - markMargin, middle}, TextAnchor::end}}},
                       {0.0f, 1.0f}, points, places);
}

AxisLetters lettersUpright(const EdgeLetters& letters, const glm::vec2& size, float points,
                           const FreePlaces& places) {
  const float middle = 0.5f * size.x;
  return movedTogether(
      {{{letters.top, {middle, markMargin + capHeightMm(points)}, TextAnchor::middle},
        {letters.bottom, {middle, size.y - markMargin}, TextAnchor::middle}}},
      {1.0f, 0.0f}, points, places);
}

}  // namespace sline::render
