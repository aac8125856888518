// SPDX-License-Identifier: Apache-2.0
// A deck of cards for Anki, before it is written in one form or another.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/disk/zip_archive.h"

namespace sline::render {

struct AnkiNote {
  std::string id;        ///< the same for the same label of the same deck, so that it is replaced
  std::string question;  ///< name of a picture
  std::string answer;    ///< likewise
  std::string label;     ///< plain text
};

struct AnkiDeck {
  std::string name;
  std::string description;        ///< plain text; packages alone have a place for it
  std::vector<std::string> tags;  ///< without spaces
  std::vector<AnkiNote> notes;
  /// Pictures, each once. Their names stand for what they show and are ASCII, as all decks of a
  /// person share one folder.
  std::vector<model::ZipMember> media;
};

/// The text as HTML shows it, on one line; bytes that are no UTF-8 become U+FFFD.
std::string htmlText(std::string_view text);
/// A tag of a name: spaces and what Anki gives a meaning become "_".
std::string ankiTag(std::string_view name);
/// FNV-1a, 64 bits.
std::uint64_t fingerprintOf(std::string_view bytes);
/// 16 hexadecimal digits.
std::string hexOf(std::uint64_t value);

}  // namespace sline::render
