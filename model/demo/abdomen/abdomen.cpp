// SPDX-License-Identifier: Apache-2.0
#include "model/demo/abdomen/abdomen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

#include "model/demo/abdomen/parts.h"

namespace sline::model {

namespace {
constexpr float femaleSize = 0.93f;

constexpr std::array<std::string_view, 10> groupOrder{"Digestive system",
                                                      "Biliary system",
                                                      "Urinary system",
                                                      "Glands and spleen",
                                                      "Arteries",
                                                      "Veins",
                                                      "Portal system",
                                                      "Discs and cartilage",
                                                      "Bones",
                                                      "Muscles"};

std::size_t placeOf(const DemoStructure& s) {
  const auto at = std::find(groupOrder.begin(), groupOrder.end(), s.groups.front());
  return std::size_t(at - groupOrder.begin());
}

/// Cuts vessels, ureters, gullet, rectum and muscles off cleanly where they continue beyond the
/// scene.
void cutOff(DemoStructure& s) {
  constexpr float top = 121.0f;
  constexpr float bottom = -226.0f;
  if (s.box.high.z < top && s.box.low.z > bottom)
    return;
  s.field = [field = std::move(s.field)](const glm::vec3& p) {
    return -blendedUnion(-field(p), std::min(top - p.z, p.z - bottom), 2.0f);
  };
  s.box.high.z = std::min(s.box.high.z, top + 4.0f);
  s.box.low.z = std::max(s.box.low.z, bottom - 4.0f);
}

/// Tells whether two structures come near each other, checked every centimetre: most structures
/// whose boxes meet do not come near, and need not give way to each other.
bool touch(const DemoStructure& a, const DemoStructure& b) {
  constexpr float step = 10.0f;
  constexpr float near = 0.87f * step + 3.0f;
  const glm::vec3 low = glm::max(a.box.low, b.box.low);
  const glm::vec3 high = glm::min(a.box.high, b.box.high);
  if (glm::any(glm::greaterThanEqual(low, high)))
    return false;
  for (float z = low.z; z < high.z + step; z += step)
    for (float y = low.y; y < high.y + step; y += step)
      for (float x = low.x; x < high.x + step; x += step)
        if (const glm::vec3 p(x, y, z); a.field(p) < near && b.field(p) < near)
          return true;
  return false;
}

/// Returns the structures in order of firmness: earlier ones keep their shape and press into later
/// ones.
std::vector<DemoStructure> inOrderOfFirmness() {
  std::vector<DemoStructure> all = abdomenBones();
  const auto append = [&all](std::vector<DemoStructure> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
  };
  append(abdomenArteries());
  append(abdomenVeins());
  append(abdomenUrinary());
  append(abdomenGlands());
  append(abdomenMuscles());
  append(abdomenGut());
  append(abdomenBowel(all));
  append(abdomenSpleenAndLiver());
  for (DemoStructure& s : all) {
    s.fill = Fill::paper;
    if (s.groups.front() == "Bones" || s.groups.front() == "Discs and cartilage")
      s.inkColour = boneInk;
    if (s.groups.front() == "Muscles")
      s.inkColour = muscleInk;
    cutOff(s);
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (touch(all[i], all[k]))
        all[i].givesWayTo.push_back(all[k].name);
  return all;
}

Field scaled(Field field, float factor) {
  return
      [field = std::move(field), factor](const glm::vec3& p) { return factor * field(p / factor); };
}

void scale(DemoStructure& s, float factor) {
  s.field = scaled(std::move(s.field), factor);
  if (s.folds)
    s.folds = scaled(std::move(s.folds), factor);
  if (s.mesher)
    s.mesher = [mesher = std::move(s.mesher), factor](const Field& solid, float edge) {
      const MeshPtr mesh = mesher(scaled(solid, 1.0f / factor), edge / factor);
      std::vector<glm::vec3> positions(mesh->positions().begin(), mesh->positions().end());
      for (glm::vec3& p : positions)
        p *= factor;
      return std::make_shared<const Mesh>(
          Mesh::create(std::move(positions), {mesh->triangles().begin(), mesh->triangles().end()})
              .value());
    };
  s.box.low *= factor;
  s.box.high *= factor;
}

struct Aim {
  glm::vec3 target;
  glm::vec3 direction;  ///< to the eye
  glm::vec3 up{0, 0, 1};
};

/// Returns a nearly orthographic view, from far away with a narrow opening that shows `height` mm
/// at the target.
View viewFrom(const char* name, const Aim& aim, float height) {
  constexpr float distance = 1100.0f;
  const float opening = 2.0f * std::atan(0.5f * height / distance) * 57.29578f;
  return {.name = name,
          .camera = {.eye = aim.target + distance * glm::normalize(aim.direction),
                     .target = aim.target,
                     .up = aim.up,
                     .fovyDegrees = opening},
          .sections = std::vector<Section>{}};
}

View cut(View view, const char* name, const Plane& plane) {
  view.sections = {{.id = {1}, .name = name, .plane = plane}};
  return view;
}

std::vector<View> savedViews(float size) {
  const auto at = [size](float x, float y, float z) { return size * glm::vec3(x, y, z); };
  return {viewFrom("Overview", {at(0, -10, -58), {0.10f, -1.0f, 0.06f}}, size * 400.0f),
          viewFrom("From the left", {at(0, -10, -58), {1.0f, -0.25f, 0.05f}}, size * 400.0f),
          viewFrom("From behind", {at(0, 10, -58), {0.0f, 1.0f, 0.05f}}, size * 400.0f),
          cut(viewFrom("Transpyloric plane", {at(0, -4, -10), {0.0f, 0.0f, -1.0f}, {0, -1, 0}},
                       size * 252.0f),
              "Transpyloric plane", anatomicalPlane(AnatomicalView::superior, size * -10.0f)),
          cut(viewFrom("Sagittal through the aorta", {at(8, -10, -58), {-1.0f, 0.0f, 0.0f}},
                       size * 400.0f),
              "Sagittal plane", anatomicalPlane(AnatomicalView::left, size * 8.0f))};
}
}  // namespace

std::vector<DemoStructure> abdomenStructures(Sex sex) {
  std::vector<DemoStructure> all = inOrderOfFirmness();
  std::stable_sort(all.begin(), all.end(), [](const DemoStructure& a, const DemoStructure& b) {
    return placeOf(a) < placeOf(b);
  });
  if (sex == Sex::female)
    for (DemoStructure& s : all)
      scale(s, femaleSize);
  return all;
}

Scene abdomenDemo(Sex sex, const std::stop_token& stop) {
  Scene scene = demoScene(abdomenStructures(sex), stop);
  const float size = sex == Sex::female ? femaleSize : 1.0f;
  scene.setViews(savedViews(size));
  return scene;
}

}  // namespace sline::model
