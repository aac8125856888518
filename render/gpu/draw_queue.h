// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "render/gpu/fence.h"
#include "render/raster/pixel_rect.h"

namespace sline::render::gpu {

/// Bounds what a software driver has under way: one batch is drawn while the next is being set up.
/// A driver sets triangles up faster than it fills them, and keeps all that wait in memory (300 MiB
/// for 3 million triangles); and anything that another context draws meanwhile, such as the window
/// itself, has to wait its turn behind it. A graphics card would stand still between batches: its
/// queue has no bounds.
class DrawQueue {
 public:
  /// The largest sizes of a single draw, which cannot be interrupted.
  static constexpr std::size_t mostIndices = 99'999;
  static_assert(mostIndices % 3 == 0, "pieces of a list of triangles hold whole triangles");
  static constexpr std::size_t mostStrokes = 4'000;
  static constexpr int mostLayersOfTiles = 1'600;

  explicit DrawQueue(bool software) : m_bounded(software) {}

  void addTriangles(std::size_t indices) { add(indices); }
  void addStrokes(std::size_t count) { add(24 * count); }
  /// Adds strokes of which is found where they are in sight.
  void addSights(std::size_t count) { add(2 * count); }
  void addCopies(const PixelRect& area) {
    add(std::size_t(area.width) * std::size_t(area.height) / 10);
  }
  /// Adds squares of the resolve pass, which blend so many layers in all.
  void addLayersOfTiles(std::size_t layers) { add(63 * layers); }

 private:
  /// Weights measure what keeps llvmpipe equally long: `longest` is about 10 ms on two cores.
  static constexpr std::size_t longest = 99'999;

  void add(std::size_t work) {
    m_waiting += work;
    if (!m_bounded || m_waiting < longest)
      return;
    auto reached = std::make_unique<Fence>();
    if (m_before)
      m_before->wait();
    m_before = std::move(reached);
    m_waiting = 0;
  }

  bool m_bounded;
  std::size_t m_waiting = 0;
  std::unique_ptr<Fence> m_before;  ///< after the last batch but the one that is waiting
};

}  // namespace sline::render::gpu
