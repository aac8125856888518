// SPDX-License-Identifier: Apache-2.0
#include "model/scene/question.h"

#include <algorithm>
#include <random>
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

std::vector<Question> questionsOf(const Scene& scene, const std::string& language,
                                  const QuestionChoice& choice) {
  const QuestionFilter filter(scene, choice);
  std::vector<Question> questions;
  for (const Annotation& annotation : scene.annotations()) {
    if (!filter.asks(annotation))
      continue;
    const std::string words = wordsOfQuestion(annotation, language);
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

std::vector<std::string> wordBank(const std::vector<std::string>& answers) {
  std::vector<std::string> bank = answers;
  // From the alphabet's order, so that the order of the answers leaves no trace.
  std::sort(bank.begin(), bank.end());
  std::mt19937 random(20011);
  for (std::size_t i = bank.size(); i > 1; --i)
    std::swap(bank[i - 1], bank[random() % i]);
  for (std::size_t i = 1; i < bank.size() && bank == answers; ++i)
    std::rotate(bank.begin(), bank.begin() + 1, bank.end());
  return bank;
}

}  // namespace sline::model
