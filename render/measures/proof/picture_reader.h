// SPDX-License-Identifier: Apache-2.0
// Reads from a picture how much it shows of each structure, in which colour, and next to which
// others.
#pragma once

#include <memory>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/export/order/export_order.h"

namespace sline::render {

struct SeenStructure {
  model::NodeId id;
  double share = 0.0;     ///< area, as a share of the picture
  glm::vec3 light{0.0f};  ///< mean of what is drawn there, linear light
  float gamma = 0.0f;
  bool coloured = false;  ///< whether its own colour shows
  Colour colour;          ///< its own colour, whether it shows or not
  bool locked = false;    ///< its look must not change
};

/// A border along which two structures lie side by side in the picture.
struct SharedBorder {
  std::size_t a = 0;  ///< index of a structure
  std::size_t b = 0;
  double length = 0.0;  ///< as a share of the picture's longer side
};

struct SeenPicture {
  std::vector<SeenStructure> structures;  ///< those that are seen, by id
  std::vector<SharedBorder> borders;
};

/// Looks at the scene of an order, unchanged or changed.
class PictureReader {
 public:
  /// Makes an OpenGL context on the calling thread; `read` must be called on the same thread.
  static Result<std::unique_ptr<PictureReader>> create();
  ~PictureReader();
  PictureReader(const PictureReader&) = delete;
  PictureReader& operator=(const PictureReader&) = delete;

  /// Draws the order at a small size with `scene` instead of its own. A place belongs to the
  /// nearest structure that hides what is behind it, or else to the nearest of all.
  Result<SeenPicture> read(const ExportOrder& order, const model::Scene& scene);

 private:
  struct Data;
  explicit PictureReader(std::unique_ptr<Data> data);
  std::unique_ptr<Data> m_data;
};

}  // namespace sline::render
