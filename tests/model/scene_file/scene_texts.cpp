// SPDX-License-Identifier: Apache-2.0
#include "tests/model/scene_file/scene_texts.h"

using namespace sline::model;

namespace sline::test {

SceneParts partsByName(const Scene& scene) {
  SceneParts parts;
  for (const auto& [mesh, name] : meshNames(scene))
    parts.meshes[name] = mesh;
  for (const Node& node : scene.nodes())
    if (node.paint)
      parts.paints[paintName(node.id)] = node.paint;
  return parts;
}

Json jsonOf(const Scene& scene) {
  const auto json = parseJson(sceneJson(scene));
  return json.ok() ? *json : Json();
}

}  // namespace sline::test
