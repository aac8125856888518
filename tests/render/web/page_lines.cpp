// SPDX-License-Identifier: Apache-2.0
// sline-page-lines SCENE.sline FILE: packs the scene into the file, and writes as JSON what the
// page's engine does with it when compiled for the desktop: cameras, and the ends of lines'
// segments for each.
#include <array>
#include <cstdio>
#include <fstream>
#include <string>

#include "model/scene_file/scene_file.h"
#include "render/web/page_engine.h"

using namespace sline;

namespace {

void writeNumbers(const std::vector<float>& numbers) {
  std::printf("[");
  for (std::size_t i = 0; i < numbers.size(); ++i)
    std::printf("%s%.9g", i == 0 ? "" : ",", double(numbers[i]));
  std::printf("]");
}

std::vector<float> numbersOf(const model::Camera& camera) {
  std::vector<float> numbers;
  for (const glm::vec3& v : {camera.eye, camera.target, camera.up})
    numbers.insert(numbers.end(), {v.x, v.y, v.z});
  numbers.insert(numbers.end(), {camera.fovyDegrees, camera.heightMm, 0.0f});
  return numbers;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3)
    return 2;
  const auto document = model::readSceneFile(arguments[1]);
  if (!document.ok())
    return 2;
  const std::string packed = model::packedScene(document->scene).first;
  std::ofstream(arguments[2], std::ios::binary) << packed;
  render::web::PageEngine engine;
  engine.setSize({1280, 720, 1.0f});
  if (!engine.take(packed).ok())
    return 1;
  std::printf("[");
  for (int turn = 0; turn < 3; ++turn) {
    std::printf("%s{\"camera\":", turn == 0 ? "" : ",");
    writeNumbers(numbersOf(engine.camera()));
    std::vector<float> ends;
    for (const glm::vec3& end : engine.segments())
      ends.insert(ends.end(), {end.x, end.y, end.z});
    std::printf(",\"ends\":");
    writeNumbers(ends);
    std::printf("}");
    engine.orbit({80.0f, 25.0f});
    engine.zoom(1.3f, {600.0f, 300.0f});
  }
  std::printf("]\n");
}
