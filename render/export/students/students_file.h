// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/export/order/export_order.h"

namespace sline::render {

/// Writes the students' page as one HTML file.
Status writeStudentsPage(const ExportOrder& order, const std::filesystem::path& target,
                         const ExportProgress& progress);
/// Writes it as a new folder: index.html and the files beside it, of which page.js, page.css and
/// engine.wasm are the same for every scene.
Status writeStudentsFolder(const ExportOrder& order, const std::filesystem::path& target,
                           const ExportProgress& progress);

/// Notes a scene that is too large for telephones, and a quiz without questions.
ExportNotes studentsNotes(const ExportOrder& order);

}  // namespace sline::render
