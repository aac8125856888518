// SPDX-License-Identifier: Apache-2.0
// Lays out what is written over a film's frames, so that it holds still while the film is watched:
// all frames are known before the first is drawn.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "render/export/motion/film.h"
#include "render/export/motion/film_label.h"
#include "render/export/plate/figure_plate.h"

namespace sline::render {

class FilmLabels {
 public:
  /// The order must outlive this object.
  explicit FilmLabels(const ExportOrder& order) : m_order(order) {}

  /// Finds the room that marks take in any of the frames, on which side each label stands, and
  /// where it stands in each frame. Marks stay in one place, clear of what any frame shows; on the
  /// way of a tour there is nothing but whose work it is and what the view says, both where they
  /// stand while it rests. A label changes sides at most once in eight seconds, and in a
  /// film that loops never; it is there or gone for a second at least. A tour has the labels of
  /// each view's still where it rests there, and none on its way: what they name is hidden and
  /// seen again in between. `go` receives the share that is done; if it returns false, this does,
  /// with nothing found.
  bool settle(const Film& film, const std::function<bool(double)>& go);
  /// Returns what is written over the frame; `settle` must have been called.
  FigurePlate plateOf(const Film& film, int frame) const;
  /// Returns the same for a frame as if there were no others.
  FigurePlate alone(const Film& film, int frame);

 private:
  ExportOrder orderOf(const FilmFrame& frame) const;
  Screen screenOf(const FilmFrame& frame) const;
  LabelStyle style() const;
  /// Finds what any of the frames shows; returns false where `go` does.
  bool lookAtAnatomy(const Film& film, const std::function<bool(double)>& go);
  Marks marksOfFrame(const Film& film, const FilmFrame& frame) const;
  bool settleRests(const Film& film, const std::function<bool(double)>& go);
  void keepMarksFree(const Film& film);
  /// Looks for the labels' places in all frames.
  bool lookAt(const Film& film, const std::function<bool(double)>& go);
  void layOut(const Film& film);
  /// Lays out all frames; returns false where a label that should be there found no way, and says
  /// so in `there`.
  bool layOutAll(std::vector<FilmLabel>& labels, const std::vector<LabelRequest>& frames,
                 float textWidth);

  const ExportOrder& m_order;
  model::MeshTrees m_trees;
  EdgeRoom m_edges;               ///< the room that marks take in any frame: labels keep out of it
  std::vector<LabelBox> m_boxes;  ///< and their boxes
  std::optional<SeenArea> m_drawn;             ///< what any frame shows
  PlacePool m_pool;                            ///< the places where labels may point
  std::vector<LabelSights> m_sights;           ///< of each frame, until they are laid out
  std::vector<LabelPlate> m_plates;            ///< of each frame
  std::map<std::size_t, FigurePlate> m_rests;  ///< of a tour: of each view at which it rests
};

}  // namespace sline::render
