// SPDX-License-Identifier: Apache-2.0
// Decides how much is drawn of the surroundings of the structures in focus: it turns an analysis
// and one amount into styles. It is quick, so that a picture can follow a slider.
//
// Structures in front of the focus fade to their outlines, as in Bruckner, Grimm, Kanitsar,
// Gröller, "Illustrative Context-Preserving Exploration of Volume Data" (2006); here by Γ and fill.
#pragma once

#include <span>

#include "model/edit/edited.h"
#include "model/focus/analysis.h"

namespace sline::model {

/// Says in which way a structure is drawn, and why.
enum class ContextManner {
  detail,   ///< it is in focus
  host,     ///< solid and pale: the targets lie in it, open towards the eye
  outline,  ///< nothing but a thin outline: it is in front of the targets
  feeder,   ///< modelled: a vessel, nerve or duct that comes to the targets
  near,     ///< solid, and modelled by what it is made of: it is near the targets
  far,      ///< solid and pale: it is away from the targets
  byRole,   ///< what it is made of is unknown: by its role alone
};
ContextManner mannerOf(const Relation& relation);

/// Tells whether a structure looks as one in focus does, which no surroundings do.
bool looksInFocus(const ResolvedStyle& style);

/// Returns a style that answers Γ, fill, opacity, pen, tone of hatching and visibility. With the
/// amount more of each structure becomes visible, never less, and without jumps: its Γ and pen
/// grow, its pen from nothing. Only structures that hide nothing of the targets are filled with
/// paper.
Style contextStyle(const Relation& relation, ContextAmount amount);

/// Gives these styles to the analysed structures that are in the scene and not locked. Hidden ones
/// stay hidden, except targets and structures that an earlier edit of this kind had faded out; what
/// was set by hand since that edit stays, except new targets. The scene's focus says all this.
Edited withFocusAndContext(const Scene& scene, const FocusAnalysis& analysis, ContextAmount amount,
                           const ContextWishes& wishes = {});

/// Returns the structures that look otherwise than the scene's focus gave them: they were set by
/// hand since, in tree order. None where several do and no visible one is as it was given: then the
/// whole look was replaced, by a drawing style for instance, and that is not the hand of a person
/// on one structure.
std::vector<NodeId> setByHand(const Scene& scene);

/// Gives the structures back to the focus: they look as it gave them.
Edited withoutHand(const Scene& scene, std::span<const NodeId> ids);

/// Returns the analysed structures, targets aside, that are hidden (or have a group above them
/// hidden) by hand rather than by `withFocusAndContext`.
std::vector<NodeId> hiddenByHand(const Scene& scene, const FocusAnalysis& analysis);

}  // namespace sline::model
