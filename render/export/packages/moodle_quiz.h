// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/export/packages/package_options.h"
#include "render/export/packages/picture_questions.h"

namespace sline::render {

/// Returns the questions as Moodle imports them ("Moodle XML format" in its manual), with their
/// pictures: a category for each view; markers to be dragged onto what is found by its place, else
/// the choice of a number; short answers; choices. Texts are texts there, whatever they hold.
std::string moodleQuiz(const QuestionBook& book, const QuestionKinds& kinds);

}  // namespace sline::render
