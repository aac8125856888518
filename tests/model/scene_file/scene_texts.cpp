// SPDX-License-Identifier: Apache-2.0
#include "tests/model/scene_file/scene_texts.h"

using namespace sline::model;

namespace sline::test {

MeshesByName meshesByName(const Scene& scene) {
  MeshesByName meshes;
  for (const auto& [mesh, name] : meshNames(scene))
    meshes[name] = mesh;
  return meshes;
}

Json jsonOf(const Scene& scene) {
  const auto json = parseJson(sceneJson(scene));
  return json.ok() ? *json : Json();
}

}  // namespace sline::test
