// SPDX-License-Identifier: Apache-2.0
// Writes the names under which an answer is right as systems need them that compare letter by
// letter.
#pragma once

#include <string>
#include <vector>

namespace sline::render {

/// Returns the names, each once, whatever its letters' case, the first as it is. Each is given
/// without accents, too, and as German is written without its letters, as keyboards may lack them;
/// and abbreviations without their full stops.
std::vector<std::string> typedNames(const std::string& first,
                                    const std::vector<std::string>& others);

/// Returns the text without accents and ligatures: "a" for "ä", "ae" for "æ".
std::string withoutAccents(const std::string& text);

}  // namespace sline::render
