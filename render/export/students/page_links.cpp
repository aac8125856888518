// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/page_links.h"

#include <charconv>

namespace sline::render {

namespace {

constexpr std::string_view structureKey = "#structure=";
constexpr std::string_view viewKey = "#view=";

std::optional<int> viewNumber(std::string_view name, const model::Scene& scene) {
  const std::vector<model::View>& views = scene.views();
  int number = 0;
  const auto [end, fault] = std::from_chars(name.data(), name.data() + name.size(), number);
  if (fault == std::errc() && end == name.data() + name.size())
    return number >= 1 && std::size_t(number) <= views.size() ? std::optional(number)
                                                              : std::nullopt;
  for (std::size_t i = 0; i < views.size(); ++i)
    if (model::normalisedName(views[i].name) == model::normalisedName(name))
      return int(i) + 1;
  return std::nullopt;
}

/// Sets where the piece leads; returns false where the target is no link at all.
bool lead(LinkedPiece& piece, std::string_view target, const model::Scene& scene) {
  if (target.starts_with(structureKey)) {
    if (const auto named = scene.named(target.substr(structureKey.size())); !named.empty())
      piece.structure = named.front();
    return true;
  }
  if (!target.starts_with(viewKey))
    return false;
  piece.view = viewNumber(target.substr(viewKey.size()), scene);
  return true;
}

/// Returns the place of the character before the end of the line; npos where there is none.
std::size_t before(std::string_view text, char wanted, std::size_t from) {
  const std::size_t at = text.find(wanted, from);
  return at < text.find('\n', from) ? at : std::string_view::npos;
}

}  // namespace

std::vector<LinkedPiece> linkedPieces(std::string_view text, const model::Scene& scene) {
  std::vector<LinkedPiece> pieces;
  std::string plain;
  const auto flush = [&] {
    if (!plain.empty())
      pieces.push_back({.text = plain, .structure = {}, .view = {}});
    plain.clear();
  };
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t middle = text[at] == '[' ? before(text, ']', at) : std::string_view::npos;
    const bool opens = middle != std::string_view::npos && middle > at + 1 &&
                       middle + 1 < text.size() && text[middle + 1] == '(';
    const std::size_t end = opens ? before(text, ')', middle) : std::string_view::npos;
    LinkedPiece piece;
    if (end == std::string_view::npos ||
        !lead(piece, text.substr(middle + 2, end - middle - 2), scene)) {
      plain += text[at++];
      continue;
    }
    piece.text = text.substr(at + 1, middle - at - 1);
    if (piece.structure || piece.view) {
      flush();
      pieces.push_back(std::move(piece));
    } else {
      plain += piece.text;
    }
    at = end + 1;
  }
  flush();
  return pieces;
}

}  // namespace sline::render
