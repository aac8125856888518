// SPDX-License-Identifier: Apache-2.0
#include "model/look/opening_look.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "model/base/contrast.h"
#include "model/edit/look.h"
#include "model/edit/visibility.h"
#include "model/focus/twins.h"
#include "model/look/best_view.h"
#include "model/scene/resolved_styles.h"
#include "model/scene/visible_structures.h"

namespace sline::model {

namespace {

constexpr float plainGamma = 4.15f;  // where everything is the subject
constexpr Colour paper{255, 255, 255};
// Lines stand out from white paper as texts must; those of the subject more.
constexpr double contextContrast = 4.5;
constexpr double subjectContrast = 9.0;

using Ids = std::unordered_set<std::uint64_t>;

Ids idsOf(const std::vector<NodeId>& structures) {
  Ids ids;
  for (const NodeId id : structures)
    ids.insert(id.value);
  return ids;
}

/// Tells whether the ink is one that a look has chosen.
bool isChosen(const Colour& ink, const Colour& colour) {
  return ink == legibleOn(paper, colour, contextContrast) ||
         ink == legibleOn(paper, colour, subjectContrast);
}

/// Gives each structure an ink of its own colour, dark enough for lines. An ink that a person chose
/// stays, and so does black where no colour tells structures apart.
Scene inked(const Scene& scene, const Ids& subject) {
  const std::vector<ResolvedStyle> styles = resolveAll(scene);
  std::vector<Node> nodes = scene.nodes();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const std::optional<Colour>& own = styles[i].inkColour;
    if (nodes[i].isGroup() || (own && !isChosen(*own, styles[i].colour)) ||
        scene.isLocked(nodes[i].id))
      continue;
    const bool asked = subject.contains(nodes[i].id.value);
    nodes[i].style.inkColour =
        legibleOn(paper, styles[i].colour, asked ? subjectContrast : contextContrast);
  }
  Scene after = scene;
  after.setNodes(std::move(nodes));
  return after;
}

/// Returns whether something tells the structures' colours apart.
bool hasColours(const Scene& scene) {
  std::optional<Colour> first;
  for (const VisibleStructure& each : visibleStructures(scene)) {
    if (first && !(*first == each.style.colour))
      return true;
    first = each.style.colour;
  }
  return false;
}

Style everythingStyle() {
  Style style;
  style.gamma = Gamma::clamped(plainGamma);
  style.fill = Fill::paper;
  style.opacity = Opacity::clamped(1.0f);
  style.penWeight = 1.0f;
  style.hatchTone = HatchTone::clamped(1.0f);
  return style;
}

constexpr float plateContext = 0.7f;  ///< how much is drawn around the subject

/// Hides the second of what is there twice.
Scene withoutTwins(const Scene& scene) {
  std::vector<NodeId> second;
  for (const Twins& twins : twinsOf(scene))
    if (!scene.isLocked(twins.second))
      second.push_back(twins.second);
  return withHidden(scene, second).scene;
}

/// Returns a camera from where the ligands of a molecule, which has no sides, show best.
Camera pocketCamera(const Scene& scene, const Subject& subject, float aspect, FormIndex& forms) {
  std::vector<NodeId> ligands;
  const Ids pockets = idsOf(subject.pockets);
  for (const NodeId id : subject.structures)
    if (!pockets.contains(id.value))
      ligands.push_back(id);
  Camera camera = anatomicalCamera(AnatomicalView::anterior, scene.visibleBounds(), aspect);
  const glm::vec3 towardsEye = clearestDirection(scene, ligands, subject.pockets, forms);
  camera.eye = camera.target + glm::length(camera.eye - camera.target) * towardsEye;
  if (std::abs(glm::dot(towardsEye, camera.up)) > 0.9f)
    camera.up = {0.0f, 1.0f, 0.0f};
  return fitted(camera, scene.visibleBounds().corners(), aspect);
}

/// Returns from where the subject is looked at, not yet framed, and sets the look's view.
Camera chosenCamera(OpeningLook& look, const OpeningWishes& wishes, FormIndex& forms) {
  if (wishes.camera)
    return *wishes.camera;
  const Scene& scene = look.scene;
  if (!wishes.view && !look.subject.pockets.empty())
    return pocketCamera(scene, look.subject, wishes.aspect, forms);
  look.view = wishes.view ? *wishes.view : bestViewOf(scene, look.subject.structures);
  return anatomicalCamera(*look.view, scene.visibleBounds(), wishes.aspect);
}

}  // namespace

