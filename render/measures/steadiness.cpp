// SPDX-License-Identifier: Apache-2.0
#include "render/measures/steadiness.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "model/geometry/spatial_order.h"
#include "render/measures/warp.h"

namespace sline::render {

namespace {

/// The frames of a turn: cameras, and how each frame's surface lies in the one before.
struct Turn {
  std::vector<model::Camera> cameras;
  std::vector<std::vector<WarpedPixel>> warps;  ///< from camera i to camera i + 1
};

Result<Turn> turnOf(const Turntable& table) {
  const model::Bvh bvh(table.mesh, model::spatialOrder(*table.mesh));
  const model::Box& bounds = table.mesh->bounds();
  Turn turn;
  SeenSurface before;
  for (int i = 0; i <= table.frames; ++i) {
    turn.cameras.push_back(turned(table.camera, bounds.centre(), turnStep * float(i)));
    SeenSurface now =
        seenSurface(bvh, PictureView(turn.cameras.back(), bounds, table.width, table.height));
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

/// Adds up differences over pairs of pictures.
struct Sums {
  double change = 0.0;
  double hatchedChange = 0.0;
  std::size_t pixels = 0;
  std::size_t hatched = 0;

  void add(const PixelValues& now, const PixelValues& before, std::span<const WarpedPixel> warps) {
    for (const WarpedPixel& w : warps) {
      const float then = sample(before, w.from);
      const float is = now.values[w.pixel];
      const double difference = std::abs(is - then);
      change += difference;
      if (is > leastInk || then > leastInk) {
        hatchedChange += difference;
        ++hatched;
      }
    }
    pixels += warps.size();
  }
};

Result<Flicker> flickerOf(const Turntable& table, const Turn& turn, const HatchingPicture& draw) {
  Flicker flicker;
  Sums sums;
  PixelValues before;
  for (std::size_t i = 0; i < turn.cameras.size(); ++i) {
    const Result<Image> drawn = draw(turn.cameras[i], table.width, table.height);
    if (!drawn)
      return drawn.error();
    PixelValues now = ink(*drawn);
    if (i == 0)
      flicker.midTones = midToneShare(*drawn);
    else
      sums.add(now, before, turn.warps[i - 1]);
    before = std::move(now);
  }
  const Result<Image> doubled = draw(table.camera, 2 * table.width, 2 * table.height);
  if (!doubled)
    return doubled.error();
  flicker.midTonesDoubled = midToneShare(*doubled);
  flicker.overSurface = sums.change / double(sums.pixels);
  flicker.overHatching = sums.hatched > 0 ? sums.hatchedChange / double(sums.hatched) : 0.0;
  flicker.hatchedShare = double(sums.hatched) / double(sums.pixels);
  return flicker;
}

std::optional<double> share(double part, double whole) {
  return whole > 0.0 ? std::optional(part / whole) : std::nullopt;
}

std::string percent(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.0f %%", 100.0 * value);
  return text.data();
}

}  // namespace

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
                                            std::span<const HatchingPicture> ways) {
  const Result<Turn> turn = turnOf(turntable);
  if (!turn)
    return turn.error();
  std::vector<Flicker> result;
  for (const HatchingPicture& draw : ways) {
    const Result<Flicker> flicker = flickerOf(turntable, *turn, draw);
    if (!flicker)
      return flicker.error();
    result.push_back(*flicker);
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

std::vector<std::string> faults(const Steadiness& steadiness) {
  std::vector<std::string> found;
  for (const auto& [flicker, name] :
       {std::pair(&steadiness.strokes, "strokes"), {&steadiness.asPrinted, "as printed"}})
    if (!flicker->anyHatching())
      found.push_back(std::string(name) + ": no hatching shows");
  if (const auto ratio = steadiness.ratio(); ratio && *ratio > flickerLimit)
    found.push_back("strokes: change " + percent(*ratio) +
                    " as much as hatching as printed, not at most " + percent(flickerLimit));
  for (const auto& [middle, size] : {std::pair(steadiness.strokes.midTones, ""),
                                     {steadiness.strokes.midTonesDoubled, " at twice the size"}})
    if (middle > midToneLimit)
      found.push_back("strokes: " + percent(middle) + " of hatched pixels are mid-tones" + size +
                      ", not at most " + percent(midToneLimit));
  return found;
}

}  // namespace sline::render
