// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QWidget>

#include "render/export/formats/export_formats.h"
#include "widgets/form/field.h"

namespace sline::widgets {

/// How wide, at least, the column is that says what controls are: the same in all forms, so that
/// controls stand beneath each other.
inline constexpr int captionWidth = 92;

/// Controls for options of one part of the table, as `fieldOf` describes them. What is chosen is
/// written into the order at once.
class OptionForm : public QWidget {
  Q_OBJECT
 public:
  /// The order must outlive it.
  OptionForm(render::ExportOrder& order, std::vector<const render::ExportOption*> options,
             const QStringList& languages, QWidget* parent = nullptr);

  /// Shows the controls of those options that the kind has; returns false where it has none.
  bool showFor(const render::ExportFormat& kind);

 signals:
  void changed();

 private:
  QWidget* makeControlOf(const render::ExportOption& option, const Field& field);

  render::ExportOrder& m_order;
  std::vector<const render::ExportOption*> m_options;
  std::vector<std::vector<QWidget*>> m_widgets;  ///< of each option
};

}  // namespace sline::widgets
