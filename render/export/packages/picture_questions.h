// SPDX-License-Identifier: Apache-2.0
// Makes questions with pictures of a scene's labels, for whatever system asks them.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "render/export/order/export_order.h"
#include "render/export/packages/question_zone.h"

namespace sline::render {

/// A picture as a PNG file; its name comes from its bytes and is ASCII.
struct QuestionPicture {
  std::string name;
  std::string png;
  glm::ivec2 size{0};  ///< pixels
};

/// Holds what can be asked about one name in one view.
struct SheetThing {
  std::string id;                     ///< ASCII, the same for the same label of the same view
  std::string words;                  ///< its name in the order's language, plain text
  std::vector<std::string> accepted;  ///< names that are right when typed, the first as above
  QuestionPicture marked;             ///< the view with a mark at it; names nothing
  std::vector<int> numbers;           ///< those it has in the numbered picture
  QuestionZone zone;
  std::vector<std::string> wrong;   ///< up to three names of others, to choose from
  std::vector<std::size_t> others;  ///< up to three others of the sheet, those nearest to it
};

/// Holds the questions of one view.
struct QuestionSheet {
  std::string title;         ///< plain text
  QuestionPicture ground;    ///< without labels
  QuestionPicture small;     ///< the same, of at most 600 × 400 pixels
  QuestionPicture numbered;  ///< with numbers in place of labels
  std::string shows;         ///< what they show, in words that name no structure
  std::vector<SheetThing> things;
};

struct QuestionBook {
  std::string title;     ///< plain text
  std::string language;  ///< BCP 47
  ExportCredit credit;
  double passing = 50.0;  ///< percent of right answers from which on it is passed
  std::vector<QuestionSheet> sheets;
};

/// Draws the pictures of the order's view, or of all where it wants them, and makes the questions
/// (`questionsOf`). The error reports that there is nothing to ask for; progress may stop it
/// (`givenUp`).
Result<QuestionBook> pictureQuestions(const ExportOrder& order, const ExportProgress& progress);

/// Returns how many questions there are if all labels find a place.
std::size_t questionsAtMost(const ExportOrder& order);

/// Tells whether something is asked by its place: it is large enough to be hit there.
inline bool isFoundByPlace(const SheetThing& thing) {
  return thing.zone.canBeHit();
}
/// Tells whether there are names to choose from, or numbers.
inline bool hasChoice(const SheetThing& thing) {
  return !thing.wrong.empty();
}
inline bool hasNumberChoice(const SheetThing& thing) {
  return !thing.others.empty() && !thing.numbers.empty();
}

/// Returns the numbers as a choice shows them: "3, 5".
std::string numberText(const SheetThing& thing);

}  // namespace sline::render
