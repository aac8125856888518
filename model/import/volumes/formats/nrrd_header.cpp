// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/formats/nrrd_header.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "model/base/letters.h"
#include "model/import/source/text_cursor.h"

namespace sline::model {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && TextCursor::isSpace(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && TextCursor::isSpace(text.back()))
    text.remove_suffix(1);
  return text;
}

/// Returns one name for each meaning; the format allows some fields two names.
std::string canonical(std::string name) {
  static constexpr std::pair<std::string_view, std::string_view> same[] = {
      {"datafile", "data file"}, {"byteskip", "byte skip"}, {"lineskip", "line skip"},
      {"axismins", "axis mins"}, {"centerings", "centers"}, {"sampleunits", "sample units"}};
  for (const auto& [other, usual] : same)
    if (name == other)
      return std::string(usual);
  return name;
}

std::string_view textOf(const std::map<std::string, std::string, std::less<>>& map,
                        std::string_view name) {
  const auto found = map.find(name);
  return found == map.end() ? std::string_view() : std::string_view(found->second);
}

}  // namespace

std::string_view NrrdHeader::field(std::string_view name) const {
  return textOf(fields, name);
}

std::string_view NrrdHeader::key(std::string_view name) const {
  return textOf(keys, name);
}

Result<NrrdHeader> nrrdHeader(const Source& source) {
  constexpr std::size_t mostLines = 100'000;
  if (!source.text().starts_with("NRRD0"))
    return source.atByte(source.begin(), "does not begin with NRRD0, as NRRD files do");
  NrrdHeader header;
  TextCursor at(source.text());
  at.skipLine();
  for (std::size_t line = 0; !at.atEnd(); ++line) {
    const char* begin = at.at();
    at.skipLine();
    const std::string_view text = trimmed({begin, std::size_t(at.at() - begin)});
    if (text.empty())
      break;
    if (text.front() == '#')
      continue;
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos || line > mostLines)
      return source.atLine(begin, "is no line of an NRRD header: " + inQuotes(text));
    if (colon + 1 < text.size() && text[colon + 1] == '=')
      header.keys.insert_or_assign(std::string(trimmed(text.substr(0, colon))),
                                   std::string(trimmed(text.substr(colon + 2))));
    else
      header.fields.insert_or_assign(canonical(lowerCase(trimmed(text.substr(0, colon)))),
                                     std::string(trimmed(text.substr(colon + 1))));
  }
  header.data = source.text().substr(std::size_t(at.at() - source.begin()));
  return header;
}

std::vector<std::optional<glm::dvec3>> nrrdVectors(std::string_view text) {
  std::vector<std::optional<glm::dvec3>> vectors;
  // Commas and brackets become blanks, so that numbers stand alone; some writers put blanks inside.
  std::string plain(text);
  std::replace(plain.begin(), plain.end(), ',', ' ');
  TextCursor at(plain);
  for (at.skipSpace(); !at.atEnd(); at.skipSpace()) {
    if (at.peek() != '(') {
      if (at.word() != "none")
        return {};
      vectors.emplace_back();
      continue;
    }
    const auto left = std::size_t(at.end() - at.at());
    const std::size_t close = std::string_view(at.at(), left).find(')');
    if (close == std::string_view::npos)
      return {};
    TextCursor inside(at.at() + 1, at.at() + close);
    glm::dvec3 v(0.0);
    for (int i = 0; i < 3; ++i) {
      inside.skipSpace();
      if (!inside.number(v[i]) || !std::isfinite(v[i]))
        return {};
    }
    inside.skipSpace();
    // A space of four dimensions has one that is no place; an axis along it lies in none.
    double other = 0.0;
    const bool four = !inside.atEnd();
    if (four && (!inside.number(other) || !std::isfinite(other)))
      return {};
    inside.skipSpace();
    if (!inside.atEnd())
      return {};
    at.moveTo(at.at() + close + 1);
    vectors.emplace_back(v);
    if (four && v == glm::dvec3(0.0) && other != 0.0)
      vectors.back().reset();
  }
  return vectors;
}

}  // namespace sline::model
