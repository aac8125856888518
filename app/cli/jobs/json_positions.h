// SPDX-License-Identifier: Apache-2.0
// Finds where in a JSON text its values are: parsers report what they read, not where it is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace sline::cli {

/// Holds a place counted from 1; columns count characters.
struct TextPosition {
  std::size_t line = 1;
  std::size_t column = 1;
  /// Returns "line 3, column 8".
  std::string text() const;
};

/// Returns the place of a byte of the text, or of its end.
TextPosition textPositionAt(std::string_view text, std::size_t byte);

/// Holds the place of one element of the list and, for an object, of its keys in the text's order.
struct ElementPositions {
  TextPosition at;
  struct Key {
    std::string name;
    TextPosition at;
  };
  std::vector<Key> keys;
};
/// Returns the places of the elements of a text that is a list and was parsed without fault.
std::vector<ElementPositions> elementPositions(std::string_view text);

}  // namespace sline::cli
