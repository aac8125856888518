// SPDX-License-Identifier: Apache-2.0
// Says what a page says in each of its languages, as the JSON that its script reads
// (resources/page/facts.d.ts).
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/scene/link_target.h"
#include "render/export/order/export_order.h"
#include "render/export/students/students_options.h"

namespace sline::render {

using Json = nlohmann::json;

/// Holds a text in each language, by tag.
using WordsByLanguage = std::map<std::string, std::string>;

class PageWords {
 public:
  PageWords(const ExportOrder& order, const StudentsOptions& own);

  /// Returns the languages' tags, first that in which the page opens.
  const std::vector<std::string>& languages() const { return m_languages; }
  const std::string& language() const { return m_languages.front(); }
  /// Leaves names as the scene has them, as pictures do where no language was chosen.
  void keepNames() { m_kept = true; }
  /// Tells whether the page must not name any structure.
  bool silent() const { return m_silent; }

  /// Returns what a structure or group of that name is called; nothing in a silent page.
  WordsByLanguage ofName(const model::Node& node) const;
  /// Returns what a label says as plain text, in languages in which it has no text the name that it
  /// is there; the same in a silent page, for answers.
  WordsByLanguage ofLabel(const model::Annotation& annotation) const;
  /// Returns them without the mark of a name that is in doubt, which pictures add by themselves.
  WordsByLanguage unmarked(const model::Annotation& annotation) const;
  /// Returns what it says in lines of runs; nothing in a silent page.
  Json linesOf(const model::Annotation& annotation) const;
  /// Returns marked-up text in lines of runs, with links; nothing in a silent page.
  Json linesOf(const model::Wording& wording) const;
  /// Returns the title of a view; in a silent page only that of a side of the body.
  WordsByLanguage titleOf(const model::View& view) const;
  /// Returns the page's title.
  std::string title() const;

 private:
  std::optional<model::LinkTarget> targetOf(const model::MarkupLink& link) const;
  Json markedLines(const std::string& text) const;
  Json plainLines(const std::string& text) const;

  const model::Scene& m_scene;
  std::string m_title;
  std::string m_fileTitle;
  std::vector<std::string> m_languages;
  bool m_silent;
  bool m_kept = false;
};

}  // namespace sline::render
