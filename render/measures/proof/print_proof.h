// SPDX-License-Identifier: Apache-2.0
// Makes a proof for print: it finds neighbours in the picture that cannot be told apart on a press
// without colours, or with eyes that see fewer of them, and proposes remedies.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/export/order/export_order.h"
#include "render/measures/proof/colour_vision.h"

namespace sline::render {

struct ProofSettings {
  /// CIEDE2000 of the mean colours of two areas; below it they look alike. About 1 is just
  /// noticeable on even patches side by side, but drawn areas are not even, and lines part them.
  double leastDifference = 10.0;
  /// From this difference in Γ on, two structures are told apart by how they are drawn.
  float leastGammaStep = 1.0f;
  /// Also changes neighbours that look alike even on the screen, which may be intended.
  bool all = false;
};

/// Two neighbours that share a visible border in the picture.
struct ProofPair {
  model::NodeId a;
  model::NodeId b;
  double border = 0.0;                           ///< as a share of the picture's longer side
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

/// Proposes a new colour or Γ for one structure.
struct ProofProposal {
  model::NodeId node;
  std::optional<Colour> colour;
  std::optional<Gamma> gamma;
  model::Style style() const;
};

struct PrintProof {
  std::vector<ProofPair> neighbours;     ///< all of them, those with the longest border first
  std::vector<ProofProposal> proposals;  ///< measured like the neighbours
  model::Scene proposed;                 ///< the scene with all proposals made
  std::vector<ProofPair> afterwards;     ///< the neighbours in that scene
};

/// Examines the order's picture; labels and marks do not count. It makes an OpenGL context.
Result<PrintProof> printProof(const ExportOrder& order, const ProofSettings& settings,
                              const ExportProgress& progress);

/// Returns the scene with the proposals as the structures' own styles.
model::Scene withProposals(const model::Scene& scene, const std::vector<ProofProposal>& proposals);

}  // namespace sline::render
