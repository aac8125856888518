// SPDX-License-Identifier: Apache-2.0
// Describes the export that the user wants as one value, which the dialog edits and the settings
// keep.
#pragma once

#include <QString>

#include "render/export/formats/export_formats.h"
#include "render/export/order/view_orders.h"

class QSettings;

namespace sline::widgets {

/// The unit in which the size of the page is typed.
enum class PageUnit { millimetres, pixels };

struct ExportDraft {
  QString kind;    ///< ExportFormat::id
  QString target;  ///< of one file; files of several views have the view's name appended
  /// Which views are wanted, as it was chosen; the order's own is what that means for the kind.
  render::ViewSubject subject = render::ViewSubject::asKind;
  bool filled = false;  ///< the camera is moved so that what is shown fills the page
  PageUnit unit = PageUnit::millimetres;
  /// How the export looks; its scene, camera and view are taken from what is exported.
  render::ExportOrder order;
};

/// Returns the format of that kind; null where there is none.
const render::ExportFormat* formatOf(const QString& kind);

/// Tells whether the kind lets one choose between what is seen and all saved views.
bool hasViews(const QString& kind);
/// Tells whether one file of the kind can hold all saved views.
bool holdsViews(const QString& kind);
/// Returns the draft's order with the views that were chosen.
render::ExportOrder asChosen(const ExportDraft& draft);
/// Tells whether the draft is of all saved views, in one file or in several.
bool wantsViews(const ExportDraft& draft);
/// Tells whether the draft is a PDF with the paper's size instead of the page's.
bool isSheet(const ExportDraft& draft);
/// Tells whether the draft is one file of all saved views, of which that scene has some.
bool isLesson(const ExportDraft& draft, const model::Scene& scene);
/// Tells whether the page that the draft was given is not that of its files (`render::hasOwnPage`).
bool hasOwnPage(const ExportDraft& draft);
/// Tells whether pages of the kind have their labels where the preview has them.
bool pageIsAsPreviewed(const QString& kind);
render::PageUse pageUseOf(const QString& kind);
/// Tells whether the kind holds names of structures besides what is seen.
bool holdsNames(const QString& kind);

/// Returns what was chosen last; values never chosen, or no longer allowed, are those of a new
/// draft. What the window shows, too – `seen`: its ground, labels and marks – is as there; another
/// choice holds for as long as the window shows what it showed then.
ExportDraft rememberedDraft(const QSettings& settings, const render::ExportOrder& seen);
/// Keeps the draft that was made of such a window.
void remember(const ExportDraft& draft, const render::ExportOrder& seen, QSettings& settings);
/// Takes over what the window shows otherwise than before.
void follow(ExportDraft& draft, const render::ExportOrder& before, const render::ExportOrder& now);

/// Returns the target with the kind's ending in place of another kind's; a name without an ending
/// gets it.
QString withEndingOf(const QString& target, const QString& kind);

}  // namespace sline::widgets
