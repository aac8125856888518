// SPDX-License-Identifier: Apache-2.0
// Holds slides before they are written: what stands on each, laid out as in every other picture.
#pragma once

#include <string>
#include <vector>

#include "render/export/slides/slide_page.h"
#include "render/lettering/lettering.h"

namespace sline::render {

/// Holds words, and the BCP 47 tag of their language; empty: the scene's own, which is not known.
struct SlideWords {
  std::string text;
  std::string language;
};

/// A drawing without labels and marks, as a document and as a picture for programs that show none.
struct SlidePicture {
  std::string svg;
  std::string png;
};

/// Holds one label's or mark's shapes and text in millimetres of the figure's page.
struct SlideLabel {
  LetteringItem item;
  std::string language;
};

struct SlideKeyLine {
  int number = 0;  ///< 0: none
  SlideWords words;
};

struct Slide {
  SlideWords title;
  SlideWords text;   ///< marked up as in model/scene/markup.h
  SlideWords notes;  ///< plain
  SlideWords shown;  ///< what the picture shows, for who does not see it
  std::optional<std::size_t> picture;
  SlideBox figure;  ///< where the picture stands
  std::vector<SlideLabel> marks;
  std::vector<SlideLabel> labels;
  bool onClick = false;
  std::vector<SlideKeyLine> key;  ///< of a slide that is the key of the one before
};

struct SlideDeck {
  SlideShape shape = SlideShape::wide;
  Colour ground{255, 255, 255};
  Colour ink;
  bool dark = false;           ///< light ink on dark ground
  Colour halo{255, 255, 255};  ///< around what is written over a drawing
  ExportCredit credit;
  std::vector<SlidePicture> pictures;
  std::vector<Slide> slides;
};

/// Draws and lays out the slides that the order wants. Its page's resolution counts, not its size.
Result<SlideDeck> slideDeck(const ExportOrder& order, const ExportProgress& progress);

}  // namespace sline::render
