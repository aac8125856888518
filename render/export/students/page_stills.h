// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/export/students/page_words.h"

namespace sline::render {

/// Returns a <figure> for each view of the page's order: its picture with numbers at what labels
/// name, its title and text, and the key. It is what browsers show that run no scripts. A silent
/// page has pictures and titles of sides alone. `shown` says what each picture shows.
Result<std::string> pageStills(const ExportOrder& order, const PageWords& words,
                               const std::vector<WordsByLanguage>& shown,
                               const ExportProgress& progress);

}  // namespace sline::render
