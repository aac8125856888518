// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/asked_things.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "model/anatomy/body_systems.h"
#include "model/anatomy/kin_names.h"
#include "model/base/letters.h"
#include "model/scene/known_frame.h"
#include "model/scene/markup.h"
#include "model/scene/question.h"
#include "model/scene/visible_structures.h"
#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/plate/shown_questions.h"
#include "render/export/students/accepted_answers.h"
#include "render/export/students/answer_hash.h"
#include "render/labels/seen/seen_map.h"
#include "render/lettering/label_painter.h"

namespace sline::render {

namespace {

const model::Annotation& annotationOf(const model::Scene& scene, model::AnnotationId id) {
  return *std::find_if(scene.annotations().begin(), scene.annotations().end(),
                       [id](const model::Annotation& each) { return each.id == id; });
}

/// A picture that is asked about, and what is known of its meshes.
struct AskedPicture {
  ExportOrder order;
  std::optional<int> view;  ///< from 1
  model::MeshTrees& trees;
};

/// Returns what the picture can be asked, in the order of the numbers that it gives the labels.
std::vector<model::Question> questionsInOrder(const AskedPicture& picture) {
  std::vector<model::Question> questions = shownQuestions(picture.order, picture.trees).questions;
  LabelStyle style = picture.order.labels;
  style.mode = LabelMode::numbers;
  const Screen screen = pageScreen(picture.order);
  if (questions.size() > 1)
    putInOrderOfNumbers(questions, labelPlate(askedAlone(picture.order, questions).scene, screen,
                                              style, picture.trees));
  return questions;
}

WordsByLanguage spokenName(const std::string& name, const PageWords& words) {
  // Names of answers are needed where the page itself says none.
  model::Annotation label;
  label.text = name;
  label.anchors.emplace_back();
  return words.ofLabel(label);
}

void addLabelled(std::vector<AskedThing>& things, AskedPicture picture, const PageWords& words) {
  picture.order.labels.language = words.language();
  for (const model::Question& question : questionsInOrder(picture)) {
    const model::Annotation& label = annotationOf(picture.order.scene, question.labels.front());
    const bool counted = model::sharedName(picture.order.scene, label.text) != label.text;
    const WordsByLanguage said = counted ? spokenName(question.words, words) : words.ofLabel(label);
    const bool known = std::any_of(things.begin(), things.end(),
                                   [&said](const AskedThing& each) { return each.words == said; });
    if (!known && !normalisedAnswer(said.at(words.language())).empty())
      things.push_back({said, question.structures, question.labels, {}, picture.view});
  }
}

bool isAmong(const model::Scene& scene, model::NodeId id, const std::vector<model::NodeId>& nodes) {
  return std::any_of(nodes.begin(), nodes.end(),
                     [&](model::NodeId node) { return node == id || scene.isBelow(id, node); });
}

/// Adds what one sees well where nothing has a label.
void addSeen(std::vector<AskedThing>& things, const AskedPicture& picture, const PageWords& words) {
  const ExportOrder& order = picture.order;
  const model::Scene& scene = order.scene;
  std::vector<model::NodeId> wanted;
  for (const std::string& name : askedNames(order))
    for (const model::NodeId id : scene.named(name))
      wanted.push_back(id);
  const bool focus = order.of<TestOptions>().of == AskedOf::focus;
  const SeenMap map(scene, pageScreen(order), &picture.trees);
  for (const model::VisibleStructure& structure : model::visibleStructures(scene)) {
    const model::NodeId id = structure.node->id;
    if ((focus && !isAmong(scene, id, scene.focus().targets)) ||
        (!askedNames(order).empty() && !isAmong(scene, id, wanted)))
      continue;
    const std::optional<SeenPlace> place = map.find(id);
    if (!place || place->hidden || !place->sure || model::isNameDoubted(*structure.node))
      continue;
    const WordsByLanguage said = spokenName(model::sharedName(scene, structure.node->name), words);
    if (normalisedAnswer(said.at(words.language())).empty())
      continue;
    auto same = std::find_if(things.begin(), things.end(),
                             [&said](const AskedThing& each) { return each.words == said; });
    if (same == things.end())
      same = things.insert(things.end(), {said, {}, {}, {}, picture.view});
    if (same->view == picture.view)
      same->structures.push_back(id);
  }
}

/// Says which names are right, beside all that has a name in the scene.
void acceptNames(std::vector<AskedThing>& things, const model::Scene& scene,
                 const PageWords& words) {
  std::set<WordsByLanguage> all;
  for (const model::NodeId id : scene.structuresBelow(model::rootId))
    all.insert(spokenName(model::sharedName(scene, scene.find(id)->name), words));
  for (const AskedThing& thing : things)
    all.insert(thing.words);
  std::vector<AcceptedAnswers> known;
  known.reserve(all.size());
  for (const WordsByLanguage& each : all)
    known.push_back(acceptedAnswers(each));
  for (AskedThing& thing : things)
    thing.accepted = ownAnswers(thing.words, known);
}

void addShown(std::vector<AskedThing>& things, AskedPicture picture, const PageWords& words) {
  if (picture.order.scene.annotations().empty())
    addSeen(things, picture, words);
  else
    addLabelled(things, std::move(picture), words);
}

std::set<std::string> normalisedOf(const std::vector<std::string>& names) {
  std::set<std::string> all;
  for (const std::string& name : names)
    all.insert(normalisedAnswer(name));
  return all;
}

std::set<std::string> normalisedOf(const AcceptedAnswers& answers) {
  std::set<std::string> all = normalisedOf(answers.names);
  all.merge(normalisedOf(answers.brief));
  return all;
}

/// Tells whether one name is the other with a side added, so that both are right.
bool differBySideAlone(const std::string& a, const std::string& b) {
  const model::KinName one = model::kinName(a);
  const model::KinName other = model::kinName(b);
  return !one.pair.empty() && one.pair == other.pair &&
         (one.side == model::Side::none || other.side == model::Side::none);
}

/// Returns the words written as those of the right answer are, which would stand out among them:
/// with a capital at the beginning, and blanks for what joins words.
WordsByLanguage writtenLike(const WordsByLanguage& right, WordsByLanguage words) {
  for (auto& [tag, text] : words) {
    const auto like = right.find(tag);
    if (like == right.end() || like->second.empty() || text.empty())
      continue;
    if (like->second.find('_') == std::string::npos)
      std::replace(text.begin(), text.end(), '_', ' ');
    if (isUpper(like->second.front()) && isLower(text.front()))
      text.front() = char(text.front() - 'a' + 'A');
  }
  return words;
}

/// Returns the distance between two boxes, millimetres.
float gapBetween(const model::Box& a, const model::Box& b) {
  return glm::length(glm::max(glm::max(a.low - b.high, b.low - a.high), glm::vec3(0.0f)));
}

}  // namespace

std::vector<AskedThing> askedThings(const ExportOrder& order, const PageWords& words) {
  std::vector<AskedThing> things;
  model::MeshTrees trees;
  const std::vector<model::View>& views = order.scene.views();
  if (views.empty())
    addShown(things, {order, {}, trees}, words);
  for (std::size_t i = 0; i < views.size(); ++i)
    addShown(things, {orderOfView(order, views[i]), int(i) + 1, trees}, words);
  acceptNames(things, order.scene, words);
  return things;
}

Distractors::Distractors(const ExportOrder& order, const PageWords& words,
                         const std::vector<AskedThing>& asked)
    : m_scene(order.scene) {
  for (const AskedThing& thing : asked)
    add(thing.words, thing.structures);
  for (const model::VisibleStructure& structure : model::visibleStructures(order.scene))
    add(spokenName(model::sharedName(order.scene, structure.node->name), words),
        {structure.node->id});
}

void Distractors::add(const WordsByLanguage& words, const std::vector<model::NodeId>& structures) {
  if (!structures.empty())
    m_candidates.push_back({words, structures, normalisedOf(acceptedAnswers(words))});
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
    chosen.push_back(writtenLike(thing.words, one.candidate->words));
    said.insert(one.candidate->normalised.begin(), one.candidate->normalised.end());
  }
  return chosen;
}

}  // namespace sline::render
