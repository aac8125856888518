// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "render/export/formats/export_formats.h"
#include "widgets/form/field.h"

namespace sline::widgets {

/// The minimum width of the column that names controls: equal in all forms, so that controls stand
/// beneath each other.
inline constexpr int captionWidth = 92;

/// Shows controls for the options of one part of the table, as `fieldOf` describes them, and writes
/// each choice into the order at once.
class OptionForm : public QWidget {
  Q_OBJECT
 public:
  /// Makes the controls; the order must outlive the form.
  OptionForm(render::ExportOrder& order, std::vector<const render::ExportOption*> options,
             const QStringList& languages, QWidget* parent = nullptr);

  /// Shows the controls of those options that the kind has; returns false where it has none.
  bool showFor(const render::ExportFormat& kind);
  /// Enables the controls of those options that mean anything beside what else is chosen.
  void enableWhatApplies();

 signals:
  void changed();

 private:
  QWidget* makeControlOf(const render::ExportOption& option, const Field& field);

  render::ExportOrder& m_order;
  std::vector<const render::ExportOption*> m_options;
  std::vector<std::vector<QWidget*>> m_widgets;  ///< the widgets of each option
};

}  // namespace sline::widgets
