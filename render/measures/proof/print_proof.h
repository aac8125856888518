// SPDX-License-Identifier: Apache-2.0
// A proof for print: which neighbours in the picture nobody could tell apart on a press without
// colours, or with eyes that see fewer, and what would help.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/export/order/export_order.h"
#include "render/measures/proof/colour_vision.h"

namespace sline::render {

struct ProofSettings {
  /// CIEDE2000 of the mean colours of two areas; below it they look alike. About 1 is just noticed
  /// on even patches side by side; drawn areas are not even, and lines part them.
  double leastDifference = 10.0;
  /// From this difference in Γ on, the manner of drawing tells two structures apart.
  float leastGammaStep = 1.0f;
  /// Also changes what looks alike on the screen already, which may be meant.
  bool all = false;
};

/// Neighbours that share a visible border in the picture.
struct ProofPair {
  model::NodeId a;
  model::NodeId b;
  double border = 0.0;                           ///< as a part of the picture's longer side
  std::array<double, visionCount> difference{};  ///< CIEDE2000, in the order of `visions`
  bool similarGamma = false;

  bool alike(Vision vision, const ProofSettings& settings) const {
    return similarGamma && difference[std::size_t(vision)] < settings.leastDifference;
  }
  bool alikeOnScreen(const ProofSettings& settings) const {
    return alike(Vision::normal, settings);
  }
  bool alikeAnywhere(const ProofSettings& settings) const;
};

/// One structure's new colour or Γ.
struct ProofProposal {
  model::NodeId node;
  std::optional<Colour> colour;
  std::optional<Gamma> gamma;
  model::Style style() const;
};

struct PrintProof {
  std::vector<ProofPair> neighbours;     ///< all, those with the longest border first
  std::vector<ProofProposal> proposals;  ///< measured like the neighbours: with all of them …
  model::Scene proposed;                 ///< … made, the scene is this,
  std::vector<ProofPair> afterwards;     ///< and its neighbours are these
};

/// Looks at the order's picture; labels and marks do not count. Makes an OpenGL context.
Result<PrintProof> printProof(const ExportOrder& order, const ProofSettings& settings,
                              const ExportProgress& progress);

/// The scene with the proposals as the structures' own styles.
model::Scene withProposals(const model::Scene& scene, const std::vector<ProofProposal>& proposals);

}  // namespace sline::render
