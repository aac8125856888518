// SPDX-License-Identifier: Apache-2.0
#include "render/export/anki/anki_text.h"

#include <algorithm>

namespace sline::render {

namespace {

/// Returns the name on one line, as a column holds it.
std::string lineOf(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
  return name;
}

}  // namespace

std::string ankiText(const AnkiDeck& deck) {
  std::string text =
      "#separator:tab\n#html:true\n#columns:Id\tFront\tBack\tTags\tDeck\n#guid column:1\n"
      "#tags column:4\n#deck column:5\n";
  for (const AnkiNote& note : deck.notes) {
    const AnkiPart& part = deck.parts[note.part];
    std::string tags;
    for (const std::string& tag : part.tags)
      tags += (tags.empty() ? "" : " ") + tag;
    const auto addCard = [&](const char* kind, const AnkiFace& front, const std::string& before) {
      for (const std::string& column : {note.id + kind, htmlOf(front),
                                        std::string(before)
                                            .append(htmlOf(note.named))
                                            .append("<br>")
                                            .append(htmlText(note.label)),
                                        tags})
        text.append(column).append("\t");
      text.append(lineOf(deck.nameOf(part))).append("\n");
    };
    if (!note.marked.empty())
      addCard("", note.marked, {});
    if (!note.numbered.empty())
      addCard("-n", note.numbered, htmlText(note.numbers));
    if (!note.covered.empty())
      addCard("-c", note.covered, {});
  }
  return text;
}

}  // namespace sline::render
