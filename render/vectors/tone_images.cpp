// SPDX-License-Identifier: Apache-2.0
#include "render/vectors/tone_images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "model/base/parallel.h"

namespace sline::render {

namespace {

// Pixels along a cell's side, at least and at most; a cell becomes one pixel of an image.
constexpr int finestCell = 2;
constexpr int coarsestCell = 12;
// Cells of all images together: some 1.5 MB in a file.
constexpr double mostCells = 1.5e6;
// Cells by which tones continue beyond what is seen, for programs that interpolate.
constexpr int beyond = 3;
// Colours come in steps of so many 255ths, which makes files a third smaller.
constexpr int colourStep = 4;
// What a clear place counts for its cell's colour.
constexpr float clearWeight = 1e-4f;

struct Cell {
  glm::vec3 colour{0.0f};  ///< weighted
  float weight = 0.0f;
  float alpha = 0.0f;  ///< sum over the places
  int places = 0;

  void add(const Cell& other) {
    colour += other.colour;
    weight += other.weight;
    alpha += other.alpha;
    places += other.places;
  }
};

/// One image while it is made: cells that lie on the same grid for all, row by row.
struct Canvas {
  int x = 0;  ///< the first cell of the grid
  int y = 0;
  int width = 0;
  int height = 0;
  std::vector<Cell> cells;

