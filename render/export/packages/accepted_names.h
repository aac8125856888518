// SPDX-License-Identifier: Apache-2.0
// Finds under which names an answer that is typed is right.
#pragma once

#include <string>
#include <vector>

#include "model/scene/question.h"

namespace sline::render {

/// Returns the names of what the question asks for, each once, whatever its letters' case: what its
/// labels say in all languages, and what anatomy calls that in any. Each is given without accents,
/// too, as keyboards may lack them.
std::vector<std::string> acceptedNames(const model::Scene& scene, const model::Question& question);

/// Returns the text without accents and ligatures: "Musculus obliquus", "a" for "ä".
std::string withoutAccents(const std::string& text);

/// Returns the text in the form in which two names are compared: lower case, without accents,
/// letters and digits alone.
std::string comparedName(const std::string& text);

/// Takes from each list of names those that are in another one, too: they do not tell which is
/// meant. The first name of each stays.
void dropAmbiguous(std::vector<std::vector<std::string>*> lists);

}  // namespace sline::render
