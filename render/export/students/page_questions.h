// SPDX-License-Identifier: Apache-2.0
// Makes the questions of a page's quiz from what labels name or, in a scene without labels, from
// the names of what is visible.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/export/students/page_words.h"

namespace sline::render {

struct PageQuestion {
  std::string id;         ///< "find-3"
  std::string kind;       ///< "find", "name", "choose", "order" or "drag"
  WordsByLanguage words;  ///< what is asked for, or the answer
  std::vector<model::NodeId> structures;
  std::vector<model::AnnotationId> labels;
  std::vector<WordsByLanguage> choices;
  std::optional<int> right;           ///< which of the choices is right, from 0
  std::vector<std::string> accepted;  ///< names that are right, in all languages
  std::optional<int> view;            ///< in which it is shown, from 1
};

/// Returns the questions in the order of the labels. A silent page has those alone whose answers
/// are typed.
std::vector<PageQuestion> pageQuestions(const ExportOrder& order, const StudentsOptions& own,
                                        const PageWords& words);

/// Tells whether there is anything to ask for; it is quick.
bool hasQuestions(const ExportOrder& order);

}  // namespace sline::render
