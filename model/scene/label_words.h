// SPDX-License-Identifier: Apache-2.0
// Reads what labels say in one language or in several at once: languages are named by BCP 47 tags,
// several with a plus between them ("de+la").
#pragma once

#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace sline::model {

/// Returns the tags one by one; one empty tag for the scene's own language.
std::vector<std::string> languagesIn(const std::string& tags);
/// Returns the first of the tags, in which numbers, dates and headings are written.
std::string firstLanguage(const std::string& tags);

/// Returns the text in the first language (see textIn) and what it is called in the others where it
/// has words in them: "Harnblase / Vesica urinaria", those of a callout one below the other. What
/// is the same in several stands once.
std::string writtenIn(const Annotation& annotation, const std::string& tags);
/// Returns it as pictures show it: what names a structure by a name that is in doubt carries a mark
/// (known_frame.h).
std::string writtenIn(const Scene& scene, const Annotation& annotation, const std::string& tags);

}  // namespace sline::model
