// SPDX-License-Identifier: Apache-2.0
// Describes what is written over a picture as shapes and lines of text: one list for pictures made
// of pixels, for vectors and for print. All lengths are millimetres of the output from its upper
// left corner.
#pragma once

#include <QPainter>
#include <QPainterPath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "model/base/units.h"
#include "render/drawn/picture_settings.h"
#include "render/lettering/text_lines.h"
#include "render/vectors/path.h"

namespace sline::render {

/// Tells which point of a line of text stands at its place.
enum class TextAnchor { start, middle, end };

/// Text set in `labelFont`, each run in the font of its style.
struct LetteringText {
  std::vector<TextLine> lines;
  glm::vec2 at{0.0f};    ///< start of the first line's baseline
  float leading = 0.0f;  ///< from one baseline to the next
  float points = 10.0f;  ///< size of the font
  TextAnchor anchor = TextAnchor::start;
  Colour ink;
};

struct LetteringShape {
  Path path;
  float pen = 0.0f;  ///< 0: no outline
  Colour ink;        ///< of the outline
  std::optional<Colour> fill;
  bool dashed = false;  ///< dashes five pens long, gaps of four
  float halo = 0.0f;    ///< width on either side
  /// It is ground, in the place of whatever the drawing has there, as halos are. Its fill is the
  /// ground's colour.
  bool ground = false;
};

/// Holds one label or mark.
struct LetteringItem {
  std::string name;  ///< plain text, for groups of vector files
  std::vector<LetteringShape> shapes;
  std::optional<LetteringText> text;
};

struct Lettering {
  Colour ground{255, 255, 255};  ///< colour of halos, so that everything can be read on a drawing
  /// There is no ground: halos are gaps in the drawing where what is painted on can have them, and
  /// else have that colour. On pages of a PDF they are left to who places the drawing there.
  bool clear = false;
  std::vector<LetteringItem> items;
};

/// The width of halos around letters, on either side.
inline constexpr float textHalo = 0.5f;
/// The lengths of dashes and gaps, in pens.
inline constexpr float dashPens = 5.0f;
inline constexpr float gapPens = 4.0f;

/// The colours of ink and ground for writing on a page of that ground: halos have the very colour
/// that the picture has there. `clear`: there is none, and boxes are white.
struct LetteringColours {
  Colour ink;
  Colour ground;
  bool clear = false;
};
LetteringColours letteringColours(Background background = Background::white);

/// Sets a text with the painter; if the function is empty, the text's outlines are filled.
using TextSetter = std::function<void(QPainter& painter, const LetteringText& text)>;

/// Paints the lettering. The painter's unit must be a millimetre, from the picture's upper left
/// corner. Halos are painted first, so that none covers the ink of another.
void paintLettering(QPainter& painter, const Lettering& lettering, const TextSetter& setText = {});

/// These return shapes in the plane as paths.
Path polyline(const std::vector<glm::vec2>& points);
Path circle(const glm::vec2& middle, float radius);
Path roundedBox(const glm::vec2& low, const glm::vec2& high, float radius);

QPainterPath painterPath(const Path& path);
/// Returns where each run of a line begins, in millimetres from `LetteringText::at`.
std::vector<float> runPlaces(const LetteringText& text, const TextLine& line);
/// Returns the letters' outlines, to be filled by the winding rule.
QPainterPath outlineOf(const LetteringText& text);
/// Returns a path to be stroked 2 `textHalo` wide behind the letters: their outlines and, along
/// each line, strokes that keep the drawing from showing between words, where it would read as a
/// dash.
QPainterPath haloOf(const LetteringText& text);
QColor painterColour(const Colour& colour);

}  // namespace sline::render
