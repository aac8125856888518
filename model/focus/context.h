// SPDX-License-Identifier: Apache-2.0
// How much is drawn of what surrounds the structures in focus: from an analysis and one amount to
// styles. Quick, so that a picture can follow a slider.
//
// What lies before the focus fades to its outlines, as in Bruckner, Grimm, Kanitsar, Gröller,
// "Illustrative Context-Preserving Exploration of Volume Data" (2006); here by Γ and fill.
#pragma once

#include <map>

#include "model/edit/edited.h"
#include "model/focus/analysis.h"

namespace sline::model {

/// 0: the focus on empty paper … 1: everything clearly there.
using ContextAmount = Bounded<struct ContextAmountTag, 0, 1>;

/// What a person decides besides the amount.
struct ContextWishes {
  std::map<NodeId, ContextRole> roles;  ///< instead of what the analysis says
  bool hiddenToo = false;               ///< also draw what was hidden by hand
  bool operator==(const ContextWishes&) const = default;
};

/// Γ, fill, opacity, pen and visibility, all answered. Of each structure more becomes visible with
/// the amount, never less, and without jumps: its Γ and pen grow, its pen from nothing. Only what
/// hides nothing of the targets is filled with paper.
Style contextStyle(const Relation& relation, ContextAmount amount);

/// The analysed structures that are in the scene and not locked in these styles. Hidden ones stay
/// hidden, but for targets and what an edit of this kind had faded out.
Edited withFocusAndContext(const Scene& scene, const FocusAnalysis& analysis, ContextAmount amount,
                           const ContextWishes& wishes = {});

/// The analysed structures, targets aside, that a person hid, or a group above them, rather than
/// `withFocusAndContext`.
std::vector<NodeId> hiddenByHand(const Scene& scene, const FocusAnalysis& analysis);

}  // namespace sline::model
