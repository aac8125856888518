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
    const std::string end = '\t' + tags + '\t' + lineOf(deck.nameOf(part)) + '\n';
    const std::string answer = htmlOf(note.named);
    const std::string label = "<br>" + htmlText(note.label);
    if (!note.marked.empty())
      text += note.id + '\t' + htmlOf(note.marked) + '\t' + answer + label + end;
    if (!note.numbered.empty())
      text += note.id + "-n\t" + htmlOf(note.numbered) + '\t' + htmlText(note.numbers) + answer +
              label + end;
    if (!note.covered.empty())
      text += note.id + "-c\t" + htmlOf(note.covered) + '\t' + answer + label + end;
  }
  return text;
}

}  // namespace sline::render
