// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "render/export/motion/film.h"
#include "render/raster/image.h"

namespace sline::render {

/// Draws a film's frames one after the other: what can be kept from one to the next is, and labels
/// start from where they were.
class FilmPainter {
 public:
  /// Makes a context without a display, and what text needs. The order must outlive it.
  static Result<std::unique_ptr<FilmPainter>> create(const ExportOrder& order);
  ~FilmPainter();

  /// What of the width and the height labels and marks leave to the anatomy.
  glm::vec2 anatomyShare() const;
  /// Finds what room marks take in any of the frames, and where labels stand when the film comes
  /// round: of one that loops, the first frame follows the last as any other.
  void settle(const Film& film);
  Result<Image> draw(const Film& film, int frame);
  /// Of all frames that were drawn: labels and marks that were in none of them.
  ExportNotes notes() const;
  /// The same, but as if no other frame was before it: for a look at the film.
  Result<Image> drawAlone(const Film& film, int frame);

 private:
  struct Data;
  explicit FilmPainter(std::unique_ptr<Data> data);
  std::unique_ptr<Data> m_data;
};

}  // namespace sline::render
