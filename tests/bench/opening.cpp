// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/opening.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>

#include "model/focus/twins.h"
#include "model/look/opening_look.h"
#include "model/scene_file/fingerprint.h"
#include "model/scene_json/camera_json.h"
#include "model/scene_json/style_json.h"
#include "tests/bench/measure.h"

namespace sline::bench {

namespace {

constexpr int tries = 7;

std::string measured(const char* what, const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity();
  double leastBusy = least;
  for (int i = 0; i < tries; ++i) {
    const Stopwatch watch;
    const std::clock_t before = std::clock();
    work();
    leastBusy = std::min(leastBusy, 1000.0 * double(std::clock() - before) / CLOCKS_PER_SEC);
    least = std::min(least, watch.milliseconds());
  }
  std::array<char, 120> text{};
  std::snprintf(text.data(), text.size(), "%-44s %9.1f ms, processor %9.1f ms\n", what, least,
                leastBusy);
  return text.data();
}

std::string checksumOf(const model::OpeningLook& look) {
  std::string all = model::cameraJson(look.camera).dump();
  for (const model::Node& node : look.scene.nodes())
    all += node.name + model::styleJson(node.style).dump();
  return std::to_string(model::fingerprintOf(all).crc);
}

}  // namespace

std::string measureOpening(const model::Scene& scene) {
  std::optional<model::OpeningLook> look;
  std::string text = measured("opening look", [&] {
    model::FormIndex forms;
    look = model::openingLook(scene, forms);
  });
  if (!look)
    return "nothing is visible\n";
  std::size_t found = 0;
  text += measured("  subjects", [&] { found += model::subjectsOf(scene).size(); });
  text += measured("  what is there twice, once", [&] { found += model::twinsOf(scene).size(); });
  const model::FocusQuestion question{look->subject.structures, look->camera};
  model::FormIndex forms;
  text += measured("  focus, with all forms", [&] {
    model::FormIndex none;
    found += model::analysed(look->scene, question, none)->relations.size();
  });
  static_cast<void>(model::analysed(look->scene, question, forms));
  text += measured("  focus, the forms known", [&] {
    found += model::analysed(look->scene, question, forms)->relations.size();
  });
  text += measured("  whole, the forms known",
                   [&] { found += model::openingLook(scene, forms)->scene.nodes().size(); });
  return text + look->subject.title + ", " + std::to_string(look->subject.structures.size()) +
         " structures, " + std::to_string(found) + " answers, " + checksumOf(*look) + '\n';
}

}  // namespace sline::bench
