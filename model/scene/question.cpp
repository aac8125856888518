// SPDX-License-Identifier: Apache-2.0
#include "model/scene/question.h"

#include <algorithm>
#include <set>
#include <utility>

#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "model/scene/markup.h"

namespace sline::model {

namespace {

/// Decides which annotations are asked for.
class QuestionFilter {
 public:
  QuestionFilter(const Scene& scene, const QuestionChoice& choice)
      : m_scene(scene), m_choice(choice) {
    for (const std::string& name : choice.names)
      for (const NodeId id : scene.named(name))
        m_named.push_back(id);
  }

  bool asks(const Annotation& annotation) const {
    const bool names = annotation.kind == AnnotationKind::label ||
                       annotation.kind == AnnotationKind::pin ||
                       (m_choice.callouts && annotation.kind == AnnotationKind::callout);
    if (!annotation.visible || !names || annotation.anchors.empty() ||
        namesInDoubt(m_scene, annotation))
      return false;
    const auto* point = std::get_if<SurfacePoint>(&annotation.anchors.front());
    if (!point)
      return m_choice.inSpace && !m_choice.focusAlone && m_choice.names.empty();
    return m_scene.find(point->structure) && m_scene.resolve(point->structure).visible &&
           (!m_choice.focusAlone || isBelowAny(point->structure, m_scene.focus().targets)) &&
           (m_choice.names.empty() || isBelowAny(point->structure, m_named));
  }

 private:
  bool isBelowAny(NodeId structure, const std::vector<NodeId>& nodes) const {
    return std::any_of(nodes.begin(), nodes.end(),
                       [&](NodeId node) { return m_scene.isBelow(structure, node); });
  }

  const Scene& m_scene;
  const QuestionChoice& m_choice;
  std::vector<NodeId> m_named;
};

std::string wordsOfQuestion(const Annotation& annotation, const std::string& language) {
  return annotation.kind == AnnotationKind::callout ? plainTextIn(annotation, language)
                                                    : writtenIn(annotation, language);
}

}  // namespace

std::string sharedName(const Scene& scene, const std::string& text) {
  const std::size_t at = text.find_last_not_of("0123456789");
  if (at == std::string::npos || at + 1 == text.size() || text[at] != ' ')
    return text;
  const std::string shared = text.substr(0, at);
  const auto& nodes = scene.nodes();
  const bool known = std::any_of(nodes.begin(), nodes.end(), [&shared](const Node& node) {
    return !node.isGroup() && node.name == shared;
  });
  return known ? shared : text;
}

std::vector<Question> questionsOf(const Scene& scene, const std::string& language,
                                  const QuestionChoice& choice) {
  const QuestionFilter filter(scene, choice);
  std::vector<Question> questions;
  for (const Annotation& annotation : scene.annotations()) {
    if (!filter.asks(annotation))
      continue;
    const std::string words = sharedName(scene, wordsOfQuestion(annotation, language));
    if (words.find_first_not_of(" \t\r\n") == std::string::npos)
      continue;
    auto same = std::find_if(questions.begin(), questions.end(),
                             [&words](const Question& each) { return each.words == words; });
    if (same == questions.end())
      same = questions.insert(questions.end(), Question{words, {}, {}});
    if (const auto* point = std::get_if<SurfacePoint>(&annotation.anchors.front()))
      same->structures.push_back(point->structure);
    same->labels.push_back(annotation.id);
  }
  return questions;
}

Scene withQuestionsAlone(const Scene& scene, const std::vector<Question>& questions) {
  std::set<AnnotationId> asked;
  for (const Question& question : questions)
    asked.insert(question.labels.begin(), question.labels.end());
  std::vector<Annotation> annotations = scene.annotations();
  for (Annotation& annotation : annotations)
    annotation.visible = asked.contains(annotation.id);
  Scene alone = scene;
  alone.setAnnotations(std::move(annotations));
  return alone;
}

}  // namespace sline::model
