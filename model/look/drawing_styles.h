// SPDX-License-Identifier: Apache-2.0
// Draws a whole scene in a manner that has a name, as a table: each manner shows what one pen can
// do. What is modelled is drawn as the subject, everything else as its context.
#pragma once

#include <span>
#include <stop_token>
#include <string_view>

#include "model/edit/edited.h"
#include "model/look/opening_look.h"

namespace sline::model {

/// Holds what a style may ask of one structure, whatever it looks like now.
struct DrawnPart {
  enum class Standing {
    subject,
    context,  ///< beside or behind the subject
    front,    ///< before the subject: its outline alone is drawn now
  };
  Standing standing = Standing::context;
  ResolvedStyle now;
  Colour accent;  ///< the one colour of the subject as a whole, of some saturation
};

struct DrawingStyle {
  std::string_view id;           ///< "woodcut"
  std::string_view name;         ///< English
  std::string_view description;  ///< English, a sentence
  std::string_view background;   ///< the one that it is made for: "white", "paper" or "dark"
  /// Returns all that is said of the part; null for the plate, which is chosen by the opening look.
  Style (*styleOf)(const DrawnPart& part) = nullptr;
  bool hatchedSections = false;  ///< cut faces are white, with hatching
};

/// Returns the styles in the order in which the user should meet them, the usual one first.
std::span<const DrawingStyle> drawingStyles();
/// Returns the style of that id, or null if there is none.
const DrawingStyle* drawingStyleNamed(std::string_view id);

/// Returns what the scene's look makes its subject: the visible structures that look in focus amid
/// shaded surroundings, else those that are shaded (Γ ≥ 3.95), else those that are drawn in most
/// detail, else what `subjectsOf` finds first. In tree order; empty where nothing is visible.
std::vector<NodeId> emphasisedIn(const Scene& scene);

/// Returns the scene with the colours that drawing styles have taken (Node::drawn): where an
/// unlocked structure still has the colour of a style it gets the one that it had before.
Scene withOwnColours(const Scene& scene);

/// Draws the scene that way. A scene without a look is first given the opening look, with its
/// subject; the plate is the opening look for the subject that the scene has. Every field of a look
/// is set, except that only styles of few colours change colours, and that each starts from the
/// structures' own (`withOwnColours`). Hidden structures stay hidden,
/// locked ones as they are. Unchanged where nothing is visible or stop was requested.
Edited withDrawingStyle(const Scene& scene, const DrawingStyle& style, FormIndex& forms,
                        const OpeningWishes& wishes = {}, const std::stop_token& stop = {});

}  // namespace sline::model
