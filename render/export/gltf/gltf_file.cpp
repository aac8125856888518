// SPDX-License-Identifier: Apache-2.0
#include "render/export/gltf/gltf_file.h"

#include <set>

#include "model/disk/whole_file.h"
#include "model/scene/visible_structures.h"
#include "render/export/gltf/gltf_buffer.h"
#include "render/export/gltf/gltf_document.h"

namespace sline::render {

Status writeGltf(const ExportOrder& order, const std::filesystem::path& target,
                 const ExportProgress& progress) {
  const Result<std::string> glb = glbBytes(order, progress);
  if (!glb.ok()) {
    Error error = glb.error();
    error.file = target.string();
    return error;
  }
  progress.note(gltfNotes(order));
  if (progress && !progress(0.95, "writing the file"))
    return givenUp(target);
  return model::writeText(target, *glb);
}

double gltfWeight(const ExportOrder& order) {
  constexpr double description = 1200.0;
  double bytes = description;
  std::set<model::MeshPtr> shared;
  for (const model::VisibleStructure& structure : model::visibleStructures(order.scene)) {
    bytes += description;
    if (shared.insert(structure.node->mesh).second)
      bytes += GltfBuffer::bytesOf(*structure.node->mesh);
  }
  return bytes;
}

ExportNotes gltfNotes(const ExportOrder& order) {
  ExportNote uncut{.kind = ExportNote::Kind::sectionsUncut, .names = {}, .detail = {}};
  for (const model::Section& section : order.scene.sections())
    if (section.enabled)
      uncut.names.push_back(section.name);
  return uncut.names.empty() ? ExportNotes{} : ExportNotes{std::move(uncut)};
}

}  // namespace sline::render
