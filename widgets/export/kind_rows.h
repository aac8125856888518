// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "widgets/export/export_rows.h"

namespace sline::widgets {

/// What single kinds of files have of their own.
std::vector<ExportRow> kindRows();

/// Who made it: of all kinds, and empty until it is typed.
std::vector<ExportRow> creditRows();

}  // namespace sline::widgets
