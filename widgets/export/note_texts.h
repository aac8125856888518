// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

#include "render/export/order/export_notes.h"

namespace sline::widgets {

/// Returns plain text in the interface's language that says what the note means and what to do
/// about it.
QString noteText(const render::ExportNote& note);
QStringList noteTexts(const render::ExportNotes& notes);

}  // namespace sline::widgets
