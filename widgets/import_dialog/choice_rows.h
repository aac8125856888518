// SPDX-License-Identifier: Apache-2.0
// What can be chosen of frame, unit, smoothing and decimation, as tables: the combo boxes, the
// list's cells and the texts are made from them.
#pragma once

#include <QComboBox>
#include <QString>
#include <optional>
#include <vector>

#include "model/import/plan.h"

namespace sline::widgets {

template <class T>
struct ChoiceRow {
  const char* id;  ///< what tests and settings call it
  QString text;
  T value;
};

std::vector<ChoiceRow<model::Frame>> frameRows();
/// Millimetres per unit.
std::vector<ChoiceRow<float>> unitRows();
std::vector<ChoiceRow<model::Smoothing>> smoothingRows();
/// How far a surface may move, in millimetres; 0: all triangles are kept.
std::vector<ChoiceRow<float>> decimationRows();

/// "cm", or "× 12.7" for a length without a name.
QString unitText(float millimetres);
QString smoothingText(const model::Smoothing& smoothing);
QString decimationText(float millimetres);

/// Fills the box; its first entry means that nothing is chosen.
template <class T>
void addChoices(QComboBox& box, const QString& none, const std::vector<ChoiceRow<T>>& rows) {
  if (!none.isEmpty())
    box.addItem(none, QString());
  for (const ChoiceRow<T>& row : rows)
    box.addItem(row.text, QString::fromLatin1(row.id));
}

/// What the entry at the index means; nothing for the first where it means that.
template <class T>
std::optional<T> valueAt(const QComboBox& box, int index, const std::vector<ChoiceRow<T>>& rows) {
  for (const ChoiceRow<T>& row : rows)
    if (box.itemData(index).toString() == QLatin1String(row.id))
      return row.value;
  return std::nullopt;
}

/// Shows the value without telling anybody; no entry where it is in no row.
template <class T>
void showValue(QComboBox& box, const std::optional<T>& value,
               const std::vector<ChoiceRow<T>>& rows) {
  int index = value ? -1 : box.findData(QString());
  for (const ChoiceRow<T>& row : rows)
    if (value && *value == row.value)
      index = box.findData(QString::fromLatin1(row.id));
  const QSignalBlocker quiet(box);
  box.setCurrentIndex(index);
}

}  // namespace sline::widgets
