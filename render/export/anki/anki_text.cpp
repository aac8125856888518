// SPDX-License-Identifier: Apache-2.0
#include "render/export/anki/anki_text.h"

#include <algorithm>

namespace sline::render {

std::string ankiText(const AnkiDeck& deck) {
  // A header is a single line, not HTML.
  std::string name = deck.name;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
  std::string text =
      "#separator:tab\n#html:true\n#columns:Id\tFront\tBack\tTags\n#guid column:1\n"
      "#tags column:4\n#deck:" +
      name + "\n";
  std::string tags;
  for (const std::string& tag : deck.tags)
    tags += (tags.empty() ? "" : " ") + tag;
  for (const AnkiNote& note : deck.notes)
    text += note.id + '\t' + htmlPicture(note.question, note.questionShows) + '\t' +
            htmlPicture(note.answer, note.answerShows) + "<br>" + htmlText(note.label) + '\t' +
            tags + '\n';
  return text;
}

}  // namespace sline::render
