// SPDX-License-Identifier: Apache-2.0
// Makes the students' page: one HTML file with the renderer, the scene, its texts and a quiz.
#pragma once

#include <map>
#include <string>

#include "render/export/students/students_options.h"

namespace sline::render {

struct StudentsPage {
  std::string html;
  /// The files beside index.html, by name; none where all is in one file.
  std::map<std::string, std::string> files;
  std::string title;     ///< what the page is called
  std::string language;  ///< in which it opens, as a BCP 47 tag
};

/// Makes the page of the order's scene. It opens as the order shows the scene, and its tour has the
/// saved views, or that one picture where there are none. The error says what to install where the
/// page's program is absent.
Result<StudentsPage> studentsPage(const ExportOrder& order, const StudentsOptions& own,
                                  const ExportProgress& progress);

}  // namespace sline::render
