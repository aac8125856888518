// SPDX-License-Identifier: Apache-2.0
#include "tests/render/picture/scenes.h"

#include <algorithm>
#include <cstdlib>

namespace sline::test {

using render::Image;

Studio openStudio(const render::PictureOptions& options) {
  Studio studio;
  auto context = render::gpu::HeadlessContext::create();
  if (!context) {
    studio.absent = context.error().text();
    return studio;
  }
  studio.context = std::move(*context);
  auto picture = render::Picture::create(options);
  if (!picture)
    studio.fault = picture.error().text();
  else
    studio.picture = std::move(*picture);
  return studio;
}

model::NodeId add(model::Scene& scene, model::MeshPtr mesh, const model::Style& style) {
  model::Node node;
  node.name = "shape";
  node.style = style;
  node.mesh = std::move(mesh);
  return scene.append(std::move(node));
}

model::Style gammaStyle(float gamma) {
  model::Style style;
  style.gamma = Gamma::clamped(gamma);
  style.lineVariation = 0.0f;  // widths are measured
  return style;
}

model::Camera frontal(float heightMm) {
  return {.projection = model::Projection::orthographic,
          .eye = {0.0f, -1000.0f, 0.0f},
          .target = {0.0f, 0.0f, 0.0f},
          .up = {0.0f, 0.0f, 1.0f},
          .heightMm = heightMm};
}

Pixel pixelAt(const Image& image, int x, int y) {
  const std::uint8_t* p = image.rgba.data() + 4 * (std::size_t(y) * image.width + x);
  return {p[0], p[1], p[2], p[3]};
}

float inkAt(const Image& image, int x, int y) {
  return 1.0f - float(pixelAt(image, x, y).grey()) / 255.0f;
}

Difference difference(const Image& a, const Image& b) {
  Difference d;
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    int largest = 0;
    for (std::size_t k = i; k < i + 4; ++k) {
      const int by = std::abs(int(a.rgba[k]) - int(b.rgba[k]));
      largest = std::max(largest, by);
      d.mean += by;
    }
    d.largest = std::max(d.largest, largest);
    pixels += largest > 8;
  }
  d.mean /= double(a.rgba.size());
  d.share = 4.0 * double(pixels) / double(a.rgba.size());
  return d;
}

Image mirroredImage(const Image& image) {
  Image mirrored = image;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      std::copy_n(
          image.rgba.begin() + 4 * (std::ptrdiff_t(y) * image.width + x), 4,
          mirrored.rgba.begin() + 4 * (std::ptrdiff_t(y) * image.width + image.width - 1 - x));
  return mirrored;
}

Image halved(const Image& image) {
  Image half{.width = image.width / 2, .height = image.height / 2, .rgba = {}};
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x)
      for (int k = 0; k < 4; ++k) {
        int sum = 2;
        for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}})
          sum += image.rgba[4 * (std::size_t(2 * y + dy) * image.width + 2 * x + dx) + k];
        half.rgba.push_back(std::uint8_t(sum / 4));
      }
  return half;
}

}  // namespace sline::test
