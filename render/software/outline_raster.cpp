// SPDX-License-Identifier: Apache-2.0
#include "render/software/outline_raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include "model/base/parallel.h"
#include "model/base/wide_loops.h"

namespace sline::render {

namespace {

constexpr int squareSide = TileMask::side;
constexpr int widest = OutlineLook::mostReach;
constexpr int windowSide = squareSide + 2 * widest;
static_assert(widest < squareSide);

std::size_t placeIn(const PixelRect& area, int x, int y) {
  return std::size_t(y - area.y) * std::size_t(area.width) + std::size_t(x - area.x);
}

/// The area's squares: each has one number, or several.
class Squares {
 public:
  static constexpr int several = -1;

  explicit Squares(const MarkedPixels& marks)
      : m_columns((marks.area.width + squareSide - 1) / squareSide),
        m_rows((marks.area.height + squareSide - 1) / squareSide),
        m_numbers(std::size_t(m_columns) * std::size_t(m_rows)) {
    parallelFor(std::size_t(m_rows), 4, [&](std::size_t row) {
      for (int column = 0; column < m_columns; ++column)
        m_numbers[row * std::size_t(m_columns) + std::size_t(column)] =
            numberOf(marks, rectangle(marks.area, column, int(row)));
    });
  }

  /// Lists the squares, (column, row), in or beside which the number changes.
  std::vector<glm::ivec2> besideBorders() const {
    std::vector<glm::ivec2> found;
    for (int row = 0; row < m_rows; ++row)
      for (int column = 0; column < m_columns; ++column)
        if (isBesideBorder(column, row))
          found.emplace_back(column, row);
    return found;
  }

  static PixelRect rectangle(const PixelRect& area, int column, int row) {
    return intersection(
        {area.x + squareSide * column, area.y + squareSide * row, squareSide, squareSide}, area);
  }

 private:
  static int numberOf(const MarkedPixels& marks, const PixelRect& square) {
    const std::uint8_t first = marks.numbers[placeIn(marks.area, square.x, square.y)];
    for (int y = square.y; y < square.top(); ++y) {
      const std::uint8_t* row = marks.numbers.data() + placeIn(marks.area, square.x, y);
      if (!std::all_of(row, row + square.width, [&](std::uint8_t n) { return n == first; }))
        return several;
    }
    return first;
  }
  bool isBesideBorder(int column, int row) const {
    const int own = m_numbers[std::size_t(row) * std::size_t(m_columns) + std::size_t(column)];
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, m_rows - 1); ++y)
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, m_columns - 1); ++x)
        if (const int there = m_numbers[std::size_t(y) * std::size_t(m_columns) + std::size_t(x)];
            there != own || there == several)
          return true;
    return false;
  }

  int m_columns;
  int m_rows;
  std::vector<int> m_numbers;
};

/// Returns where the window holds what lies so far from the square's first row or column.
constexpr std::size_t inWindow(int away) {
  const int place = away + widest;
  return std::size_t(place);
}

using SquareWeights = std::array<float, 2 * widest + 1>;
using SquareNumbers = std::array<std::array<std::uint8_t, windowSide>, windowSide>;
using SquareShares = std::array<std::array<float, squareSide>, windowSide>;

/// Finds the share of pixels with that number around each of a square's, of whose weights `reach`
/// each way count.
SLINE_WIDE_LOOPS void spreadNumber(const SquareNumbers& numbers, std::uint8_t number,
                                   const SquareWeights& weights, int reach, SquareShares& shares) {
  SquareShares across{};
  for (int y = -reach; y < squareSide + reach; ++y) {
    float* row = across[inWindow(y)].data();
    for (int i = 0; i <= 2 * reach; ++i) {
      const std::uint8_t* there = numbers[inWindow(y)].data() + inWindow(i - reach);
      const float weight = weights[std::size_t(i)];
      for (int x = 0; x < squareSide; ++x)
        row[x] += there[x] == number ? weight : 0.0f;
    }
  }
  for (int y = 0; y < squareSide; ++y) {
    float* row = shares[std::size_t(y)].data();
    for (int x = 0; x < squareSide; ++x)
      row[x] = 0.0f;
    for (int i = 0; i <= 2 * reach; ++i) {
      const float* there = across[inWindow(y + i - reach)].data();
      const float weight = weights[std::size_t(i)];
      for (int x = 0; x < squareSide; ++x)
        row[x] += weight * there[x];
    }
  }
}

