// SPDX-License-Identifier: Apache-2.0
#include "model/scene/quiz.h"

#include <algorithm>
#include <random>
#include <utility>

#include "model/scene/label_words.h"

namespace sline::model {

std::vector<Question> questionsOf(const Scene& scene, const std::string& language) {
  std::vector<Question> questions;
  for (const Annotation& annotation : scene.annotations()) {
    const bool names =
        annotation.kind == AnnotationKind::label || annotation.kind == AnnotationKind::pin;
    const auto* point = annotation.anchors.empty()
                            ? nullptr
                            : std::get_if<SurfacePoint>(&annotation.anchors.front());
    if (!annotation.visible || !names || !point || !scene.find(point->structure) ||
        !scene.resolve(point->structure).visible)
      continue;
    const std::string words = writtenIn(annotation, language);
    if (words.find_first_not_of(" \t\r\n") == std::string::npos)
      continue;
    const auto same = std::find_if(questions.begin(), questions.end(),
                                   [&words](const Question& each) { return each.words == words; });
    if (same == questions.end())
      questions.push_back({words, {point->structure}});
    else
      same->structures.push_back(point->structure);
  }
  return questions;
}

Quiz::Quiz(std::vector<Question> questions, std::uint32_t seed)
    : m_questions(std::move(questions)) {
  std::mt19937 random(seed);
  for (std::size_t i = m_questions.size(); i > 1; --i)
    std::swap(m_questions[i - 1], m_questions[random() % i]);
}

bool Quiz::answer(NodeId structure) {
  const std::vector<NodeId>& those = question().structures;
  const bool right = std::find(those.begin(), those.end(), structure) != those.end();
  if (!m_answered && right)
    ++m_right;
  m_answered = true;
  return right;
}

void Quiz::next() {
  if (!done())
    ++m_at;
  m_answered = false;
}

}  // namespace sline::model
