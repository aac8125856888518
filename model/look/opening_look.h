// SPDX-License-Identifier: Apache-2.0
// Chooses the look that a scene opens with: a plate at first sight (METHOD §12). It finds what the
// scene is about, from where that is seen best, and draws it in detail with everything else as
// quiet context, by the same Focus that a person uses.
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/camera/free_sides.h"
#include "model/focus/context.h"
#include "model/look/subjects.h"

namespace sline::model {

/// Holds what was chosen, so that it can be explained and undone.
struct OpeningLook {
  Scene scene;  ///< styled; everything else as it was
  Camera camera;
  Subject subject;
  std::optional<AnatomicalView> view;             ///< absent where a camera was given, or the
                                                  ///< scene has no sides (a molecule)
  std::shared_ptr<const FocusAnalysis> analysis;  ///< null where everything is the subject
};

struct OpeningWishes {
  std::size_t subject = 0;    ///< its index among `subjectsOf`, from the first again after the last
  std::vector<NodeId> about;  ///< structures; if any, they are the subject instead
  std::optional<Camera> camera;        ///< used as it is
  std::optional<AnatomicalView> view;  ///< absent, without a camera: chosen
  float aspect = 16.0f / 9.0f;         ///< width / height of the picture
};

/// Returns the opening look, or nothing where the scene shows nothing or stop was requested. The
/// result depends on the arguments alone. Hidden structures stay hidden, but for the pockets of
/// ligands; locked ones stay as they are. The second of what is there twice is hidden (METHOD
/// §12.7).
std::optional<OpeningLook> openingLook(const Scene& scene, FormIndex& forms,
                                       const OpeningWishes& wishes = {},
                                       const std::stop_token& stop = {});

/// Returns the scene with the look that it opens with, if it has none of its own.
Scene dressed(const Scene& scene);

/// Returns the look's camera, fitted to the subject and to the context that does not reach far
/// beyond it, with room left at the sides that labels need.
Camera framedCamera(const OpeningLook& look, float aspect, const FreeSides& sides = {});

}  // namespace sline::model
