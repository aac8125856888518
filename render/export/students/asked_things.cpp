// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/asked_things.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "model/anatomy/anatomical_names.h"
#include "model/anatomy/body_systems.h"
#include "model/anatomy/kin_names.h"
#include "model/scene/markup.h"
#include "model/scene/question.h"
#include "model/scene/visible_structures.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "render/export/students/answer_hash.h"

namespace sline::render {

namespace {

/// Returns the name, and everything that what it names is called in any language.
std::vector<std::string> acceptedNames(const WordsByLanguage& words) {
  static const model::AnatomicalNames names;
  std::vector<std::string> accepted;
  for (const auto& [tag, text] : words) {
    accepted.push_back(text);
    if (names.knows(text))
      for (std::string& other : names.searchWords(text))
        accepted.push_back(std::move(other));
  }
  std::sort(accepted.begin(), accepted.end());
  accepted.erase(std::unique(accepted.begin(), accepted.end()), accepted.end());
  return accepted;
}

const model::Annotation& annotationOf(const model::Scene& scene, model::AnnotationId id) {
  return *std::find_if(scene.annotations().begin(), scene.annotations().end(),
                       [id](const model::Annotation& each) { return each.id == id; });
}

void addLabelled(std::vector<AskedThing>& things, const ExportOrder& order, const PageWords& words,
                 std::optional<int> view) {
  ExportOrder one = order;
  one.labels.language = words.language();
  for (const model::Question& question : questionsOf(one)) {
    const WordsByLanguage said = words.ofLabel(annotationOf(one.scene, question.labels.front()));
    const bool known = std::any_of(things.begin(), things.end(),
                                   [&said](const AskedThing& each) { return each.words == said; });
    if (!known && !normalisedAnswer(said.at(words.language())).empty())
      things.push_back({said, question.structures, question.labels, acceptedNames(said), view});
  }
}

bool isAmong(const model::Scene& scene, model::NodeId id, const std::vector<model::NodeId>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(),
                     [&](model::NodeId node) { return node == id || scene.isBelow(id, node); });
}

WordsByLanguage spokenName(const std::string& name, const PageWords& words) {
  // Names of answers are needed where the page itself says none.
  model::Annotation label;
  label.text = name;
  label.anchors.emplace_back();
  return words.ofLabel(label);
}

void addVisible(std::vector<AskedThing>& things, const ExportOrder& order, const PageWords& words) {
  const model::Scene& scene = order.scene;
  std::vector<model::NodeId> wanted;
  for (const std::string& name : askedNames(order))
    for (const model::NodeId id : scene.named(name))
      wanted.push_back(id);
  const bool focus = order.of<TestOptions>().of == AskedOf::focus;
  for (const model::VisibleStructure& structure : model::visibleStructures(scene)) {
    const model::NodeId id = structure.node->id;
    if ((focus && !isAmong(scene, id, scene.focus().targets)) ||
        (!askedNames(order).empty() && !isAmong(scene, id, wanted)))
      continue;
    const WordsByLanguage said = spokenName(structure.node->name, words);
    if (normalisedAnswer(said.at(words.language())).empty())
      continue;
    auto same = std::find_if(things.begin(), things.end(),
                             [&said](const AskedThing& each) { return each.words == said; });
    if (same == things.end())
      same = things.insert(things.end(), {said, {}, {}, acceptedNames(said), {}});
    same->structures.push_back(id);
  }
}

std::set<std::string> normalisedOf(const std::vector<std::string>& names) {
  std::set<std::string> all;
  for (const std::string& name : names)
    all.insert(normalisedAnswer(name));
  return all;
}

/// Tells whether one name is the other with a side added, so that both are right.
bool differBySideAlone(const std::string& a, const std::string& b) {
  const model::KinName one = model::kinName(a);
  const model::KinName other = model::kinName(b);
  return !one.pair.empty() && one.pair == other.pair &&
         (one.side == model::Side::none || other.side == model::Side::none);
}

/// Returns the distance between two boxes, millimetres.
float gapBetween(const model::Box& a, const model::Box& b) {
  return glm::length(glm::max(glm::max(a.low - b.high, b.low - a.high), glm::vec3(0.0f)));
}

}  // namespace

std::vector<AskedThing> askedThings(const ExportOrder& order, const PageWords& words) {
  std::vector<AskedThing> things;
  addLabelled(things, order, words, {});
  const std::vector<model::View>& views = order.scene.views();
  for (std::size_t i = 0; i < views.size(); ++i)
    addLabelled(things, orderOfView(order, views[i]), words, int(i) + 1);
  if (order.scene.annotations().empty())
    addVisible(things, order, words);
  return things;
}

Distractors::Distractors(const ExportOrder& order, const PageWords& words,
                         const std::vector<AskedThing>& asked)
    : m_scene(order.scene) {
  for (const AskedThing& thing : asked)
    add(thing.words, thing.structures);
  for (const model::VisibleStructure& structure : model::visibleStructures(order.scene))
    add(spokenName(structure.node->name, words), {structure.node->id});
}

void Distractors::add(const WordsByLanguage& words, const std::vector<model::NodeId>& structures) {
  if (!structures.empty())
    m_candidates.push_back({words, structures, normalisedOf(acceptedNames(words))});
}

std::optional<std::size_t> Distractors::systemOf(model::NodeId id) const {
  static const model::AnatomyTable table;
  const auto match = table.match(m_scene.find(id)->name);
  return match ? std::optional(match->system) : std::nullopt;
}

float Distractors::likeness(model::NodeId a, model::NodeId b) const {
  constexpr float far = 25.0f;  // mm, at which nearness counts half
  const model::Node& one = *m_scene.find(a);
  const model::Node& other = *m_scene.find(b);
  const auto system = systemOf(a);
  return (one.parent == other.parent ? 1.0f : 0.0f) +
         (system && system == systemOf(b) ? 1.0f : 0.0f) +
         far / (far + gapBetween(one.mesh->bounds(), other.mesh->bounds()));
}

std::vector<WordsByLanguage> Distractors::of(const AskedThing& thing, std::size_t most) const {
  const std::set<std::string> right = normalisedOf(thing.accepted);
  struct Rated {
    const Candidate* candidate;
    float likeness;
  };
  std::vector<Rated> rated;
  for (const Candidate& one : m_candidates) {
    const bool isRight =
        std::any_of(one.structures.begin(), one.structures.end(),
                    [&](model::NodeId id) { return isAmong(m_scene, id, thing.structures); }) ||
        std::any_of(
            one.normalised.begin(), one.normalised.end(),
            [&right](const std::string& name) { return name.empty() || right.contains(name); }) ||
        differBySideAlone(one.words.begin()->second, thing.words.begin()->second);
    if (!isRight)
      rated.push_back({&one, thing.structures.empty()
                                 ? 0.0f
                                 : likeness(thing.structures.front(), one.structures.front())});
  }
  std::stable_sort(rated.begin(), rated.end(),
                   [](const Rated& a, const Rated& b) { return a.likeness > b.likeness; });
  std::vector<WordsByLanguage> chosen;
  std::set<std::string> said;
  for (const Rated& one : rated) {
    const bool fresh =
        std::none_of(one.candidate->normalised.begin(), one.candidate->normalised.end(),
                     [&said](const std::string& name) { return said.contains(name); });
    if (!fresh || chosen.size() == most)
      continue;
    chosen.push_back(one.candidate->words);
    said.insert(one.candidate->normalised.begin(), one.candidate->normalised.end());
  }
  return chosen;
}

}  // namespace sline::render
