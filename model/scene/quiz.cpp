// SPDX-License-Identifier: Apache-2.0
#include "model/scene/quiz.h"

#include <algorithm>
#include <random>
#include <utility>

namespace sline::model {

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
