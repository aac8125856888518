// SPDX-License-Identifier: Apache-2.0
// Reads the tags of an XML file, one after another, without building a tree: enough to check
// numbers in a file before a library that trusts them reads it.
#pragma once

#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace sline::model {

struct XmlTag {
  std::string_view text;  ///< from < to > inclusive; points into the file
  std::string_view name;
  bool closing = false;                                                   ///< </name>
  bool empty = false;                                                     ///< <name/>
  std::vector<std::pair<std::string_view, std::string_view>> attributes;  ///< entities unresolved

  /// Returns the attribute's text, or an empty one.
  std::string_view attribute(std::string_view key) const;
  const char* begin() const { return text.data(); }
  const char* end() const { return text.data() + text.size(); }
};

class XmlTags {
 public:
  explicit XmlTags(std::string_view text) : m_text(text) {}

  /// Returns the next element tag; comments, declarations and text between, CDATA too, are stepped
  /// over. Returns nothing at the end and where a tag is malformed: `failure()` tells which.
  std::optional<XmlTag> next();
  /// Returns where the first malformed tag or document type declaration is, else null.
  const char* failure() const { return m_failure; }

 private:
  std::optional<XmlTag> parse(std::string_view tag);
  std::string_view m_text;
  std::size_t m_at = 0;
  const char* m_failure = nullptr;
};

}  // namespace sline::model
