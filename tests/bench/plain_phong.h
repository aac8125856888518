// SPDX-License-Identifier: Apache-2.0
// Draws the benchmark's yardstick: one opaque Phong pass of the visible structures straight to a
// target, without layers or lines.
#pragma once

#include <map>
#include <memory>

#include "render/drawn/picture_settings.h"
#include "render/gpu/target.h"
#include "render/passes/plain_phong/plain_phong_pass.h"

namespace sline::bench {

class PlainPhong {
 public:
  /// Needs a current context, as `Picture` does.
  static Result<std::unique_ptr<PlainPhong>> create(int width, int height);

  /// Draws, and waits for the GPU. Surfaces are uploaded when they are first drawn.
  void draw(const model::Scene& scene, const model::Camera& camera);

 private:
  PlainPhong() = default;
  render::passes::SurfaceGeometry& geometryOf(const model::Node& node);

  std::unique_ptr<render::gpu::Device> m_device;
  std::unique_ptr<render::passes::PlainPhongPass> m_pass;
  std::unique_ptr<render::gpu::Texture> m_colour;
  std::unique_ptr<render::gpu::Texture> m_depth;
  std::unique_ptr<render::gpu::Target> m_target;
  std::map<model::MeshPtr, std::unique_ptr<render::passes::SurfaceGeometry>> m_geometry;
};

}  // namespace sline::bench
