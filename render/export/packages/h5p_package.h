// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/disk/zip_archive.h"
#include "render/export/packages/package_options.h"
#include "render/export/packages/picture_questions.h"

namespace sline::render {

/// Returns the members of an .h5p file: content alone, for places that have the content types. What
/// is found by its place is an Image Hotspot Question (1.8), the rest one Question Set (1.20) of
/// Multiple Choice (1.16) and Fill in the Blanks (1.14), both in a Column (1.16) where there are
/// both.
std::vector<model::ZipMember> h5pPackage(const QuestionBook& book, const QuestionKinds& kinds);

/// Returns the texts of which the package holds only a part, as the format limits their fields.
std::vector<std::string> shortenedInH5p(const QuestionBook& book);

}  // namespace sline::render
