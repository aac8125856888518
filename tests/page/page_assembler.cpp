// SPDX-License-Identifier: Apache-2.0
// Puts a page together as the exporter does, of what a test gives: JSON on standard input with
// `facts`, `stills` and texts for `scene` and maybe `context`; SLINE_PAGE names what pages share.
// The page goes to standard output.
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "render/export/students/page_assembly.h"
#include "render/export/students/web_program.h"

int main() {
  using namespace sline;
  const nlohmann::json given = nlohmann::json::parse(std::cin, nullptr, false);
  if (given.is_discarded())
    return 2;
  const Result<render::PageTemplate> page = render::pageTemplate();
  if (!page.ok()) {
    std::fprintf(stderr, "%s\n", page.error().text().c_str());
    return 1;
  }
  const nlohmann::json& facts = given.at("facts");
  std::cout << render::assembledPage(*page,
                                     {.language = facts.at("language"),
                                      .title = facts.at("title"),
                                      .stills = given.at("stills"),
                                      .facts = facts.dump(),
                                      .scene = given.at("scene"),
                                      .context = given.value("context", std::string())},
                                     {})
                   .html;
  return 0;
}
