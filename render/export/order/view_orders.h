// SPDX-License-Identifier: Apache-2.0
// Makes the orders of all saved views of one order, whatever is made of them: pages, slides, cards
// or a set of pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/scene/known_frame.h"
#include "render/export/order/export_option.h"

namespace sline::render {

/// Tells which views are exported. `asKind`: all of them where the kind of file is made for that,
/// as slides are, and else what is shown.
enum class ViewSubject { asKind, all, shown };

struct ViewsOptions {
  ViewSubject subject = ViewSubject::asKind;
};

extern const ExportOption viewsOption;

/// Tells whether the order wants all saved views, of a kind that shows one unless asked for more.
bool wantsAllViews(const ExportOrder& order);

/// Returns the order as it is for that view of its scene: with the view's look, camera, name and
/// words. Its page is the order's.
ExportOrder orderOfView(const ExportOrder& order, const model::View& view);
/// Returns the same with the camera fitted to the order's page (`fittedToPage`), as everything
/// shows it that is a picture of a view.
ExportOrder pictureOfView(const ExportOrder& order, const model::View& view);

/// Returns the title of a view in the language: its own, else its name, in words for a side of the
/// body where what is drawn has sides (model::hasSides).
std::string titleOfView(const model::View& view, const std::string& language,
                        const model::KnownSides& sides);

/// Returns the camera moved back, or opened, so that its picture shows so many times as much; it
/// opens no wider than 150°.
model::Camera widened(model::Camera camera, float times);
/// Returns the camera moved back, or opened, as far as a page of that shape (width / height) needs
/// to show all structures that a wide page shows: views are saved in wide windows, and know only
/// their height.
model::Camera fittedToPage(const model::Scene& scene, model::Camera camera, float aspect);

/// Returns the text as a file name that every system accepts, in any script: folder separators,
/// control and direction marks become blanks or dashes, and no length limit is exceeded. Returns
/// "picture" where nothing is left.
std::string safeFileName(const std::string& text);

/// Returns the name of each view's file, numbered in their order: "pelvis - 1 Front.svg" for the
/// target "pelvis.svg", or "1 Front.svg" within a folder that is there already. No two are the
/// same, whatever the views are called.
std::vector<std::filesystem::path> viewTargets(const std::filesystem::path& target,
                                               const std::vector<model::View>& views,
                                               const std::string& extension);

}  // namespace sline::render
