// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/scene/scene.h"
#include "render/drawn/picture_settings.h"

namespace sline::render {

/// Says how a small picture of a scene is drawn.
struct CardPicture {
  model::Camera camera;
  PictureSettings settings;
  int samples = 1;
};

/// Returns how the card of a scene on the start page shows it: its first view, else its front, on
/// paper, in 480 × 360 pixels.
CardPicture cardPicture(const model::Scene& scene);

}  // namespace sline::render
