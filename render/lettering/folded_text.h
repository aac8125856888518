// SPDX-License-Identifier: Apache-2.0
// Divides plain texts into lines of a width without losing any of it.
#pragma once

#include <QString>
#include <vector>

namespace sline::render {

/// Returns the words in lines of that width, millimetres, set in letters of that size; a word that
/// is wider by itself goes on in the next line. White space becomes single blanks. An empty text is
/// one empty line.
std::vector<QString> foldedText(const QString& text, float points, float widthMm);

}  // namespace sline::render
