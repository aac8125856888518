// SPDX-License-Identifier: Apache-2.0
#include "model/demo/demo.h"

#include <algorithm>

#include "model/demo/abdomen/abdomen.h"
#include "model/demo/kidney/kidney.h"
#include "model/demo/pelvis/pelvis.h"
#include "model/scene_file/scene_file.h"
#include "model/sculpting/stopping.h"

namespace sline::model {

namespace {
/// This number must rise with every change to a demo's shapes, styles or views, and to how they are
/// meshed.
constexpr int modellingVersion = 7;

Scene modelled(DemoName name, Sex sex, const std::stop_token& stop) {
  switch (name) {
    case DemoName::pelvis:
      return pelvisDemo(sex, stop);
    case DemoName::abdomen:
      return abdomenDemo(sex, stop);
    case DemoName::kidney:
      break;
  }
  return kidneyDemo(stop);
}
}  // namespace

std::optional<DemoName> demoNamed(std::string_view name) {
  const auto at = std::find(demoNames.begin(), demoNames.end(), name);
  if (at == demoNames.end())
    return std::nullopt;
  return DemoName(at - demoNames.begin());
}

std::string_view sexName(Sex sex) {
  return sex == Sex::female ? "female" : "male";
}

std::string demoKey(DemoName name, Sex sex) {
  const std::string scene(demoNames[std::size_t(name)]);
  const std::string version = "-v" + std::to_string(modellingVersion);
  return name == DemoName::kidney ? scene + version
                                  : scene + "-" + std::string(sexName(sex)) + version;
}

std::string demoCacheFile(DemoName name, Sex sex) {
  return demoKey(name, sex) + std::string(sceneExtension);
}

Scene demo(DemoName name, Sex sex, const std::filesystem::path& cacheFolder) {
  return *demo(name, sex, cacheFolder, {});
}

std::optional<Scene> demo(DemoName name, Sex sex, const std::filesystem::path& cacheFolder,
                          const std::stop_token& stop) try {
  if (cacheFolder.empty())
    return modelled(name, sex, stop);
  const std::filesystem::path file = cacheFolder / demoCacheFile(name, sex);
  if (Result<SceneDocument> kept = readSceneFile(file); kept.ok() && !kept->isForReading())
    return std::move(kept->scene);
  Scene scene = modelled(name, sex, stop);
  // If the scene cannot be kept, it is modelled again next time.
  std::error_code ignored;
  std::filesystem::create_directories(cacheFolder, ignored);
  static_cast<void>(writeSceneFile(file, {.scene = scene}).ok());
  return scene;
} catch (const ModellingStopped&) {
  return std::nullopt;
}

}  // namespace sline::model
