// SPDX-License-Identifier: Apache-2.0
// Makes of what someone wants exported the orders of the files to write, in one way for every
// caller: the command line and the window say what is wanted and nothing else.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "render/export/formats/export_formats.h"
#include "render/export/order/view_orders.h"

namespace sline::render {

/// Returns the camera that shows on the order's page what the caller shows, or why there is none.
/// It is asked once the page of the kind of file is known.
using Framing = std::function<Result<model::Camera>(const ExportOrder& order)>;

/// Says what is wanted, of whatever kind of file.
struct ExportWish {
  /// What is shown, and all options. Its page is the one that was asked for, and `ViewsOptions` say
  /// which views are wanted. With `pureInk` its scene is in colour still.
  ExportOrder order;
  Framing framing;      ///< of what is shown; none: the order's camera holds for every page
  bool filled = false;  ///< cameras, those of saved views too, move so that the page is filled
  std::filesystem::path target;  ///< of several files the one that their names are made of
};

/// Is one file to write.
struct ExportPiece {
  ExportOrder order;
  bool filled = false;  ///< `readyOrder` moves its camera
  std::filesystem::path target;
};

/// Tells whether the subject means all saved views, if there are any, of files of that kind.
bool meansAllViews(ViewSubject subject, const ExportFormat& format);
/// Tells whether the order is one file of all saved views, and there are some.
bool isLesson(const ExportOrder& order, const ExportFormat& format);
/// Tells whether a file of the order has the size of a sheet of paper and not that of its page.
bool isOnPaper(const ExportOrder& order, const ExportFormat& format);
/// Tells whether the page that was asked for is not that of such files: sheets have their paper's,
/// films that of their pictures, slides their own.
bool hasOwnPage(const ExportOrder& order, const ExportFormat& format);

/// Returns the files of one kind: one or, of a kind that shows one view of several that are
/// wanted, a numbered one for each (`viewTargets`). Each order has what files of its kind have: the
/// page, ink alone where it is to be so, and a camera that shows on that page what is wanted.
/// Options of other kinds stay, as writers tell of what they cannot do. Fails where the framing
/// does.
Result<std::vector<ExportPiece>> assembled(const ExportWish& wish, const ExportFormat& format);

/// Returns the order of a picture of what is shown, whatever kinds of files are made of it: on the
/// page that was asked for, with all options.
Result<ExportOrder> assembledPicture(const ExportWish& wish);

/// Returns what can be looked at of a piece: the order itself or, where it holds all views, each
/// view as it is in there.
std::vector<ExportOrder> pagesOf(const ExportOrder& order, const ExportFormat& format);

/// Returns the piece's order, its camera moved where the page is to be filled. It looks at each
/// vertex, so it should not run where someone waits.
ExportOrder readyOrder(const ExportPiece& piece);

}  // namespace sline::render
