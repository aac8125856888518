// SPDX-License-Identifier: Apache-2.0
#include "render/measures/steadiness.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "model/geometry/mesh_trees.h"
#include "render/measures/warp.h"

namespace sline::render {

namespace {

constexpr double widestPicture = 20000.0;

/// Holds the frames of a turn: cameras, and how each frame's surface lies in the one before.
struct Turn {
  std::vector<model::Camera> cameras;
  std::vector<std::vector<WarpedPixel>> warps;  ///< from camera i to camera i + 1
};

Result<Turn> turnOf(const Turntable& table) {
  const model::BvhPtr bvh = model::treeOf(table.mesh);
  const model::Box& bounds = table.mesh->bounds();
  Turn turn;
  SeenSurface before;
  for (int i = 0; i <= table.frames; ++i) {
    turn.cameras.push_back(turned(table.camera, bounds.centre(), turnStep * float(i)));
    SeenSurface now =
        seenSurface(*bvh, PictureView(turn.cameras.back(), bounds, table.width, table.height));
    if (i > 0) {
      const PictureView viewBefore(turn.cameras[std::size_t(i - 1)], bounds, table.width,
                                   table.height);
      turn.warps.push_back(warp(now, before, viewBefore));
      if (turn.warps.back().empty())
        return Error{.reason = "two neighbouring pictures show no surface in common",
                     .remedy = "Choose a camera that sees more of it, or a larger picture"};
    }
    before = std::move(now);
  }
  return turn;
}

/// A picture drawn at a multiple of the size, but read in pixels of the size itself.
struct Fine {
  int factor = 1;
  PixelValues values;

  /// Returns the mean of a pixel's samples.
  float pixel(std::size_t index) const {
    const std::size_t width = std::size_t(values.width / factor);
    const int x = factor * int(index % width);
    const int y = factor * int(index / width);
    float sum = 0.0f;
    for (int i = 0; i < factor * factor; ++i)
      sum += values.at(x + i % factor, y + i / factor);
    return sum / float(factor * factor);
  }

  /// Returns the mean for a pixel around any place. A turn of half a degree moves a pixel's samples
  /// all alike, apart from a hundredth of their distance.
  float around(const glm::vec2& place) const {
    float sum = 0.0f;
    for (int i = 0; i < factor * factor; ++i) {
      const glm::vec2 offset(i % factor, i / factor);
      sum += sample(values, float(factor) * place + offset - 0.5f * float(factor - 1));
    }
    return sum / float(factor * factor);
  }
};

/// Adds up differences over pairs of pictures.
struct Sums {
  double change = 0.0;
  double hatchedChange = 0.0;
  double ink = 0.0;
  std::size_t pixels = 0;
  std::size_t hatched = 0;

