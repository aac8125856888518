// SPDX-License-Identifier: Apache-2.0
// Where in a JSON text its values are: parsers say what they read, not where.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sline::cli {

/// From 1; columns count characters.
struct TextPlace {
  std::size_t line = 1;
  std::size_t column = 1;
  /// "line 3, column 8".
  std::string text() const;
};

/// A byte of the text, or its end.
TextPlace placeOf(std::string_view text, std::size_t byte);

/// An element of the list, and the keys of one that is an object, in the text's order.
struct ElementPlace {
  TextPlace at;
  struct Key {
    std::string name;
    TextPlace at;
  };
  std::vector<Key> keys;
};
/// Of a text that is a list and was parsed without fault.
std::vector<ElementPlace> placesOfList(std::string_view text);

}  // namespace sline::cli
