// SPDX-License-Identifier: Apache-2.0
// Puts a students' page together from what all pages share and what one of them has of its own:
// fills the placeholders of page.html.
#pragma once

#include <map>
#include <string>

namespace sline::render {

struct PageTemplate;

/// What a page has of its own.
struct PageContent {
  std::string language;
  std::string title;
  std::string stills;   ///< HTML of the still pictures
  std::string facts;    ///< JSON, as resources/page/facts.d.ts has it
  std::string scene;    ///< packed, not yet in gzip
  std::string context;  ///< likewise what comes later; empty: nothing does
};

struct PageForm {
  bool folder = false;  ///< several files instead of one
  std::string report;   ///< the kind of learning system that hears of answers; empty: none does
};

struct AssembledPage {
  std::string html;
  std::map<std::string, std::string> files;  ///< by name, those beside the page
};

AssembledPage assembledPage(const PageTemplate& page, const PageContent& content,
                            const PageForm& form);

}  // namespace sline::render
