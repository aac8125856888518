// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "render/export/motion/film.h"
#include "render/raster/image.h"

namespace sline::render {

/// Draws a film's frames one after the other. It keeps what it can from one frame to the next.
class FilmPainter {
 public:
  /// Makes a context without a display and what text needs. The order must outlive the painter.
  static Result<std::unique_ptr<FilmPainter>> create(const ExportOrder& order);
  ~FilmPainter();

  /// Returns the share of the width and the height that labels and marks leave to the anatomy.
  glm::vec2 anatomyShare() const;
  /// Finds where labels stand in each frame, which must be done before frames are drawn. `go`
  /// receives the share that is done; if it returns false, so does this.
  bool settle(const Film& film, const std::function<bool(double)>& go);
  Result<Image> draw(const Film& film, int frame);
  /// Returns the labels and marks that were in none of the frames drawn.
  ExportNotes notes() const;
  /// Draws a frame as if there were no other before it, for a glance at the film.
  Result<Image> drawAlone(const Film& film, int frame);

 private:
  struct Data;
  explicit FilmPainter(std::unique_ptr<Data> data);
  std::unique_ptr<Data> m_data;
};

}  // namespace sline::render
