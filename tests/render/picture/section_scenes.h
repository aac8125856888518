// SPDX-License-Identifier: Apache-2.0
// Makes scenes with section planes, and finds colours in pictures of them.
#pragma once

#include <functional>

#include "model/edit/sections.h"
#include "tests/render/picture/scenes.h"

namespace sline::test {

inline constexpr Colour red{200, 40, 40};
inline constexpr Colour blue{40, 60, 200};

inline model::Style styled(float gamma, const Colour& colour) {
  model::Style style = gammaStyle(gamma);
  style.colour = colour;
  return style;
}

inline void cut(model::Scene& scene, model::AnatomicalView kept, float mm,
                model::NodeId scope = model::rootId) {
  scene.appendSection(model::anatomicalSection(scene, scope, kept, mm));
}

/// Tints all cut faces. Else that of a ball around others is blank, as nobody knows what it holds.
inline void tintFaces(model::Scene& scene) {
  std::vector<model::Section> sections = scene.sections();
  for (model::Section& section : sections)
    section.faces = model::CutFaces::tint;
  scene.setSections(std::move(sections));
}

/// Each tells whether a pixel is redder than it is blue, or the other way.
inline bool reddish(const Pixel& p) {
  return p.red > p.blue + 24;
}
inline bool bluish(const Pixel& p) {
  return p.blue > p.red + 24;
}

struct Spot {
  int count = 0;
  double x = 0.0;
  double y = 0.0;
};
inline Spot spot(const render::Image& image, const std::function<bool(const Pixel&)>& wanted) {
  Spot found;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (wanted(pixelAt(image, x, y))) {
        ++found.count;
        found.x += x + 0.5;
        found.y += y + 0.5;
      }
  found.x /= std::max(found.count, 1);
  found.y /= std::max(found.count, 1);
  return found;
}

inline bool drawn(const Pixel& p) {
  return p.grey() < 240;
}

/// Returns a ball cut in the middle of its front, beside it a ring and a tube.
inline model::Scene crowd(float gamma) {
  model::Scene scene;
  add(scene, moved(*sphere(30.0f, 4), 1.0f, {-28, 0, 5}), styled(gamma, red));
  add(scene, moved(*torus(26.0f, 9.0f, 80, 40), 1.0f, {22, 4, -8}), styled(gamma, blue));
  add(scene, moved(*sphere(16.0f, 4), 1.0f, {-22, 2, 8}), styled(gamma, {40, 160, 80}));
  add(scene, moved(*cylinder(8.0f, 60.0f, 40, 30), 1.0f, {30, -6, 4}), styled(gamma, red));
  return scene;
}

}  // namespace sline::test
