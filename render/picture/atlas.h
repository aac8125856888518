// SPDX-License-Identifier: Apache-2.0
// Holds the textures that all layers of a picture share: fill and ink, the surface's own depth
// (which hides lines) and the layer's depth (which orders layers). Where surfaces have a step, they
// have textures of their own, in which everything lies at one `step`th of its place.
#pragma once

#include <memory>
#include <span>

#include "render/gpu/device.h"
#include "render/picture/shelf_packer.h"

namespace sline::render {

struct AtlasLimits {
  int side = 0;            ///< largest width and height
  std::size_t pixels = 0;  ///< largest area
  bool deep = false;       ///< colours have 16 bits per channel
};

/// Rounds a texture's width or height up to a multiple of 256, so that few sizes occur.
int roundedToStep(int pixels);

class Atlas {
 public:
  explicit Atlas(const AtlasLimits& limits) : m_limits(limits) {}

  /// Lays out all rectangles afresh: places are returned in the order of `sizes`, and nothing that
  /// was drawn before counts any more. The result is empty where they do not fit. Surfaces will be
  /// drawn with the step (see PictureSettings).
  std::vector<PixelRect> layOut(std::span<const gpu::TextureSize> sizes, int surfaceStep);
  /// Adds a rectangle beside those in use; returns nothing where there is no room.
  std::optional<PixelRect> add(gpu::TextureSize size) {
    return m_packer.place(size.width, size.height);
  }
  /// Tells whether the present textures do not serve the last layout.
  bool outgrown() const;
  /// Releases the textures; returns whether there was anything to release.
  bool release();
  /// Makes those textures that the last layout needs and that are not there.
  Status allocate();

  const gpu::Texture& colours() const { return *m_colours; }
  const gpu::Texture& inks() const { return *m_inks; }
  const gpu::Texture& surfaceDepths() const {
    return coarse() ? *m_coarseDepths : *m_surfaceDepths;
  }
  /// Returns the fills before they are enlarged; only where surfaces have a step.
  const gpu::Texture& coarseColours() const { return *m_coarseColours; }
  const gpu::Texture* enlargedFills() const { return coarse() ? m_coarseColours.get() : nullptr; }
  const gpu::Texture& layerDepths() const { return *m_layerDepths; }
  const gpu::Target& surfaceTarget() const { return coarse() ? *m_coarseTarget : *m_surfaceTarget; }
  const gpu::Target& inkTarget() const { return *m_inkTarget; }
  /// Returns the target of fills with the layer's depth.
  const gpu::Target& edgeTarget() const { return *m_edgeTarget; }

 private:
  bool coarse() const { return m_surfaceStep > 1; }
  Status allocateFine();
  Status allocateCoarse();

  AtlasLimits m_limits;
  ShelfPacker m_packer;
  int m_surfaceStep = 1;
  gpu::TextureSize m_wanted;
  std::unique_ptr<gpu::Texture> m_colours;
  std::unique_ptr<gpu::Texture> m_inks;
  std::unique_ptr<gpu::Texture> m_surfaceDepths;
  std::unique_ptr<gpu::Texture> m_layerDepths;
  std::unique_ptr<gpu::Texture> m_coarseColours;
  std::unique_ptr<gpu::Texture> m_coarseDepths;
  std::unique_ptr<gpu::Target> m_surfaceTarget;
  std::unique_ptr<gpu::Target> m_inkTarget;
  std::unique_ptr<gpu::Target> m_edgeTarget;
  std::unique_ptr<gpu::Target> m_coarseTarget;
};

}  // namespace sline::render
