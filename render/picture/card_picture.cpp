// SPDX-License-Identifier: Apache-2.0
#include "render/picture/card_picture.h"

namespace sline::render {

namespace {
constexpr int cardWidth = 480;  // as large as a card on a screen of twice the density
constexpr int cardHeight = 360;
constexpr int cardSamples = 2;  // per pixel in each direction
}  // namespace

CardPicture cardPicture(const model::Scene& scene) {
  const model::Camera camera =
      scene.views().empty()
          ? model::anatomicalCamera(model::AnatomicalView::anterior, scene.visibleBounds(),
                                    float(cardWidth) / cardHeight)
          : scene.views().front().camera;
  return {.camera = camera,
          .settings = {.width = cardWidth,
                       .height = cardHeight,
                       .environment = {.background = Background::paper}},
          .samples = cardSamples};
}

}  // namespace sline::render
