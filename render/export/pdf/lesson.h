// SPDX-License-Identifier: Apache-2.0
// Makes one document of all views: contents, a sheet for each view, tests with their keys, and an
// index of what is labelled.
#pragma once

#include <QByteArray>
#include <filesystem>

#include "render/export/order/export_order.h"

namespace sline::render {

/// Returns the order of a view's sheet in a lesson: its title is the sheet's, the camera shows on
/// the sheet's figure all that it shows on a wide page, and the figure alone is that with what the
/// view says.
ExportOrder lessonSheet(const ExportOrder& order, const model::View& view);

/// Returns about how many pages the lesson of the order has: as many as if all labels found a
/// place.
std::size_t lessonPages(const ExportOrder& order);

/// Returns the whole PDF file with links and bookmarks. The order has views. `progress` may stop
/// it; the error is then `givenUp`'s for `target`.
Result<QByteArray> lessonDocument(const ExportOrder& order, const std::filesystem::path& target,
                                  const ExportProgress& progress);

}  // namespace sline::render