/// Draws one square after another.
class SquareDrawer {
 public:
  SquareDrawer(const MarkedPixels& marks, const PixelRect& region,
               std::span<const HidingLayer> layers, const OutlineLook& look)
      : m_marks(marks),
        m_region(region),
        m_layers(layers),
        m_look(look),
        m_scale(look.scale()),
        m_reach(look.reach()) {
    float sum = 0.0f;
    for (int i = 0; i <= 2 * m_reach; ++i) {
      const auto away = float(i - m_reach);
      sum += m_weights[std::size_t(i)] = std::exp(-0.5f * away * away / (m_scale * m_scale));
    }
    for (float& weight : m_weights)
      weight /= sum;
    for (int y = -m_reach; y <= m_reach; ++y)
      for (int x = -m_reach; x <= m_reach; ++x)
        m_ways.emplace_back(x, y);
    std::stable_sort(m_ways.begin(), m_ways.end(), [](const glm::ivec2& a, const glm::ivec2& b) {
      return a.x * a.x + a.y * a.y < b.x * b.x + b.y * b.y;
    });
  }

  /// Puts the colours of the square's pixels.
  void draw(const PixelRect& square, std::vector<std::uint32_t>& colours) {
    look(square);
    m_near.clear();
    for (const HidingLayer& layer : m_layers)
      if (layer.mask->marksAny(grown(square, m_reach)))
        m_near.push_back(&layer);
    std::array<bool, 256> done{};
    for (int y = 0; y < square.height; ++y)
      for (int x = 0; x < square.width; ++x)
        if (const std::uint8_t own = numberAt(x, y); !done[own]) {
          done[own] = true;
          spreadNumber(m_numbers, own, m_weights, m_reach, m_shares);
          for (int row = y; row < square.height; ++row)
            drawRow(own, square, row, colours);
        }
  }

 private:
  std::uint8_t numberAt(int x, int y) const { return m_numbers[inWindow(y)][inWindow(x)]; }

  /// Takes the numbers in and around the square; what lies beside the area is as at its rim.
  void look(const PixelRect& square) {
    const PixelRect& area = m_marks.area;
    for (int y = -m_reach; y < squareSide + m_reach; ++y) {
      const int row = std::clamp(square.y + y, area.y, area.top() - 1);
      for (int x = -m_reach; x < squareSide + m_reach; ++x) {
        const int column = std::clamp(square.x + x, area.x, area.right() - 1);
        m_numbers[inWindow(y)][inWindow(x)] = m_marks.numbers[placeIn(area, column, row)];
      }
    }
  }

  void drawRow(std::uint8_t own, const PixelRect& square, int y,
               std::vector<std::uint32_t>& colours) const {
    for (int x = 0; x < square.width; ++x) {
      if (numberAt(x, y) != own)
        continue;
      // The share is 1/2 at the border and changes there by the Gaussian's height per pixel.
      const float inwards = (m_shares[std::size_t(y)][std::size_t(x)] - 0.5f) * m_scale * 2.5066f;
      // What is thinner than the line has no inside.
      const float away = own > 0 ? std::max(inwards, 0.0f) : std::abs(inwards);
      const float line = std::clamp(m_look.halfWidth + 0.5f - away, 0.0f, 1.0f);
      const float around = std::clamp(m_look.casingHalfWidth + 0.5f - away, 0.0f, 1.0f);
      if (!(around > 0.0f) || !isNearBorder(x, y))
        continue;
      const glm::ivec2 way = toMarked(x, y);
      const glm::ivec2 marked = glm::clamp(
          glm::ivec2(square.x + x, square.y + y) + way, glm::ivec2(m_marks.area.x, m_marks.area.y),
          glm::ivec2(m_marks.area.right(), m_marks.area.top()) - 1);
      const float seen = seenAt(marked);
      const float strength =
          glm::mix(m_look.hiddenStrength, m_look.strength, glm::smoothstep(0.2f, 0.4f, seen));
      const glm::vec4 colour = glm::vec4(glm::mix(m_look.casing, m_look.ink, line), 1.0f) *
                               std::max(line, 0.7f * around);
      colours[placeIn(m_marks.area, square.x + x, square.y + y)] = packedColour(colour * strength);
    }
  }

