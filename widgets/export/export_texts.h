// SPDX-License-Identifier: Apache-2.0
// Puts what the dialog says about an export into words.
#pragma once

#include <QStringList>
#include <optional>

#include "widgets/export/export_files.h"

namespace sline::widgets {

/// Returns the title of the kind in the interface's language.
QString titleOf(const render::ExportFormat& format);
QString helpOf(const render::ExportFormat& format);

/// Returns a size such as "210 × 297 mm" or "2480 × 3508 pixels".
QString millimetresText(const render::ExportPage& page);
QString pixelsText(const render::ExportPage& page);

/// Returns plain sentences about what the files will contain; `pages` are what is previewed of
/// them. Neither is empty. `bytes`: of
/// one of them; 0 where they cannot be known, nothing while they are measured.
QStringList exportSummary(const ExportDraft& draft, const std::vector<render::ExportPiece>& files,
                          const std::vector<render::ExportPiece>& pages,
                          std::optional<double> bytes);

/// Returns what the user should know beforehand, namely that nothing is shown; empty where all is
/// well.
QString exportDoubt(const std::vector<render::ExportPiece>& pages);

/// Returns a few lines on what a file of the order will lack, as far as that is known beforehand
/// from the kind and from the previewed page; empty where all is well.
QString exportRemarks(const ExportDraft& draft, const render::ExportOrder& order,
                      const render::ExportNotes& page);

}  // namespace sline::widgets
