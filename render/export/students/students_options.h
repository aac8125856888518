// SPDX-License-Identifier: Apache-2.0
// Declares the options of the students' page.
#pragma once

#include <string>

#include "render/export/order/export_option.h"

namespace sline::render {

/// Tells what of a quiz the page has. `beside`: a quiz beside names and labels; `only`: nothing but
/// the quiz, and no name of a structure is in the file in clear; `off`: none.
enum class QuizMode { beside, only, off };

struct StudentsOptions {
  QuizMode quiz = QuizMode::beside;
  // Which kinds of questions there are.
  bool find = true;         ///< name something, which is clicked
  bool name = true;         ///< light something up, whose name is typed
  bool choose = true;       ///< likewise, where the name is one of four
  bool order = true;        ///< ask for the order of vessels along their path
  bool drag = true;         ///< ask to drag labels to what they name
  bool counts = true;       ///< answers count towards a score
  bool lockCamera = false;  ///< the camera stays while a question is asked
  bool lockLook = false;    ///< Γ and visibility stay while a question is asked
  std::string title;        ///< empty: the name of the group that holds all, else `fileTitle`
  std::string languages;    ///< tags with commas; empty: all in which there are names or texts
  int triangles = 0;        ///< at most so many; 0: as many as there are
  double errorMm = 0.0;     ///< surfaces may be off by so much; 0: not at all
  // Not chosen by a person, but by whoever makes files of the page.
  bool folder = false;       ///< several files beside each other instead of one
  bool foundLabels = false;  ///< its labels are not its author's (found_labels.h)
  std::string fileTitle;     ///< what the file is called; a page without any name is "Anatomy"
  std::string report;        ///< "scorm12", "scorm2004" or "cmi5": whom the page tells its answers
};

OptionList studentsOptions();

extern const ExportOption quizFindOption;
extern const ExportOption quizNameOption;
extern const ExportOption quizChooseOption;

}  // namespace sline::render
