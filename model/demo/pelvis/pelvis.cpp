// SPDX-License-Identifier: Apache-2.0
#include "model/demo/pelvis/pelvis.h"

#include <algorithm>
#include <array>
#include <glm/vector_relational.hpp>
#include <iterator>
#include <string_view>
#include <utility>

#include "model/demo/pelvis/bones.h"
#include "model/demo/pelvis/parts.h"

namespace sline::model {

namespace {
constexpr float femaleShift = 16.0f;  // mm; no point of the pelvis moves farther

/// Returns the rank of a structure: where two meet, the one with the lower number keeps its shape.
/// Within one class list order decides.
int precedence(const DemoStructure& s) {
  static constexpr std::array<std::string_view, 4> thinMuscles{"puborectalis", "pubococcygeus",
                                                               "iliococcygeus", "sphincter"};
  const auto isThin = [&](std::string_view part) { return s.name.find(part) != s.name.npos; };
  const std::string& group = s.groups.front();
  if (group == "Bones")
    return 0;
  if (group == "Tumour")
    return 1;
  if (group == "Arteries")
    return 2;
  if (group == "Nerves")
    return 3;
  if (group == "Veins")
    return 4;
  if (std::any_of(thinMuscles.begin(), thinMuscles.end(), isThin))
    return 5;
  return group == "Organs" ? 6 : 7;
}

/// Tells whether the two are cut in one plane and so join without a gap.
bool isSeam(const DemoStructure& own, const DemoStructure& other) {
  return own.name == "sigmoid colon" && other.name == "rectum";
}

/// Makes every structure give way to all before it, except bones, which keep the rules they came
/// with.
void settle(std::vector<DemoStructure>& structures) {
  for (std::size_t i = 0; i < structures.size(); ++i) {
    DemoStructure& own = structures[i];
    const int mine = precedence(own);
    if (mine == 0)
      continue;
    for (std::size_t j = 0; j < structures.size(); ++j) {
      const int theirs = precedence(structures[j]);
      const bool first = theirs < mine || (theirs == mine && j < i);
      if (i != j && first && !isSeam(own, structures[j]) &&
          meet(own.box, grown(structures[j].box, own.gap)))
        own.givesWayTo.push_back(structures[j].name);
    }
  }
}

void append(std::vector<DemoStructure>& list, std::vector<DemoStructure> more) {
  list.insert(list.end(), std::make_move_iterator(more.begin()),
              std::make_move_iterator(more.end()));
}

/// Makes thin plates that lie one behind the other hide each other, since from behind their
/// outlines would cross.
void backPlates(std::vector<DemoStructure>& structures) {
  static constexpr std::array<std::string_view, 7> plates{
      "puborectalis", "pubococcygeus", "iliococcygeus", "coccygeus",
      "sphincter",    "piriformis",    "obturator"};
  for (DemoStructure& s : structures) {
    const auto isPlate = [&](std::string_view part) { return s.name.find(part) != s.name.npos; };
    if (std::any_of(plates.begin(), plates.end(), isPlate))
      s.fill = Fill::paper;
  }
}

/// Moves a man's structure into a woman's pelvis.
void widen(DemoStructure& s) {
  s.field = [inMan = std::move(s.field)](const glm::vec3& p) { return inMan(fromFemalePelvis(p)); };
  if (s.opening)
    s.opening = [inMan = std::move(s.opening)](const glm::vec3& p) {
      return inMan(fromFemalePelvis(p));
    };
  if (s.pattern)
    std::transform(s.pattern->positions.begin(), s.pattern->positions.end(),
                   s.pattern->positions.begin(), toFemalePelvis);
  s.box = grown(s.box, femaleShift);
}

std::vector<View> savedViews(Sex sex) {
  const auto view = [](const char* name, const glm::vec3& eye, const glm::vec3& target) {
    return View{.name = name,
                .camera = {.eye = eye, .target = target, .fovyDegrees = 28.0f},
                .sections = std::vector<Section>{}};
  };
  // The male organs outside the pelvis hang lower.
  const bool man = sex == Sex::male;
  View half = view("Midsagittal", man ? glm::vec3(-770, -90, 908) : glm::vec3(-590, -82, 944),
                   man ? glm::vec3(-1, -90, 905) : glm::vec3(-1, -82, 941));
  half.sections = {{.id = {1},
                    .name = "Midsagittal plane",
                    .plane = anatomicalPlane(AnatomicalView::left, half.camera.target.x)}};
  return {view("Overview", man ? glm::vec3(-1, -890, 1108) : glm::vec3(-1, -720, 1130),
               man ? glm::vec3(-1, -75, 882) : glm::vec3(-1, -75, 915)),
          view("From behind", {150, 590, 1055}, {-1, -75, 922}), half};
}
}  // namespace

std::vector<DemoStructure> pelvisStructures(Sex sex, const std::stop_token& stop) {
  std::vector<DemoStructure> soft = pelvisMuscles();
  backPlates(soft);
  append(soft, pelvisOrgans(sex));
  append(soft, sex == Sex::male ? maleOrgans() : femaleOrgans());
  append(soft, pelvisArteries());
  append(soft, pelvisVeins());
  append(soft, pelvisNerves());
  if (sex == Sex::female)
    for (DemoStructure& s : soft)
      widen(s);
  std::vector<DemoStructure> list = pelvisBones(sex, stop);
  append(list, std::move(soft));
  settle(list);
  return list;
}

Scene pelvisDemo(Sex sex, const std::stop_token& stop) {
  Scene scene = demoScene(pelvisStructures(sex, stop), stop);
  scene.setViews(savedViews(sex));
  return scene;
}

}  // namespace sline::model
