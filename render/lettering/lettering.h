// SPDX-License-Identifier: Apache-2.0
// What is written over a picture, as shapes and lines of text: one list for pictures made of
// pixels, for vectors and for print. Millimetres of the output from its upper left corner.
#pragma once

#include <QPainter>
#include <QPainterPath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/base/units.h"
#include "render/lettering/text_lines.h"
#include "render/vectors/path.h"

namespace sline::render {

/// What of a line of text stands at its place.
enum class TextAnchor { start, middle, end };

/// Set in `labelFont`, each run in that of its style.
struct LetteringText {
  std::vector<TextLine> lines;
  glm::vec2 at{0.0f};    ///< on the first line's baseline
  float leading = 0.0f;  ///< from one baseline to the next
  float points = 10.0f;  ///< of the font
  TextAnchor anchor = TextAnchor::start;
  Colour ink;
};

struct LetteringShape {
  Path path;
  float pen = 0.0f;  ///< 0: no outline
  Colour ink;        ///< of the outline
  std::optional<Colour> fill;
  bool dashed = false;  ///< five pens of line, four of gap
  float halo = 0.0f;    ///< on either side
};

/// One label or mark.
struct LetteringItem {
  std::string name;  ///< for groups of vector files; plain text
  std::vector<LetteringShape> shapes;
  std::optional<LetteringText> text;
};

struct Lettering {
  Colour ground{255, 255, 255};  ///< of halos, so that all can be read on a drawing
  std::vector<LetteringItem> items;
};

/// Around letters, on either side.
inline constexpr float textHalo = 0.5f;
/// Lines of dashes and gaps, in pens.
inline constexpr float dashPens = 5.0f;
inline constexpr float gapPens = 4.0f;

/// Ink and ground of what is written on a light or a dark page.
struct LetteringColours {
  Colour ink;
  Colour ground;
};
LetteringColours letteringColours(bool onDark);

/// Sets a text with the painter; an empty function fills its outlines.
using TextSetter = std::function<void(QPainter& painter, const LetteringText& text)>;

/// The painter's unit must be a millimetre, from the picture's upper left corner. Halos are painted
/// first, so that none covers another's ink.
void paintLettering(QPainter& painter, const Lettering& lettering, const TextSetter& setText = {});

/// Shapes in the plane as paths.
Path polyline(const std::vector<glm::vec2>& points);
Path circle(const glm::vec2& middle, float radius);
Path roundedBox(const glm::vec2& low, const glm::vec2& high, float radius);

QPainterPath painterPath(const Path& path);
/// Where each run of a line begins, millimetres from `LetteringText::at`.
std::vector<float> runPlaces(const LetteringText& text, const TextLine& line);
/// The letters' outlines, to be filled by the winding rule.
QPainterPath outlineOf(const LetteringText& text);
/// To be stroked 2 `textHalo` wide behind the letters: their outlines, and along each line what
/// keeps the drawing from showing between words, where it would read as a dash.
QPainterPath haloOf(const LetteringText& text);
QColor painterColour(const Colour& colour);

}  // namespace sline::render
