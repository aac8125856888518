// SPDX-License-Identifier: Apache-2.0
// Gathers what a page's quiz can ask for.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "render/export/students/page_words.h"

namespace sline::render {

/// Something that has a name, and where it is.
struct AskedThing {
  WordsByLanguage words;
  std::vector<model::NodeId> structures;
  std::vector<model::AnnotationId> labels;
  std::vector<std::string> accepted;
  std::optional<int> view;  ///< the first in which one sees it, from 1; absent: there are no views
};

/// Returns what the order's views show of what labels name (shown_questions.h) or, where the scene
/// has no labels, of all that has a name; without views what its picture shows. Pages open on their
/// first view and know no other pictures.
std::vector<AskedThing> askedThings(const ExportOrder& order, const PageWords& words);

/// Offers names that are wrong answers.
class Distractors {
 public:
  Distractors(const ExportOrder& order, const PageWords& words,
              const std::vector<AskedThing>& asked);

  /// Returns up to so many names of other structures, the likeliest mistakes first: neighbours, and
  /// what is of the same group or system. None of them may be taken for a right answer.
  std::vector<WordsByLanguage> of(const AskedThing& thing, std::size_t most) const;

 private:
  struct Candidate {
    WordsByLanguage words;
    std::vector<model::NodeId> structures;
    std::set<std::string> normalised;
  };
  void add(const WordsByLanguage& words, const std::vector<model::NodeId>& structures);
  float likeness(model::NodeId a, model::NodeId b) const;
  std::optional<std::size_t> systemOf(model::NodeId id) const;

  const model::Scene& m_scene;
  std::vector<Candidate> m_candidates;
};

}  // namespace sline::render
