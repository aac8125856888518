// SPDX-License-Identifier: Apache-2.0
#include "render/export/comparison/comparison_file.h"

#include "render/export/page/drawn_page.h"

namespace sline::render {

Status checkSheetName(const std::filesystem::path& target) {
  return checkPageName(target, "a comparison sheet");
}

Status writeSheet(const ComparisonSheet& sheet, const std::filesystem::path& target, float dpi) {
  TRY(checkSheetName(target));
  DrawnPage page{.sizeMm = sheet.sizeMm};
  for (const SheetCell& cell : sheet.cells)
    page.drawings.push_back(
        {.id = cell.id, .name = cell.name, .drawing = cell.drawing, .at = cell.at});
  page.writings.push_back(
      {.id = "text", .name = "Text", .lettering = sheet.lettering, .halos = false});
  return writePage(page, target, {.dpi = dpi});
}

}  // namespace sline::render
