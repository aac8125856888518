// SPDX-License-Identifier: Apache-2.0
// Holds a deck of cards for Anki before it is written in one form or another.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/disk/zip_archive.h"

namespace sline::render {

/// Names the pictures that lie one upon the other on a side of a card. They are of one shape.
struct AnkiFace {
  std::string words;  ///< plain text above the pictures
  std::string ground;
  std::string over;   ///< what is written over the ground, and clear elsewhere
  std::string shows;  ///< what the pictures show, plain text, for who does not see them

  bool empty() const { return ground.empty(); }
};

/// Holds what is asked of one label: a card for each question that has a face.
struct AnkiNote {
  std::string id;     ///< the same for the same label of the same deck, so that its cards are kept
  std::string label;  ///< plain text
  std::size_t part = 0;  ///< in `AnkiDeck::parts`
  AnkiFace named;        ///< the label's place with its name, which answers
  AnkiFace marked;       ///< what is this? The place is marked
  AnkiFace numbered;     ///< which number is it? Numbers stand in place of names
  std::string numbers;   ///< of the label: "3", or "3, 5" for things of one name
  AnkiFace covered;      ///< which name is covered? The others are shown
};

/// Holds a deck of its own within the deck, or the deck itself.
struct AnkiPart {
  std::string title;              ///< plain text
  std::vector<std::string> tags;  ///< without spaces
};

struct AnkiDeck {
  std::string name;
  std::string description;  ///< plain text; only packages have a place for it
  /// The decks that hold the notes; a single one without a title is the deck itself.
  std::vector<AnkiPart> parts;
  std::vector<AnkiNote> notes;
  /// Pictures, each once. Their names are derived from their contents and are ASCII, as all decks
  /// of a user share one folder.
  std::vector<model::ZipMember> media;

  /// Returns the full name of the part's deck: "Pelvis::From in front".
  std::string nameOf(const AnkiPart& part) const;
};

/// Returns the text as HTML shows it, on one line; bytes that are not UTF-8 become U+FFFD, and what
/// Anki would take for a field or a sound stays text.
std::string htmlText(std::string_view text);
/// Returns the face in HTML, no wider and higher than the screen; empty for an empty face.
std::string htmlOf(const AnkiFace& face);
/// Makes a tag of a name: spaces and characters to which Anki gives a meaning become "_".
std::string ankiTag(std::string_view name);
/// Returns the FNV-1a hash, 64 bits.
std::uint64_t fingerprintOf(std::string_view bytes);
/// Returns 16 hexadecimal digits.
std::string hexOf(std::uint64_t value);

}  // namespace sline::render