std::optional<OpeningLook> openingLook(const Scene& scene, FormIndex& forms,
                                       const OpeningWishes& wishes, const std::stop_token& stop) {
  const std::vector<Subject> subjects = subjectsOf(scene);
  if (subjects.empty())
    return std::nullopt;
  OpeningLook look;
  look.subject = subjects[wishes.subject % subjects.size()];
  if (!wishes.about.empty())
    look.subject = {.title = "what stands out",
                    .structures = wishes.about,
                    .everything = wishes.about.size() == visibleStructures(scene).size()};
  look.scene = withShown(withoutTwins(scene), look.subject.pockets).scene;
  look.scene.setFocus({});  // a plate is a whole look anew, whatever was set by hand
  if (hasColours(look.scene))
    look.scene = inked(look.scene, idsOf(look.subject.structures));
  const Camera camera = chosenCamera(look, wishes, forms);
  if (look.subject.everything) {
    look.scene = withLook(look.scene, look.subject.structures, everythingStyle()).scene;
  } else {
    auto analysis =
        analysed(look.scene, {.targets = look.subject.structures, .camera = camera}, forms, stop);
    if (!analysis)
      return std::nullopt;
    look.scene =
        withFocusAndContext(look.scene, *analysis, ContextAmount::clamped(plateContext)).scene;
    look.analysis = std::make_shared<FocusAnalysis>(std::move(*analysis));
  }
  look.camera = camera;
  if (!wishes.camera)
    look.camera = framedCamera(look, wishes.aspect);
  return look;
}

Scene dressed(const Scene& scene) {
  if (!hasNoLook(scene))
    return scene;
  FormIndex forms;
  const std::optional<OpeningLook> look = openingLook(scene, forms);
  if (!look)
    return scene;
  Scene result = scene;
  result.setNodes(look->scene.nodes());
  return result;
}

Camera framedCamera(const OpeningLook& look, float aspect, const FreeSides& sides) {
  const Scene& scene = look.scene;
  const Ids subject = idsOf(look.subject.structures);
  const Ids noted = annotatedStructures(scene);  // a picture must show them
  Box box;
  for (const VisibleStructure& each : visibleStructures(scene))
    if (subject.contains(each.node->id.value))
      box.add(each.node->mesh->bounds());
  const glm::vec3 size = box.high - box.low;
  const Box whole = scene.visibleBounds();
  constexpr float small = 0.4f;
  if (noted.empty() && glm::length(size) < small * glm::length(whole.high - whole.low)) {
    // A subject that is small in the scene, such as a lesion, has something of the scene around it;
    // a ligand has it already with its pocket.
    const float around = look.subject.pockets.empty() ? 0.4f : 0.08f;
    const glm::vec3 more(around * glm::length(size));
    return fitted(look.camera, Box{box.low - more, box.high + more}.corners(), aspect, sides);
  }
  constexpr float around = 0.7f;  // of the subject's length may be context's on either side
  const glm::vec3 more(around * std::max({size.x, size.y, size.z}));
  std::vector<Node> nodes = scene.nodes();
  for (Node& node : nodes) {
    if (node.isGroup())
      continue;
    const bool asked = subject.contains(node.id.value) || noted.contains(node.id.value);
    const Box own = node.mesh->bounds();
    const bool fits = glm::all(glm::greaterThanEqual(own.low, box.low - more)) &&
                      glm::all(glm::lessThanEqual(own.high, box.high + more));
    if (!asked && !fits)
      node.style.visible = false;
  }
  Scene shown = scene;
  shown.setNodes(std::move(nodes));
  return fittedToVisible(shown, look.camera, aspect, sides);
}

}  // namespace sline::model
