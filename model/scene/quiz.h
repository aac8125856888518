// SPDX-License-Identifier: Apache-2.0
// Asks questions one after the other and counts the answers.
#pragma once

#include <cstdint>
#include <vector>

#include "model/scene/question.h"

namespace sline::model {

/// Asks questions in a random order, each once, and counts those that were answered right.
class Quiz {
 public:
  Quiz(std::vector<Question> questions, std::uint32_t seed);

  std::size_t size() const { return m_questions.size(); }
  /// Returns the place of the question in the order of asking, from 0; `size()` after the last.
  std::size_t at() const { return m_at; }
  bool done() const { return m_at == m_questions.size(); }
  /// Returns the question; the quiz must not be done.
  const Question& question() const { return m_questions[m_at]; }
  /// Takes the first answer to the question; returns whether it is right. Later ones are not
  /// counted.
  bool answer(NodeId structure);
  bool answered() const { return m_answered; }
  /// Goes on to the next question, whether this one was answered or not.
  void next();
  std::size_t right() const { return m_right; }

 private:
  std::vector<Question> m_questions;
  std::size_t m_at = 0;
  std::size_t m_right = 0;
  bool m_answered = false;
};

}  // namespace sline::model
