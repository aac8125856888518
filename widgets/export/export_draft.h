// SPDX-License-Identifier: Apache-2.0
// What a person wants exported, before it is: one value that the dialog edits and settings keep.
#pragma once

#include <QString>

#include "render/export/formats/export_formats.h"

class QSettings;

namespace sline::widgets {

enum class ExportSubject { seen, savedViews };
/// In which unit the size of the page is typed.
enum class PageUnit { millimetres, pixels };

struct ExportDraft {
  QString kind;    ///< ExportFormat::id
  QString target;  ///< of one file; those of several views have the view's name behind theirs
  ExportSubject subject = ExportSubject::seen;
  bool filled = false;  ///< the camera is moved so that what is shown fills the page
  PageUnit unit = PageUnit::millimetres;
  /// How; its scene, camera and view are whatever is exported.
  render::ExportOrder order;
};

/// Null where there is no such kind.
const render::ExportFormat* formatOf(const QString& kind);

/// A kind that shows the scene from one place; others hold it whole, or all its views.
bool showsOneView(const QString& kind);
/// A kind whose pages have their labels where the preview has them.
bool pageIsAsPreviewed(const QString& kind);
render::PageUse pageUseOf(const QString& kind);
/// A kind that holds names of structures besides what is seen.
bool holdsNames(const QString& kind);

/// What was chosen last; what was never chosen, or is not allowed any more, is as in a new draft.
ExportDraft rememberedDraft(const QSettings& settings);
void remember(const ExportDraft& draft, QSettings& settings);

/// With the kind's ending in place of another kind's; a name without one gets it.
QString withEndingOf(const QString& target, const QString& kind);

}  // namespace sline::widgets
