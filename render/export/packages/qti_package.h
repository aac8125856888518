// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/disk/zip_archive.h"
#include "render/export/packages/package_options.h"
#include "render/export/packages/picture_questions.h"

namespace sline::render {

/// Returns the members of a content package of QTI 2.1: a manifest, a test with a section for each
/// view, an item for each question, and pictures. What is found by its place is a hotspot among
/// those of the view, else the choice of a number; names are typed or chosen.
std::vector<model::ZipMember> qtiPackage(const QuestionBook& book, const QuestionKinds& kinds);

}  // namespace sline::render
