// SPDX-License-Identifier: Apache-2.0
// Declares the options of PDF documents: the figure alone, or a sheet of paper around it.
#pragma once

#include "render/export/order/export_option.h"

namespace sline::render {

/// Tells what a PDF shows. `none`: the figure alone, on a page of its size; all others a sheet of
/// paper around it. `figure`: with title and legend; `teaching`: also numbered labels, a page to
/// test oneself and its key; `patient`: large labels and a text of one's own.
enum class SheetKind { none, figure, teaching, patient };
enum class Paper { a4, letter };

struct SheetOptions {
  SheetKind kind = SheetKind::none;
  Paper paper = Paper::a4;
  bool landscape = false;
  std::string title;  ///< plain text, like `text`
  std::string text;   ///< used by `patient`; lines are paragraphs
  bool operator==(const SheetOptions&) const = default;
};

/// Tells whether the order is of a sheet of paper, and not of the figure alone.
bool hasSheet(const ExportOrder& order);

OptionList sheetOptions();
/// Returns those of them that mean something to sheets alone.
OptionList paperOptions();

/// Chooses the kind of sheet; the other options apply to sheets alone.
extern const ExportOption sheetOption;

}  // namespace sline::render