  bool empty() const { return cells.empty(); }
  Cell& at(int column, int row) {
    return cells[std::size_t(row - y) * std::size_t(width) + std::size_t(column - x)];
  }
  bool contains(int column, int row) const {
    return column >= x && row >= y && column < x + width && row < y + height;
  }
};

/// A fill at a place, and the share of the picture's light that comes from it.
struct Part {
  const SeenFill* fill = nullptr;
  float share = 0.0f;
};

/// What is seen at a place; kept from place to place to save memory's time.
struct Place {
  std::vector<SeenFill> fills;
  std::vector<Part> parts;
};

int floorDivided(int value, int by) {
  return value >= 0 ? value / by : -((by - 1 - value) / by);
}

Canvas canvasOver(const PixelRect& area, int cell) {
  Canvas canvas;
  canvas.x = floorDivided(area.x, cell) - beyond;
  canvas.y = floorDivided(area.y, cell) - beyond;
  canvas.width = floorDivided(area.right() - 1, cell) + 1 + beyond - canvas.x;
  canvas.height = floorDivided(area.top() - 1, cell) + 1 + beyond - canvas.y;
  canvas.cells.resize(std::size_t(canvas.width) * std::size_t(canvas.height));
  return canvas;
}

/// Gives cells in which nothing is seen the mean of their neighbours, a few times.
void extend(Canvas& canvas) {
  for (int round = 0; round < beyond; ++round) {
    const std::vector<Cell> before = canvas.cells;
    const auto width = std::size_t(canvas.width);
    for (int row = 1; row + 1 < canvas.height; ++row)
      for (int column = 1; column + 1 < canvas.width; ++column) {
        const std::size_t i = std::size_t(row) * width + std::size_t(column);
        if (before[i].places > 0)
          continue;
        for (const std::size_t j : {i - 1, i + 1, i - width, i + width, i - width - 1,
                                    i - width + 1, i + width - 1, i + width + 1})
          canvas.cells[i].add(before[j]);
      }
  }
}

std::uint8_t byteOf(float value) {
  return std::uint8_t(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
}

std::uint8_t steppedByte(float value) {
  const int byte = byteOf(value);
  return std::uint8_t(std::min((byte + colourStep / 2) / colourStep * colourStep, 255));
}

Image imageOf(const Canvas& canvas) {
  Image image{.width = canvas.width, .height = canvas.height, .rgba = {}};
  image.rgba.reserve(4 * canvas.cells.size());
  for (int row = canvas.height - 1; row >= 0; --row)
    for (int column = 0; column < canvas.width; ++column) {
      const Cell& cell =
          canvas.cells[std::size_t(row) * std::size_t(canvas.width) + std::size_t(column)];
      const glm::vec3 colour = cell.weight > 0.0f ? cell.colour / cell.weight : glm::vec3(1.0f);
      for (int i = 0; i < 3; ++i)
        image.rgba.push_back(steppedByte(colour[i]));
      image.rgba.push_back(byteOf(cell.places > 0 ? cell.alpha / float(cell.places) : 0.0f));
    }
  return image;
}

class ToneImages {
 public:
  ToneImages(const LayerStack& stack, std::span<const DepthLayer> layers,
             std::span<const std::size_t> ranks)
      : m_stack(stack), m_layers(layers), m_ranks(ranks), m_canvases(layers.size()) {}

  std::vector<ToneImage> make(std::span<const SeenTones> seen) {
    double pixels = 0.0;
    for (std::size_t i = 0; i < m_layers.size(); ++i)
      if (m_layers[i].variesInOpacity())
        pixels += double(seen[i].area.width) * double(seen[i].area.height);
    m_cell = std::clamp(int(std::ceil(std::sqrt(pixels / mostCells))), finestCell, coarsestCell);
    bool any = false;
    for (std::size_t i = 0; i < m_layers.size(); ++i)
      if (m_layers[i].variesInOpacity() && !seen[i].area.empty()) {
        m_canvases[i] = canvasOver(seen[i].area, m_cell);
        any = true;
      }
    if (any)
      parallelFor(std::size_t((m_stack.height() + m_cell - 1) / m_cell), 1,
                  [this](std::size_t row) { drawRow(int(row)); });
    std::vector<ToneImage> images(m_layers.size());
    parallelFor(images.size(), 1, [&](std::size_t i) {
      Canvas& canvas = m_canvases[i];
      if (canvas.empty())
        return;
      extend(canvas);
      images[i].area = {canvas.x * m_cell, canvas.y * m_cell, canvas.width * m_cell,
                        canvas.height * m_cell};
      images[i].image = imageOf(canvas);
    });
    return images;
  }

 private:
  /// Looks at four places of each cell.
  void drawRow(int row) {
    Place place;
    const std::array<int, 2> places{m_cell / 4, (3 * m_cell) / 4};
    for (int column = 0; column * m_cell < m_stack.width(); ++column)
      for (const int dy : places)
        for (const int dx : places) {
          const glm::ivec2 pixel(column * m_cell + dx, row * m_cell + dy);
          if (pixel.x >= m_stack.width() || pixel.y >= m_stack.height())
            continue;
          m_stack.seenAt(pixel.x, pixel.y, place.fills);
          if (std::any_of(place.fills.begin(), place.fills.end(),
                          [this](const SeenFill& fill) { return !m_canvases[fill.layer].empty(); }))
            addPlace({column, row}, pixel, place);
        }
  }

  bool isDrawnHere(const SeenFill& fill, const glm::ivec2& pixel) const {
    if (m_canvases[fill.layer].empty())
      return false;
    const DepthLayer& layer = m_layers[fill.layer];
    return layer.tones[std::size_t(layer.index(pixel.x, pixel.y))] <= layer.firstCapTone;
  }

  /// Adds the fills that are seen at a place, nearest first.
  void addPlace(const glm::ivec2& cell, const glm::ivec2& pixel, Place& place) {
    place.parts.clear();
    float light = 1.0f;
    for (const SeenFill& fill : place.fills) {
      place.parts.push_back({&fill, light * fill.colour.a});
      light *= 1.0f - fill.colour.a;
    }
    std::sort(place.parts.begin(), place.parts.end(), [this](const Part& a, const Part& b) {
      return m_ranks[a.fill->layer] > m_ranks[b.fill->layer];
    });
    float left = 1.0f;  // by what is painted later
    for (const Part& part : place.parts) {
      const SeenFill& fill = *part.fill;
      float alpha = fill.colour.a;
      if (isDrawnHere(fill, pixel)) {
        if (left > 1e-3f)
          alpha = std::min(part.share / left, 1.0f);
        Canvas& canvas = m_canvases[fill.layer];
        if (canvas.contains(cell.x, cell.y)) {
          const float weight = alpha + clearWeight;
          const glm::vec3 colour = glm::vec3(fill.colour) / std::max(fill.colour.a, 1e-4f);
          canvas.at(cell.x, cell.y).add({weight * colour, weight, alpha, 1});
        }
      }
      left *= 1.0f - alpha;
    }
  }

  const LayerStack& m_stack;
  std::span<const DepthLayer> m_layers;
  std::span<const std::size_t> m_ranks;
  int m_cell = finestCell;
  std::vector<Canvas> m_canvases;  ///< empty for layers that shapes draw
};

}  // namespace

std::vector<ToneImage> toneImages(const LayerStack& stack, std::span<const DepthLayer> layers,
                                  std::span<const SeenTones> seen,
                                  std::span<const std::size_t> ranks) {
  return ToneImages(stack, layers, ranks).make(seen);
}

}  // namespace sline::render
