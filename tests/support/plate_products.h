// SPDX-License-Identifier: Apache-2.0
// Makes what a program would print of a scene, with everything written in it that it has: pictures,
// sheets, figures, slides and the stills of students' pages, from all sides, near and far. What is
// written is then proved, in colour and in black ink.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/focus/form.h"
#include "model/geometry/mesh_trees.h"
#include "model/scene/scene.h"
#include "render/export/plate/writing_proof.h"
#include "render/measures/leader_truth.h"

namespace sline::test {

/// A page or panel of a product.
struct PrintedPart {
  render::ExportOrder order;
  /// What is written in it besides the plate, as a panel's letter is.
  render::Lettering besides;
};
struct Product {
  std::string kind;
  std::string name;  ///< the kind, the side it is seen from and how it looks
  int height = 600;  ///< pixels of its parts
  std::vector<PrintedPart> colour;
  std::vector<PrintedPart> ink;
};

/// Keeps what is made once of a scene's surfaces.
struct ProductTools {
  model::FormIndex forms;
  model::MeshTrees trees;
};

/// Holds how many products a scene gives, at most, and which of them are made: every so many.
inline constexpr int mostProducts = 60;
/// Tells whether that product's camera is so near that anatomy may fill the whole picture.
inline bool isNear(int index) {
  return index % 5 == 3;
}
/// Makes that one of the scene's products, 0 … mostProducts − 1. The scene is as it was read.
Result<Product> productOf(const model::Scene& scene, int index, ProductTools& tools);

/// Holds what was found in one product.
struct ProductProof {
  std::vector<std::string> lines;  ///< one for each fault
  std::size_t marks = 0;
  std::size_t labels = 0;
  std::size_t leftOut = 0;  ///< labels without room
  int overAnatomy = 0;      ///< marks
  int labelsOver = 0;       ///< labels
  int pixels = 0;           ///< of anatomy below both
  int throughDots = 0;
  int throughTexts = 0;
  int crossings = 0;
  int astray = 0;     ///< leaders that end on something else, if they were judged
  int elsewhere = 0;  ///< what is in another place in black ink
  /// The same, if ink were laid out by itself, and marks and pixels over anatomy, if pictures did
  /// not end above what is written at their foot; where that is asked for.
  int elsewhereAlone = 0;
  int overUncut = 0;
  int pixelsUncut = 0;
  bool clean() const {
    return overAnatomy + labelsOver + throughDots + throughTexts + crossings + astray + elsewhere ==
           0;
  }
  void add(const ProductProof& other);
};

struct ProofWishes {
  bool judge = false;    ///< do leaders end on what they name: some pictures for every structure
  bool unruled = false;  ///< what the rules for ink and for the foot are good for
};
Result<ProductProof> proved(const Product& product, const render::DrawPicture& draw,
                            const ProofWishes& wishes, ProductTools& tools);

}  // namespace sline::test
