// SPDX-License-Identifier: Apache-2.0
// Counts what is wrong with what is written over a picture: letters and marks that lie over
// anatomy, leaders that run through others, and what two prints of one plate have in different
// places. It goes by the finished plate and by a picture without writing, not by how places are
// chosen.
#pragma once

#include <string>
#include <vector>

#include "render/export/plate/figure_plate.h"
#include "render/raster/image.h"

namespace sline::render {

struct WritingFault {
  enum class Kind {
    overAnatomy,  ///< a mark lies over what is drawn; `pixels`: on how much of it
    labelOver,    ///< so does a label's text
    throughDot,   ///< a leader touches the dot of another label
    throughText,  ///< a leader runs through other letters or a mark
    crossing      ///< two leaders cross
  };
  Kind kind = Kind::overAnatomy;
  std::string item;   ///< the mark's name or the label's text
  std::string other;  ///< whose dot, text or leader is met; empty for anatomy
  int pixels = 0;
};

struct WritingProof {
  std::size_t marks = 0;  ///< written in the picture
  std::size_t labels = 0;
  std::vector<WritingFault> faults;
  int count(WritingFault::Kind kind) const;
  /// Returns how many pixels of anatomy lie under letters and marks.
  int pixels() const;
};

/// Proves the plate of a page of that size, millimetres. `bare` is the picture without anything
/// written, on a transparent ground: what it covers is anatomy. Labels that a person has moved may
/// lie where she wants them.
WritingProof provedWriting(const FigurePlate& plate, const glm::vec2& sizeMm, const Image& bare);

/// Returns in words what stands in one of the plates alone or elsewhere than in the other: names of
/// marks and texts of labels; nothing where both are laid out alike.
std::vector<std::string> writtenElsewhere(const FigurePlate& one, const FigurePlate& other);

}  // namespace sline::render
