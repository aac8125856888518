// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QStringList>

#include "render/export/order/export_notes.h"

namespace sline::widgets {

/// What it is and what to do about it, in the interface's language; plain text.
QString noteText(const render::ExportNote& note);
QStringList noteTexts(const render::ExportNotes& notes);

}  // namespace sline::widgets
