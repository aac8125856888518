// SPDX-License-Identifier: Apache-2.0
// The table of all that can be chosen about an export besides its page and target: a row is a field
// of the order and the control for it. Controls, settings and tests are made from it.
#pragma once

#include <QString>
#include <QStringList>
#include <QVariant>
#include <functional>
#include <variant>
#include <vector>

#include "render/export/order/export_order.h"

namespace sline::widgets {

/// A box to tick.
struct RowSwitch {};
/// One of several; the field's value is the row's.
struct RowChoice {
  struct Entry {
    QString id;  ///< in the settings
    QString text;
    QVariant value;
  };
  std::vector<Entry> entries;
};
struct RowNumber {
  double low = 0.0;
  double high = 100.0;
  int decimals = 0;
  double step = 1.0;
  QString unit;
};
/// A line of text, or several.
struct RowText {
  int longest = 200;
  int lines = 1;
};
using RowControl = std::variant<RowSwitch, RowChoice, RowNumber, RowText>;

enum class ExportPart { picture, labels, marks, kind, credit };

struct ExportRow {
  QString id;  ///< the control's objectName is "export-" and this
  ExportPart part = ExportPart::picture;
  QString text;
  QString tip;
  QStringList kinds;  ///< which have it; none named: all with a page
  RowControl control;
  std::function<QVariant(const render::ExportOrder&)> read;
  std::function<void(render::ExportOrder&, const QVariant&)> write;
  bool kept = true;  ///< from one session to the next

  bool isFor(const QString& kind) const;
  QVariant toSettings(const render::ExportOrder& order) const;
  /// What is not allowed changes nothing.
  void fromSettings(render::ExportOrder& order, const QVariant& value) const;
};

/// In the order in which they are shown. `languages`: BCP 47 tags that labels have texts in.
std::vector<ExportRow> exportRows(const QStringList& languages);

}  // namespace sline::widgets
