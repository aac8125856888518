// SPDX-License-Identifier: Apache-2.0
// Edits a number that may stand for several: "1.00 – 3.00" until the user types one for all of
// them.
#pragma once

#include <QDoubleSpinBox>
#include <optional>

namespace sline::widgets {

class RangeBox : public QDoubleSpinBox {
  Q_OBJECT
 public:
  explicit RangeBox(QWidget* parent = nullptr);

  /// Shows the range without emitting a signal.
  void showRange(double low, double high);
  bool isMixed() const { return m_mixed; }

  QString textFromValue(double value) const override;
  QValidator::State validate(QString& text, int& position) const override;
  void stepBy(int steps) override;

 signals:
  /// Tells that the user chose a value, even if it is the box's current number, because with
  /// several values it was only one of them.
  void chosen(double value);
  /// Tells by how much several values are to move, which stay several.
  void moved(double by);

 private:
  void finish();

  bool m_mixed = false;
  bool m_typed = false;
  double m_low = 0.0;
  double m_high = 0.0;
};

}  // namespace sline::widgets
