// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <limits>
#include <set>
#include <utility>

#include "model/base/utf8.h"
#include "model/scene_json/scene_json.h"
#include "model/scene_json/scene_json_names.h"
#include "model/scene_json/scene_reader.h"

namespace sline::model {

namespace {
Error errorOf(const JsonRefusal& fault) {
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

namespace {

/// Returns why not even a part of the scene can be read.
Status checkFrameAndNodes(const Json& root) {
  JsonFault fault;
  const JsonValue value(root, fault);
  JsonObject object(value);
  for (const auto& [key, only] : {std::pair{"frame", "LPS"}, std::pair{"unit", "mm"}})
    if (const auto said = object.take(key); said && said->text() != only)
      said->fail("\"" + std::string(only) + "\" is expected here");
  const JsonValue nodes = object.need("nodes");
  if (!nodes.json().is_array())
    nodes.fail("a list is expected here");
  if (nodes.json().size() > mostSceneNodes)
    nodes.fail("there are more than " + std::to_string(mostSceneNodes) + " nodes");
  if (fault.any())
    return errorOf(fault);
  return Unit{};
}

/// Reads the scene as far as it can be; what was left out is added to the fault's list.
Result<Scene> readScene(const Json& root, const SceneParts& parts, JsonFault& fault) {
  const int schema = TRY(schemaOf(root));
  TRY(checkFrameAndNodes(root));
  Scene scene = SceneJsonReader(parts, schema > sceneSchema).scene(JsonValue(root, fault));
  if (fault.ends())
    return errorOf(fault);
  std::vector<SceneMending> mended;
  TRY(bringWithinLimits(scene, mended));
  for (const SceneMending& each : mended) {
    ++fault.count;
    if (!fault.all)
      return Error{.where = each.where, .reason = each.fault};
    fault.all->push_back({each.where, each.fault + "; " + each.done});
  }
  return scene;
}

/// Puts the name of what is spoken of before a place: "\"Liver\" (nodes[2].style.gamma)".
std::string namedPlace(const Json& root, const std::string& where) {
  constexpr std::size_t mostOfName = 80;  // bytes
  const std::size_t open = where.find('[');
  const std::size_t close = where.find(']');
  if (open == std::string::npos || close == std::string::npos)
    return where;
  const auto list = root.find(where.substr(0, open));
  const std::size_t index = std::strtoul(where.c_str() + open + 1, nullptr, 10);
  if (list == root.end() || !list->is_array() || index >= list->size())
    return where;
  const Json& each = (*list)[index];
  for (const char* key : {"name", "text"})
    if (const auto name = each.is_object() ? each.find(key) : each.end();
        name != each.end() && name->is_string())
      return "\"" + std::string(cutUtf8(name->get_ref<const std::string&>(), mostOfName)) + "\" (" +
             where + ")";
  return where;
}

}  // namespace

Result<Scene> sceneFromJson(const Json& root, const SceneParts& parts) {
  JsonFault fault;
  return readScene(root, parts, fault);
}

Result<Scene> sceneFromJson(const Json& root, const SceneParts& parts,
                            std::vector<JsonRefusal>& leftOut) {
  JsonFault fault;
  fault.all = &leftOut;
  Result<Scene> scene = readScene(root, parts, fault);
  for (JsonRefusal& each : leftOut)
    each.where = namedPlace(root, each.where);
  return scene;
}

}  // namespace sline::model
