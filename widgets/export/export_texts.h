// SPDX-License-Identifier: Apache-2.0
// What the dialog says about an export.
#pragma once

#include <QStringList>

#include "widgets/export/export_files.h"

namespace sline::widgets {

/// Of the kind, in the interface's language.
QString titleOf(const render::ExportFormat& format);
QString helpOf(const render::ExportFormat& format);

/// "210 × 297 mm", "2480 × 3508 pixels".
QString millimetresText(const render::ExportPage& page);
QString pixelsText(const render::ExportPage& page);

/// What the files will contain, in sentences; plain text. The files are not empty.
QStringList exportSummary(const ExportDraft& draft, const std::vector<ExportFile>& files);

/// What a person should know before: nothing is shown. Empty where all is well.
QString exportDoubt(const std::vector<ExportFile>& files);

/// What a file of the order will lack, as far as that is known before: of the kind, and of the page
/// as it was previewed. A few lines; empty where all is well.
QString exportRemarks(const ExportDraft& draft, const render::ExportOrder& order,
                      const render::ExportNotes& page);

}  // namespace sline::widgets
