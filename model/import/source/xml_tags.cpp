// SPDX-License-Identifier: Apache-2.0
#include "model/import/source/xml_tags.h"

#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {
constexpr std::size_t nowhere = std::string_view::npos;

/// Returns the place one past the > that ends the tag at `at`, quotes respected.
std::size_t tagEnd(std::string_view text, std::size_t at) {
  char quote = '\0';
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != '\0')
      quote = c == quote ? '\0' : quote;
    else if (c == '"' || c == '\'')
      quote = c;
    else if (c == '>')
      return at + 1;
  }
  return nowhere;
}
}  // namespace

std::string_view XmlTag::attribute(std::string_view key) const {
  for (const auto& [attributeName, value] : attributes)
    if (attributeName == key)
      return value;
  return {};
}

std::optional<XmlTag> XmlTags::next() {
  while (true) {
    m_at = m_text.find('<', m_at);
    if (m_at == nowhere)
      return std::nullopt;
    const std::string_view rest = m_text.substr(m_at);
    std::size_t length = nowhere;
    const bool text = rest.starts_with("<![CDATA[");
    const bool skipped = text || rest.starts_with("<!--") || rest.starts_with("<?");
    if (skipped) {
      const std::string_view closing = text ? "]]>" : rest[1] == '?' ? "?>" : "-->";
      length = rest.find(closing);
      length = length == nowhere ? nowhere : length + closing.size();
    } else if (!rest.starts_with("<!")) {
      length = tagEnd(rest, 0);
    }
    if (length == nowhere) {
      m_failure = rest.data();
      return std::nullopt;
    }
    m_at += length;
    if (!skipped)
      return parse(rest.substr(0, length));
  }
}

std::optional<XmlTag> XmlTags::parse(std::string_view tag) {
  XmlTag result;
  result.text = tag;
  std::string_view inside = tag.substr(1, tag.size() - 2);
  if (inside.starts_with('/')) {
    result.closing = true;
    inside.remove_prefix(1);
  } else if (inside.ends_with('/')) {
    result.empty = true;
    inside.remove_suffix(1);
  }
  TextCursor at(inside);
  result.name = at.word();
  for (at.skipSpace(); !at.atEnd(); at.skipSpace()) {
    const std::string_view rest(at.at(), std::size_t(at.end() - at.at()));
    const std::size_t equals = rest.find('=');
    if (equals == nowhere)
      break;
    std::string_view key = rest.substr(0, equals);
    while (!key.empty() && TextCursor::isSpace(key.back()))
      key.remove_suffix(1);
    at.moveTo(at.at() + equals + 1);
    at.skipSpace();
    const char quote = at.peek();
    const char* start = at.at() + 1;
    const std::size_t length =
        at.atEnd() || (quote != '"' && quote != '\'')
            ? nowhere
            : std::string_view(start, std::size_t(at.end() - start)).find(quote);
    if (length == nowhere) {
      m_failure = tag.data();
      return std::nullopt;
    }
    result.attributes.emplace_back(key, std::string_view(start, length));
    at.moveTo(start + length + 1);
  }
  if (result.name.empty()) {
    m_failure = tag.data();
    return std::nullopt;
  }
  return result;
}

}  // namespace sline::model