  void add(const Fine& now, const Fine& before, std::span<const WarpedPixel> warps) {
    for (const WarpedPixel& w : warps) {
      const float then = before.around(w.from);
      const float is = now.pixel(w.pixel);
      const double difference = std::abs(is - then);
      change += difference;
      ink += 0.5 * (is + then);
      if (is > leastInk || then > leastInk) {
        hatchedChange += difference;
        ++hatched;
      }
    }
    pixels += warps.size();
  }
};

Result<Flicker> flickerOf(const Turntable& table, const Turn& turn, const HatchingWay& way) {
  Flicker flicker;
  Sums sums;
  Fine before;
  for (std::size_t i = 0; i < turn.cameras.size(); ++i) {
    const Image drawn = TRY(
        way.draw(turn.cameras[i], way.oversampling * table.width, way.oversampling * table.height));
    Fine now{way.oversampling, ink(drawn)};
    if (i > 0)
      sums.add(now, before, turn.warps[i - 1]);
    before = std::move(now);
  }
  for (const auto& [share, size] :
       {std::pair(&flicker.midTones, PictureSize{table.width, table.height}),
        {&flicker.midTonesInPrint, printSize(table)}}) {
    const Image drawn = TRY(way.draw(table.camera, size.width, size.height));
    *share = midToneShare(drawn);
  }
  flicker.overSurface = sums.change / double(sums.pixels);
  flicker.ink = sums.ink / double(sums.pixels);
  flicker.overHatching = sums.hatched > 0 ? sums.hatchedChange / double(sums.hatched) : 0.0;
  flicker.hatchedShare = double(sums.hatched) / double(sums.pixels);
  return flicker;
}

std::optional<double> share(double part, double whole) {
  return whole > 0.0 ? std::optional(part / whole) : std::nullopt;
}

std::string wholePercent(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.0f %%", 100.0 * value);
  return text.data();
}

}  // namespace

PictureSize printSize(const Turntable& turntable) {
  const double aspect = double(turntable.width) / double(turntable.height);
  const double height = std::min(double(turntable.printHeight), widestPicture / aspect);
  const auto whole = [](double length) { return std::max(1, int(std::lround(length))); };
  return {whole(height * aspect), whole(height)};
}

model::Camera turned(const model::Camera& camera, const glm::vec3& middle, float degrees) {
  const glm::mat4 turn =
      glm::rotate(glm::mat4(1.0f), glm::radians(degrees), model::cameraFrame(camera).up);
  const auto around = [&](const glm::vec3& p) {
    return middle + glm::vec3(turn * glm::vec4(p - middle, 0.0f));
  };
  model::Camera result = camera;
  result.eye = around(camera.eye);
  result.target = around(camera.target);
  result.up = glm::vec3(turn * glm::vec4(camera.up, 0.0f));
  return result;
}

Result<std::vector<Flicker>> measureFlicker(const Turntable& turntable,
                                            std::span<const HatchingWay> ways) {
  const Turn turn = TRY(turnOf(turntable));
  std::vector<Flicker> result;
  for (const HatchingWay& way : ways) {
    const Flicker flicker = TRY(flickerOf(turntable, turn, way));
    result.push_back(flicker);
  }
  return result;
}

double midToneShare(const Image& image) {
  std::size_t hatched = 0;
  std::size_t middle = 0;
  for (const float value : ink(image).values) {
    hatched += value > leastInk;
    middle += value >= lightestMidTone && value <= darkestMidTone;
  }
  return hatched > 0 ? double(middle) / double(hatched) : 0.0;
}

std::optional<double> Steadiness::ratio() const {
  return strokes.anyHatching() ? share(strokes.overSurface, asPrinted.overSurface) : std::nullopt;
}

std::optional<double> Steadiness::hatchedRatio() const {
  return strokes.anyHatching() ? share(strokes.overHatching, asPrinted.overHatching) : std::nullopt;
}

std::optional<double> Steadiness::inkRatio() const {
  const std::optional<double> most = share(asPrinted.overSurface, asPrinted.ink);
  const std::optional<double> least = share(strokes.overSurface, strokes.ink);
  return most && least ? share(*least, *most) : std::nullopt;
}

std::vector<std::string> faults(const Steadiness& steadiness) {
  std::vector<std::string> found;
  for (const auto& [flicker, name] :
       {std::pair(&steadiness.strokes, "strokes"), {&steadiness.asPrinted, "as printed"}})
    if (!flicker->anyHatching())
      found.push_back(std::string(name) + ": no hatching shows");
  if (const auto ratio = steadiness.inkRatio(); ratio && *ratio > flickerLimit)
    found.push_back("strokes: change " + wholePercent(*ratio) +
                    " as much as hatching as printed does for as much ink, not at most " +
                    wholePercent(flickerLimit));
  if (const double middle = steadiness.strokes.midTonesInPrint; middle > midToneLimit)
    found.push_back("strokes: " + wholePercent(middle) +
                    " of hatched pixels are mid-tones in print, not at most " +
                    wholePercent(midToneLimit));
  return found;
}

}  // namespace sline::render
