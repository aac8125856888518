// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/export/students/page_questions.h"
#include "render/export/students/page_words.h"

namespace sline::render {

/// What the facts say besides what the order says.
struct FactsExtras {
  float simplifiedMm = 0.0f;           ///< 0: no surface was simplified
  std::vector<WordsByLanguage> views;  ///< what each view's picture shows
  std::vector<PageQuestion> questions;
};

/// Returns the facts of the page of that order (`pageOrder`), as resources/page/facts.d.ts has
/// them: JSON, as resources/page/facts.d.ts has it.
std::string pageFacts(const ExportOrder& order, const StudentsOptions& own,
                      const FactsExtras& extras);

/// Returns what the order's picture shows, in each of the page's languages.
WordsByLanguage descriptionsOf(const ExportOrder& order, const PageWords& words);
/// Returns what the picture of each view shows.
std::vector<WordsByLanguage> descriptionsOfViews(const ExportOrder& order, const PageWords& words);

/// Returns whose work the page is and the surfaces are, line by line.
std::vector<std::string> creditsOf(const ExportOrder& order);

}  // namespace sline::render
