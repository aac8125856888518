// SPDX-License-Identifier: Apache-2.0
// Blends the layers of an atlas into the picture, exactly for any number of overlapping layers and
// independently of the order in which they were drawn (METHOD §10).
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <memory>
#include <vector>

#include "model/base/units.h"
#include "render/gpu/device.h"
#include "render/raster/outline_look.h"
#include "render/raster/tile_mask.h"

namespace sline::render::passes {

/// One layer in one tile's list.
struct ResolveEntry {
  std::int32_t offset = 0;
  std::int32_t look = 0;
};

struct ResolveLayer {
  PixelRect area;   ///< in pixels of the target, y upwards, within it
  int offsetX = 0;  ///< from pixels of the target to pixels of the atlas
  int offsetY = 0;
  Colour ink;
  bool filled = false;  ///< has colour
  bool inked = false;
  bool hiddenInk = false;  ///< has lines that show through what lies before them
  bool haloed = false;     ///< keeps lines behind it away from its outline
};
/// Packs a layer. Offsets must lie within ±32767.
ResolveEntry resolveEntry(const ResolveLayer& layer);

/// A rectangle of the target and its layers: entries first … first + count − 1, in order of their
/// ids. Each of them covers all of it.
struct ResolveTile {
  std::int32_t corner = 0;  ///< x, and y in the upper 16 bits
  std::int32_t size = 0;    ///< likewise width and height
  std::int32_t first = 0;
  std::int32_t count = 0;
  std::array<std::int32_t, 12> offsets{};  ///< of the first of them
};
/// Returns the tile of the entries from `first` on. The rectangle must lie within 65535 pixels.
ResolveTile resolveTile(const PixelRect& rectangle, std::span<const ResolveEntry> entries,
                        std::size_t first);

struct ResolveInputs {
  const gpu::Texture& colours;  ///< premultiplied fills
  const gpu::Texture& inks;
  const gpu::Texture& depths;  ///< 1 where a layer has nothing
  glm::vec4 background{0.0f};  ///< premultiplied
  bool keepOthers = false;     ///< pixels outside all tiles stay as they are
};

/// Describes a line around marked structures.
struct OutlineInputs {
  const gpu::Texture& numbers;  ///< of the region; red: which marked structure, 0 for none
  const gpu::Texture& numberDepths;
  const gpu::Texture& colours;  ///< as in ResolveInputs
  const gpu::Texture& depths;
  PixelRect region;  ///< its place in the target
  OutlineLook look;
};

class ResolvePass {
 public:
  static constexpr int tileSide = TileMask::side;
  static Result<std::unique_ptr<ResolvePass>> create(gpu::Dialect dialect);

  Status upload(std::span<const ResolveTile> tiles, std::span<const ResolveEntry> entries);
  /// Draws the layers. Pixels outside all tiles become background, unless they are to stay. The GPU
  /// gets batches of tiles, a few at a time, so that another context's drawing gets its turn.
  void draw(gpu::Device& device, const gpu::Target& target, const ResolveInputs& inputs);
  /// Draws the line over what the target has, in the tiles that were uploaded; their layers hide
  /// it.
  void drawOutlines(gpu::Device& device, const gpu::Target& target, const OutlineInputs& inputs);

 private:
  ResolvePass();
  static constexpr int rowBits = 10;
  static constexpr int entriesPerRow = 1 << rowBits;
  /// Sets what the program for tiles of one layer and that for all others read alike.
  void set(const gpu::Program& program, gpu::TextureSize size, const ResolveInputs& inputs) const;
  struct TilePrograms {
    const gpu::Program& one;  ///< for tiles of one layer
    const gpu::Program& others;
  };
  void drawTiles(gpu::Device& device, const gpu::Target& target, const TilePrograms& programs,
                 const gpu::DrawState& state);
  std::unique_ptr<gpu::Program> m_one;
  std::unique_ptr<gpu::Program> m_program;
  std::unique_ptr<gpu::Program> m_outline;
  gpu::Buffer m_tiles;
  gpu::Geometry m_geometry;
  std::unique_ptr<gpu::Texture> m_offsets;
  std::unique_ptr<gpu::Texture> m_looks;
  bool m_hiddenLines = false;          ///< an entry has some
  std::size_t m_singles = 0;           ///< tiles of one layer, which come first
  std::vector<std::size_t> m_batches;  ///< the end of each batch, after its last tile
};

}  // namespace sline::render::passes