  bool isNearBorder(int x, int y) const {
    const std::uint8_t own = numberAt(x, y);
    for (int i = 0; i < 9; ++i) {
      const int dx = i % 3 - 1;
      const int dy = i / 3 - 1;
      if (numberAt(x + dx, y + dy) != own || numberAt(x + m_reach * dx, y + m_reach * dy) != own)
        return true;
    }
    return false;
  }

  /// Returns the way to the nearest pixel of a marked structure.
  glm::ivec2 toMarked(int x, int y) const {
    const auto nearest = std::find_if(m_ways.begin(), m_ways.end(), [&](const glm::ivec2& way) {
      return numberAt(x + way.x, y + way.y) > 0;
    });
    return nearest == m_ways.end() ? glm::ivec2(0) : *nearest;
  }

  /// Returns the share of light that reaches the eye from the marked structure at the pixel.
  float seenAt(const glm::ivec2& pixel) const {
    // Among structures that share a layer, less is the structure itself.
    constexpr float depthStep = 2e-4f;
    const std::size_t at = placeIn(m_marks.area, pixel.x, pixel.y);
    const int own = m_marks.numbers[at];
    const glm::ivec2 square = (pixel - glm::ivec2(m_region.x, m_region.y)) / squareSide;
    float seen = 1.0f;
    for (const HidingLayer* layer : m_near) {
      const PixelRect& area = layer->pixels->area;
      if ((layer->number > 0 && layer->number == own) || !layer->mask->marked(square.x, square.y) ||
          pixel.x < area.x || pixel.y < area.y || pixel.x >= area.right() || pixel.y >= area.top())
        continue;
      const std::size_t there = layer->pixels->at(pixel.x, pixel.y);
      if (layer->pixels->depths[there] < m_marks.depths[at] - depthStep)
        seen *= 1.0f - float(layer->pixels->colours[there] >> 24U) / 255.0f;
    }
    return seen;
  }

  const MarkedPixels& m_marks;
  const PixelRect& m_region;
  std::span<const HidingLayer> m_layers;
  const OutlineLook& m_look;
  float m_scale;
  int m_reach;
  SquareWeights m_weights{};               ///< of one direction, from −reach on
  std::vector<glm::ivec2> m_ways;          ///< to pixels around, the nearest first
  std::vector<const HidingLayer*> m_near;  ///< those that touch the square or what is around it
  SquareNumbers m_numbers{};
  SquareShares m_shares{};
};

}  // namespace

PixelRect markedArea(const PixelRect& structures, const PixelRect& region,
                     const OutlineLook& look) {
  if (structures.empty())
    return {};
  const PixelRect reached = intersection(grown(structures, look.reach() + 1), region);
  const auto floored = [](int pixels) { return pixels / squareSide * squareSide; };
  const int left = floored(reached.x - region.x);
  const int bottom = floored(reached.y - region.y);
  const int right = floored(reached.right() - region.x + squareSide - 1);
  const int top = floored(reached.top() - region.y + squareSide - 1);
  return intersection({region.x + left, region.y + bottom, right - left, top - bottom}, region);
}

OutlineInk outlineInk(const MarkedPixels& marks, const PixelRect& region,
                      std::span<const HidingLayer> layers, const OutlineLook& look) {
  OutlineInk ink;
  ink.colours.resize(marks.numbers.size());
  const std::vector<glm::ivec2> squares = Squares(marks).besideBorders();
  TileMask drawn(region, marks.area);
  parallelChunks(squares.size(), 16, [&](std::size_t begin, std::size_t end) {
    SquareDrawer drawer(marks, region, layers, look);
    for (std::size_t i = begin; i < end; ++i)
      drawer.draw(Squares::rectangle(marks.area, squares[i].x, squares[i].y), ink.colours);
  });
  for (const glm::ivec2& square : squares)
    drawn.mark(Squares::rectangle(marks.area, square.x, square.y));
  ink.rectangles = drawn.rectangles();
  return ink;
}

}  // namespace sline::render
