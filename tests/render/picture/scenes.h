// SPDX-License-Identifier: Apache-2.0
// Makes small scenes, and compares pictures of them.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "render/gpu/headless/context.h"
#include "render/picture/picture.h"
#include "tests/support/shapes.h"

namespace sline::test {

/// Holds a context and a picture in it, or why there is none.
struct Studio {
  std::unique_ptr<render::gpu::HeadlessContext> context;
  std::unique_ptr<render::Picture> picture;
  std::string absent;  ///< set if there is no driver: tests skip
  std::string fault;   ///< set if there is a driver, but no picture: tests fail
};
Studio openStudio(const render::PictureOptions& options = {});

/// Adds a structure of that shape at the top of the scene.
model::NodeId add(model::Scene& scene, model::MeshPtr mesh, const model::Style& style);
model::Style gammaStyle(float gamma);
/// Returns an orthographic camera along +y, `heightMm` high, that looks at the origin: x to the
/// right, z up.
model::Camera frontal(float heightMm);

struct Pixel {
  int red, green, blue, alpha;
  /// Returns 0 for black … 255 for white.
  int grey() const { return (red + green + blue) / 3; }
};
Pixel pixelAt(const render::Image& image, int x, int y);
/// Returns the share of ink on a white picture: 1 − grey/255.
float inkAt(const render::Image& image, int x, int y);
/// Tells how far two pictures of one size are apart.
struct Difference {
  int largest = 0;     ///< in any channel
  double mean = 0.0;   ///< over all channels
  double share = 0.0;  ///< share of pixels that differ by more than 8
};
Difference difference(const render::Image& a, const render::Image& b);
render::Image mirroredImage(const render::Image& image);
/// Returns the image with every 2×2 pixels averaged.
render::Image halved(const render::Image& image);

}  // namespace sline::test
