// SPDX-License-Identifier: Apache-2.0
#include "render/export/order/drawing_notes.h"

#include "model/scene/visible_structures.h"

namespace sline::render {

ExportNotes drawingNotes(const ExportOrder& order) {
  ExportNote noise{.kind = ExportNote::Kind::noiseNotDrawn, .names = {}, .detail = {}};
  for (const model::VisibleStructure& structure : model::visibleStructures(order.scene)) {
    const float gamma = structure.style.gamma.value();
    if (structure.style.technique == model::Technique::noiseLic && gamma > 1.0f && gamma < 5.0f)
      noise.names.push_back(structure.node->name);
  }
  return noise.names.empty() ? ExportNotes{} : ExportNotes{std::move(noise)};
}

}  // namespace sline::render
