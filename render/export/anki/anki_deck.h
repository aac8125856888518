// SPDX-License-Identifier: Apache-2.0
// Holds a deck of cards for Anki before it is written in one form or another.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/disk/zip_archive.h"

namespace sline::render {

struct AnkiNote {
  std::string id;  ///< the same for the same label of the same deck, so that the card is replaced
  std::string question;       ///< name of a picture
  std::string answer;         ///< name of a picture
  std::string label;          ///< plain text
  std::string questionShows;  ///< what the pictures show, plain text; names nothing
  std::string answerShows;
};

struct AnkiDeck {
  std::string name;
  std::string description;        ///< plain text; only packages have a place for it
  std::vector<std::string> tags;  ///< without spaces
  std::vector<AnkiNote> notes;
  /// Pictures, each once. Their names are derived from their contents and are ASCII, as all decks
  /// of a user share one folder.
  std::vector<model::ZipMember> media;
};

/// Returns the text as HTML shows it, on one line; bytes that are not UTF-8 become U+FFFD.
std::string htmlText(std::string_view text);
/// Makes a tag of a name: spaces and characters to which Anki gives a meaning become "_".
std::string ankiTag(std::string_view name);
/// Returns the HTML that shows a picture, and in words what it shows.
std::string htmlPicture(const std::string& name, const std::string& shows);
/// Returns the FNV-1a hash, 64 bits.
std::uint64_t fingerprintOf(std::string_view bytes);
/// Returns 16 hexadecimal digits.
std::string hexOf(std::uint64_t value);

}  // namespace sline::render
