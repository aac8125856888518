// SPDX-License-Identifier: Apache-2.0
#include "widgets/form/control.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalBlocker>
#include <QTextCursor>
#include <algorithm>

#include "widgets/form/longest_text.h"

namespace sline::widgets {

namespace {

using Take = std::function<void(const QVariant&)>;

QWidget* makeEditor(const Field& field, const SwitchField&, const Take& take) {
  auto* box = new QCheckBox(field.text);
  QObject::connect(box, &QCheckBox::toggled, box, [take](bool on) { take(on); });
  return box;
}

QWidget* makeEditor(const Field&, const ChoiceField& kind, const Take& take) {
  auto* box = new QComboBox;
  for (const Choice& choice : kind.choices)
    box->addItem(choice.text, choice.id);
  QObject::connect(box, &QComboBox::currentIndexChanged, box,
                   [box, take](int at) { take(box->itemData(at)); });
  return box;
}

QWidget* makeEditor(const Field&, const NumberField& kind, const Take& take) {
  auto* box = new QDoubleSpinBox;
  box->setRange(kind.low, kind.high);
  box->setDecimals(kind.decimals);
  box->setSingleStep(kind.step);
  if (!kind.unit.isEmpty())
    box->setSuffix(QLatin1Char(' ') + kind.unit);
  box->setSpecialValueText(kind.lowestText);
  box->setKeyboardTracking(false);
  QObject::connect(box, &QDoubleSpinBox::valueChanged, box,
                   [take](double number) { take(number); });
  return box;
}

/// Takes so many characters away again, the last ones of those that were just put in: what is not
/// taken is not shown either.
void removeBeforeCursor(QPlainTextEdit& box, int count) {
  QTextCursor excess = box.textCursor();
  const int end = std::max(excess.position(), count);
  excess.setPosition(end - count);
  excess.setPosition(end, QTextCursor::KeepAnchor);
  excess.removeSelectedText();
}

QWidget* makeEditor(const Field&, const TextField& kind, const Take& take) {
  if (kind.lines > 1) {
    auto* box = new QPlainTextEdit;
    box->setTabChangesFocus(true);
    box->setFixedHeight((kind.lines + 1) * box->fontMetrics().lineSpacing());
    QObject::connect(box, &QPlainTextEdit::textChanged, box, [box, take, longest = kind.longest] {
      if (const QString text = box->toPlainText(); text.size() > longest) {
        const QSignalBlocker quiet(box);
        removeBeforeCursor(*box, int(text.size()) - longest);
        LongestText::say(*box, longest);
      }
      take(box->toPlainText());
    });
    return box;
  }
  auto* line = new QLineEdit;
  line->setMaxLength(kind.longest);
  QObject::connect(line, &QLineEdit::textChanged, line,
                   [take](const QString& text) { take(text); });
  return line;
}

void show(QWidget& control, const SwitchField&, const QVariant& value) {
  static_cast<QCheckBox&>(control).setChecked(value.toBool());
}

void show(QWidget& control, const ChoiceField&, const QVariant& value) {
  auto& box = static_cast<QComboBox&>(control);
  box.setCurrentIndex(box.findData(value.toString()));
}

void show(QWidget& control, const NumberField&, const QVariant& value) {
  static_cast<QDoubleSpinBox&>(control).setValue(value.toDouble());
}

void show(QWidget& control, const TextField& kind, const QVariant& value) {
  if (kind.lines > 1)
    static_cast<QPlainTextEdit&>(control).setPlainText(value.toString());
  else
    static_cast<QLineEdit&>(control).setText(value.toString());
}

}  // namespace

QWidget* makeControl(const Field& field, const std::function<void(const QVariant&)>& take,
                     QWidget* parent) {
  QWidget* control =
      std::visit([&](const auto& kind) { return makeEditor(field, kind, take); }, field.kind);
  control->setParent(parent);
  control->setObjectName(field.id);
  control->setToolTip(field.tip);
  control->setAccessibleDescription(field.tip);
  return control;
}

void showValue(QWidget& control, const FieldKind& kind, const QVariant& value) {
  const QSignalBlocker quiet(control);
  std::visit([&](const auto& each) { show(control, each, value); }, kind);
}

}  // namespace sline::widgets
