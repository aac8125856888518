// SPDX-License-Identifier: Apache-2.0
// Draws into the ink of layers what is found pixel by pixel: hatching as S prints it, and noise
// along the curvature. Programs and textures are made when a picture first asks for them.
#pragma once

#include "render/passes/hatching/hatching_pass.h"
#include "render/passes/hatching/noise_lic_pass.h"
#include "render/picture/atlas.h"
#include "render/picture/layer.h"

namespace sline::render {

/// Tells whether a structure of that style is hatched as S prints it, or by noise.
bool showsPrintedHatching(const model::ResolvedStyle& style, const PictureSettings& settings);
/// Returns the pixels around a region in which a search that starts within it may end.
int printedHatchingReach(const PictureView& view);

class PrintedHatching {
 public:
  /// What is hatched and how it is seen; `light` is the direction towards the light in the camera's
  /// frame.
  struct Sight {
    const PictureView& view;
    const Atlas& atlas;
    const glm::vec3& light;
  };
  /// Hatches those of the changed layers that need it, after their surfaces have been drawn. The
  /// error says what the driver lacks.
  Status draw(gpu::Device& device, const Sight& sight, std::span<const Layer> layers,
              std::span<const std::size_t> changed);

 private:
  Status prepare(gpu::TextureSize size);
  Status preparePass(const gpu::Device& device, const PreparedStructure& shown);
  void draw(gpu::Device& device, const Sight& sight, const Layer& layer) const;

  std::unique_ptr<passes::HatchingPass> m_pass;
  std::unique_ptr<passes::NoiseLicPass> m_noise;
  std::unique_ptr<gpu::Texture> m_fields;
  std::unique_ptr<gpu::Texture> m_depths;
  std::unique_ptr<gpu::Target> m_target;
};

}  // namespace sline::render
