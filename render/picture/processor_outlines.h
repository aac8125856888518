// SPDX-License-Identifier: Apache-2.0
// Draws lines around structures on the processor, over pictures whose layers it drew, and keeps
// them while nothing changes that they depend on.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "render/picture/layer.h"
#include "render/picture/picture.h"
#include "render/software/outline_raster.h"

namespace sline::render {

struct PictureInput;

OutlineLook lookOf(const Outline& outline);

/// Gives structures numbers from 1 to 255, by their places in the list and then from 1 again.
class OutlinedNumbers {
 public:
  explicit OutlinedNumbers(std::span<const PreparedStructure> outlined);

  static int at(std::size_t place) { return int(place % 255) + 1; }
  int of(model::NodeId id) const;
  /// Returns the number of the layer's only structure, which does not hide itself; else 0.
  int of(const Layer& layer) const;

 private:
  std::map<model::NodeId, int> m_numbers;
};

/// Returns the fill that marks a surface with its number.
SurfaceFill numberFill(int number);

class ProcessorOutlines {
 public:
  /// A line around structures, in an area of the picture.
  struct Drawn {
    PixelRect area;
    const OutlineInk* ink = nullptr;  ///< null: a driver must, as something reaches behind the eye
  };
  /// Draws the line around the structures. Layers are those of the picture, in the region that was
  /// drawn; what is returned stays until the next line is drawn.
  Drawn draw(const PictureInput& input, std::span<const PreparedStructure> structures,
             std::span<const Layer> layers, const PixelRect& region, const OutlineLook& look);
  /// Tells that another picture from the same place follows: lines of the one before the last are
  /// forgotten.
  void next();
  /// Forgets all, as pictures are seen from elsewhere.
  void forget() { m_kept.clear(); }

 private:
  struct Kept {
    std::vector<PreparedStructure> structures;
    OutlineLook look;
    bool known = false;                 ///< where they are; else a driver draws
    std::vector<std::uint64_t> hiding;  ///< the layers' drawings
    MarkedPixels marks;
    OutlineInk ink;
    bool used = true;
  };
  Kept& marked(const PictureInput& input, std::span<const PreparedStructure> structures,
               const PixelRect& region, const OutlineLook& look);

  std::vector<Kept> m_kept;
};

}  // namespace sline::render
