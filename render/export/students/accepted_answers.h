// SPDX-License-Identifier: Apache-2.0
// Says what is right when it is typed. Pages and packages take their lists from here alone, so that
// the same answer is right wherever it is given.
#pragma once

#include <string>
#include <vector>

#include "render/export/students/page_words.h"

namespace sline::render {

struct AcceptedAnswers {
  /// The names, everything that what they name is called in any language, and all of these with
  /// their kind abbreviated: "A. iliaca communis sinistra", "left common iliac a.".
  std::vector<std::string> names;
  /// The same without the word that says the kind ("left common iliac"), where that is no other
  /// structure's name. In a scene it may be: ask `ownAnswers`.
  std::vector<std::string> brief;
};

/// Returns what is right for what is called so. A side is never left out: where a name has one
/// there are two. A name that abbreviates its kind is right in full, too.
AcceptedAnswers acceptedAnswers(const WordsByLanguage& words);

/// Returns the answers that are right for what is called so beside `others`: without those that
/// leave the kind out and are right for another of them, too. Sides and other adjectives may be
/// abbreviated (short_answers.h).
std::vector<std::string> ownAnswers(const WordsByLanguage& words,
                                    const std::vector<AcceptedAnswers>& others);

}  // namespace sline::render
