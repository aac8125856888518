// SPDX-License-Identifier: Apache-2.0
// Holds the textures that all layers of a picture share: fill and ink, the surface's own depth
// (which hides lines) and the layer's depth (which orders layers).
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
  /// was drawn before counts any more. The result is empty where they do not fit.
  std::vector<PixelRect> layOut(std::span<const gpu::TextureSize> sizes);
  /// Adds a rectangle beside those in use; returns nothing where there is no room.
  std::optional<PixelRect> add(gpu::TextureSize size) {
    return m_packer.place(size.width, size.height);
  }
  /// Tells whether the present textures do not serve the last layout.
  bool outgrown() const;
  /// Releases the textures; returns whether there was anything to release.
  bool release();
  /// Makes the textures that the last layout needs.
  Status allocate();

  const gpu::Texture& colours() const { return *m_colours; }
  const gpu::Texture& inks() const { return *m_inks; }
  const gpu::Texture& surfaceDepths() const { return *m_surfaceDepths; }
  const gpu::Texture& layerDepths() const { return *m_layerDepths; }
  const gpu::Target& surfaceTarget() const { return *m_surfaceTarget; }
  const gpu::Target& inkTarget() const { return *m_inkTarget; }
  /// Returns the target of fills with the layer's depth.
  const gpu::Target& edgeTarget() const { return *m_edgeTarget; }

 private:
  AtlasLimits m_limits;
  ShelfPacker m_packer;
  gpu::TextureSize m_wanted;
  std::unique_ptr<gpu::Texture> m_colours;
  std::unique_ptr<gpu::Texture> m_inks;
  std::unique_ptr<gpu::Texture> m_surfaceDepths;
  std::unique_ptr<gpu::Texture> m_layerDepths;
  std::unique_ptr<gpu::Target> m_surfaceTarget;
  std::unique_ptr<gpu::Target> m_inkTarget;
  std::unique_ptr<gpu::Target> m_edgeTarget;
};

}  // namespace sline::render
