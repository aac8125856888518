// SPDX-License-Identifier: Apache-2.0
// The flags that write labels into pictures.
#pragma once

#include <memory>
#include <string>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/export/labelled_image.h"

namespace sline::cli {

/// As typed.
struct LabelFlags {
  std::string mode = "off";
  std::string language;
  double points = 10.0;
};

/// Understood; what text needs is made before anything is drawn.
struct LabelOrder {
  render::LabelStyle style{.mode = render::LabelMode::off, .language = {}};
  std::shared_ptr<const render::Typesetting> typesetting;
  float anatomyShare = 1.0f;  ///< of the picture's width, for views that are fitted
};

/// An error is a wrong use.
Result<LabelOrder> understood(const LabelFlags& flags);
/// Makes the order ready for the scene, shown as it is drawn; `aspect` is width / height.
Status prepareLabels(LabelOrder& order, const model::Scene& scene, float aspect);
/// Draws them, prints the key of numbers and warns of labels for which there is no room.
void drawLabels(render::Image& image, const model::Scene& scene, const model::Camera& camera,
                const LabelOrder& order);

}  // namespace sline::cli
