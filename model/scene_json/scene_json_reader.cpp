// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <set>

#include "model/scene_json/scene_json.h"
#include "model/scene_json/scene_json_names.h"
#include "model/scene_json/scene_reader.h"

namespace sline::model {

namespace {
Error errorOf(const JsonFault& fault) {
  return {.where = fault.where, .reason = fault.reason};
}
}  // namespace

Result<int> schemaOf(const Json& root) {
  JsonFault fault;
  const JsonValue value(root, fault);
  JsonObject object(value);
  const JsonValue format = object.need("format");
  if (format.text() != formatName)
    format.fail("it is no scene of Sline");
  const auto schema = int(object.need("schema").whole(1, std::numeric_limits<int>::max()));
  if (fault.any())
    return errorOf(fault);
  return schema;
}

namespace {
/// Returns the files that nodes name for that part of them.
std::vector<std::string> filesCalledFor(const Json& root, const char* part) {
  std::set<std::string> names;
  const auto nodes = root.is_object() ? root.find("nodes") : root.end();
  if (nodes == root.end() || !nodes->is_array())
    return {};
  for (const Json& node : *nodes) {
    const auto mesh = node.is_object() ? node.find(part) : node.end();
    if (mesh == node.end() || !mesh->is_object())
      continue;
    const auto file = mesh->find("file");
    if (file != mesh->end() && file->is_string())
      names.insert(file->get<std::string>());
  }
  return {names.begin(), names.end()};
}
}  // namespace

std::vector<std::string> meshesCalledFor(const Json& root) {
  return filesCalledFor(root, "mesh");
}

std::vector<std::string> paintsCalledFor(const Json& root) {
  return filesCalledFor(root, "paint");
}

Result<Scene> sceneFromJson(const Json& root, const SceneParts& parts) {
  const Result<int> schema = schemaOf(root);
  if (!schema.ok())
    return schema.error();
  JsonFault fault;
  Scene scene = SceneJsonReader(parts, *schema > sceneSchema).scene(JsonValue(root, fault));
  if (fault.any())
    return errorOf(fault);
  return scene;
}

}  // namespace sline::model
