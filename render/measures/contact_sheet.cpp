// SPDX-License-Identifier: Apache-2.0
#include "render/measures/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/base/units.h"

namespace sline::render {

namespace {

constexpr Colour black{0, 0, 0};
constexpr Colour grey{150, 150, 150};
constexpr Colour pale{215, 215, 215};
constexpr Colour red{205, 45, 40};
constexpr Colour blue{50, 90, 170};

Image blank(int width, int height) {
  return {.width = width,
          .height = height,
          .rgba = std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 4, 255)};
}

/// Fills the part of the rectangle that lies within the image.
void fill(Image& image, const PixelRect& rectangle, const Colour& colour) {
  const PixelRect r = intersection(rectangle, {0, 0, image.width, image.height});
  for (int y = r.y; y < r.top(); ++y)
    for (int x = r.x; x < r.right(); ++x) {
      std::uint8_t* p =
          &image.rgba[4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x))];
      p[0] = colour.red;
      p[1] = colour.green;
      p[2] = colour.blue;
    }
}

void paste(const Image& from, Image& to, int x, int y) {
  for (int row = 0; row < from.height; ++row)
    std::copy_n(from.rgba.begin() + std::ptrdiff_t(4) * row * from.width, 4 * from.width,
                to.rgba.begin() + std::ptrdiff_t(4) * (std::ptrdiff_t(y + row) * to.width + x));
}

constexpr int glyphWidth = 3;
constexpr int glyphHeight = 5;

/// Returns rows of three dots from the top, the left dot the highest bit.
std::array<int, glyphHeight> glyph(char c) {
  constexpr std::array<std::array<int, glyphHeight>, 10> digits{{{7, 5, 5, 5, 7},
                                                                 {2, 6, 2, 2, 7},
                                                                 {7, 1, 7, 4, 7},
                                                                 {7, 1, 3, 1, 7},
                                                                 {5, 5, 7, 1, 1},
                                                                 {7, 4, 7, 1, 7},
                                                                 {7, 4, 7, 5, 7},
                                                                 {7, 1, 2, 2, 2},
                                                                 {7, 5, 7, 5, 7},
                                                                 {7, 5, 7, 1, 7}}};
  if (c >= '0' && c <= '9')
    return digits[std::size_t(c - '0')];
  if (c == '.')
    return {0, 0, 0, 0, 2};
  if (c == '-')
    return {0, 0, 7, 0, 0};
  return {};
}

void write(Image& image, const std::string& text, int x, int y, int dot) {
  for (const char c : text) {
    const std::array<int, glyphHeight> rows = glyph(c);
    for (int row = 0; row < glyphHeight; ++row)
      for (int column = 0; column < glyphWidth; ++column)
        if (rows[std::size_t(row)] >> (glyphWidth - 1 - column) & 1)
          fill(image, {x + column * dot, y + row * dot, dot, dot}, black);
    x += (glyphWidth + 1) * dot;
  }
}

int textWidth(const std::string& text, int dot) {
  return int(text.size()) * (glyphWidth + 1) * dot - dot;
}

/// Draws bars of a stage's steps within `panel`; its height stands for `top` times the stage's
/// mean.
void drawStage(Image& image, const PixelRect& panel, const Ramp& ramp, int s, double top) {
  const RampStage& stage = ramp.stages[std::size_t(s)];
  for (int i = 0; i < stepsPerStage; ++i) {
    const int step = s * stepsPerStage + i;
    const int x0 = panel.x + panel.width * step / rampSteps;
    const int x1 = panel.x + panel.width * (step + 1) / rampSteps;
    const double rate = stage.mean > 0.0 ? ramp.steps[std::size_t(step)] / stage.mean : 0.0;
    const double start = double(step) / stepsPerStage;
    const bool dead = std::any_of(stage.dead.begin(), stage.dead.end(), [&](double at) {
      return start > at - 0.01 && start < at + 0.09;
    });
    const Colour colour = stage.exempt() ? pale : rate > jumpLimit ? red : blue;
    const int bar = std::max(1, int(std::lround(panel.height * std::min(rate, top) / top)));
    fill(image, {x0, panel.top() - bar, std::max(1, x1 - x0 - 1), bar}, colour);
    if (dead && !stage.exempt())
      fill(image, {x0, panel.top(), x1 - x0, 3}, red);
  }
}

void drawLuminance(Image& image, const PixelRect& panel, const RampTone& tone) {
  const auto height = [&](double value) {
    return panel.top() - 1 - int(std::lround(std::clamp(value, 0.0, 1.0) * (panel.height - 1)));
  };
  fill(image, {panel.x, height(tone.atEnd()), panel.width, 1}, grey);
  for (int x = 0; x < panel.width; ++x) {
    const double at = double(x) / std::max(1, panel.width - 1) * rampSteps;
    const std::size_t i = std::size_t(std::min(int(at), rampSteps - 1));
    const double value = std::lerp(tone.luminance[i], tone.luminance[i + 1], at - double(i));
    const bool dark = value < (1.0 - toneLimit) * tone.atEnd();
    fill(image, {panel.x + x, height(value) - 1, 1, 3}, dark ? red : black);
  }
}

}  // namespace

Image contactSheet(std::span<const SheetPicture> pictures, int columns) {
  if (pictures.empty())
    return {};
  const int width = pictures.front().image.width;
  const int height = pictures.front().image.height;
  const int dot = std::max(1, height / 120);
  const int gap = 2 * dot;
  const int label = (glyphHeight + 4) * dot;
  const int rows = (int(pictures.size()) + columns - 1) / columns;
  Image sheet = blank(columns * (width + gap) + gap, rows * (height + label + gap) + gap);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int x = gap + int(i) % columns * (width + gap);
    const int y = gap + int(i) / columns * (height + label + gap);
    paste(pictures[i].image, sheet, x, y);
    const std::string& text = pictures[i].label;
    write(sheet, text, x + (width - textWidth(text, dot)) / 2, y + height + 2 * dot, dot);
  }
  return sheet;
}

Image rampDiagram(const Ramp& ramp, int width, int height) {
  Image image = blank(width, height);
  const int margin = std::max(6, height / 20);
  const int panel = (height - 3 * margin) / 2;
  const PixelRect bars{margin, margin, width - 2 * margin, panel};
  const PixelRect curve{margin, panel + 2 * margin, width - 2 * margin, panel};
  constexpr double top = jumpLimit + 1.0;
  for (int s = 0; s <= rampStages; ++s)
    fill(image, {bars.x + bars.width * s / rampStages, bars.y, 1, curve.top() - bars.y}, pale);
  for (int s = 0; s < rampStages; ++s)
    drawStage(image, bars, ramp, s, top);
  for (const double level : {1.0, jumpLimit})
    fill(image, {bars.x, bars.top() - int(std::lround(panel * level / top)), bars.width, 1}, grey);
  drawLuminance(image, curve, ramp.tone);
  return image;
}

Image stacked(const Image& above, const Image& below) {
  Image result = blank(std::max(above.width, below.width), above.height + below.height);
  paste(above, result, 0, 0);
  paste(below, result, 0, above.height);
  return result;
}

}  // namespace sline::render
