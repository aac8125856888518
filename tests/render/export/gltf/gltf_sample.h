// SPDX-License-Identifier: Apache-2.0
// Makes a scene for the tests of glTF, and its bytes.
#pragma once

#include <string>

#include "model/scene/scene.h"
#include "render/export/order/export_order.h"

namespace sline::test {

model::NodeId add(model::Scene& scene, const std::string& name, model::NodeId parent,
                  const model::MeshPtr& mesh = nullptr);

void setStyle(model::Scene& scene, model::NodeId id, const model::Style& style);

/// Holds a scene that differs from its mirror image, with something of all that a scene can have.
struct Sample {
  model::Scene scene;
  model::NodeId left;
  model::NodeId front;
  model::NodeId top;
  model::NodeId hidden;
};

Sample sample();

render::ExportOrder orderOf(model::Scene scene);

std::string bytesOf(const model::Scene& scene);

}  // namespace sline::test
