// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/row_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <algorithm>

namespace sline::widgets {

RowForm::RowForm(render::ExportOrder& order, std::vector<ExportRow> rows, QWidget* parent)
    : QWidget(parent), m_order(order), m_rows(std::move(rows)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(8);
  const bool ticksAlone = std::all_of(m_rows.begin(), m_rows.end(), [](const ExportRow& row) {
    return std::holds_alternative<RowSwitch>(row.control);
  });
  grid->setColumnMinimumWidth(0, captionWidth);
  grid->setColumnStretch(0, ticksAlone ? 1 : 0);
  grid->setColumnStretch(1, 1);
  int line = 0;
  int ticks = 0;
  for (const ExportRow& row : m_rows) {
    QWidget* made = std::visit([&](const auto& kind) { return control(row, kind); }, row.control);
    made->setObjectName(QStringLiteral("export-") + row.id);
    made->setToolTip(row.tip);
    made->setAccessibleDescription(row.tip);
    if (std::holds_alternative<RowSwitch>(row.control)) {
      // Two beside each other: they are short.
      grid->addWidget(made, line, ticks % 2);
      line += ticks++ % 2;
      m_widgets.push_back({made});
      continue;
    }
    auto* label = new QLabel(row.text);
    label->setBuddy(made);
    grid->addWidget(label, line, 0);
    grid->addWidget(made, line++, 1);
    m_widgets.push_back({label, made});
  }
}

bool RowForm::showFor(const QString& kind) {
  bool any = false;
  for (std::size_t i = 0; i < m_rows.size(); ++i) {
    const bool shown = m_rows[i].isFor(kind);
    any = any || shown;
    for (QWidget* widget : m_widgets[i])
      widget->setVisible(shown);
  }
  setVisible(any);
  return any;
}

QWidget* RowForm::control(const ExportRow& row, const RowSwitch&) {
  auto* box = new QCheckBox(row.text);
  box->setChecked(row.read(m_order).toBool());
  connect(box, &QCheckBox::toggled, this, [this, row](bool on) { take(row, on); });
  return box;
}

QWidget* RowForm::control(const ExportRow& row, const RowChoice& kind) {
  auto* box = new QComboBox;
  for (const RowChoice::Entry& entry : kind.entries)
    box->addItem(entry.text, entry.value);
  // A box that grew with its widest text would push the preview aside.
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  box->setCurrentIndex(std::max(0, box->findData(row.read(m_order))));
  connect(box, &QComboBox::currentIndexChanged, this,
          [this, box, row](int at) { take(row, box->itemData(at)); });
  return box;
}

QWidget* RowForm::control(const ExportRow& row, const RowNumber& kind) {
  auto* box = new QDoubleSpinBox;
  box->setRange(kind.low, kind.high);
  box->setDecimals(kind.decimals);
  box->setSingleStep(kind.step);
  if (!kind.unit.isEmpty())
    box->setSuffix(QLatin1Char(' ') + kind.unit);
  box->setKeyboardTracking(false);
  box->setValue(row.read(m_order).toDouble());
  connect(box, &QDoubleSpinBox::valueChanged, this,
          [this, row](double number) { take(row, number); });
  return box;
}

QWidget* RowForm::control(const ExportRow& row, const RowText& kind) {
  if (kind.lines > 1) {
    auto* box = new QPlainTextEdit(row.read(m_order).toString());
    box->setTabChangesFocus(true);
    box->setFixedHeight((kind.lines + 1) * box->fontMetrics().lineSpacing());
    connect(box, &QPlainTextEdit::textChanged, this, [this, box, row, longest = kind.longest] {
      take(row, box->toPlainText().left(longest));
    });
    return box;
  }
  auto* line = new QLineEdit(row.read(m_order).toString());
  line->setMaxLength(kind.longest);
  connect(line, &QLineEdit::textChanged, this,
          [this, row](const QString& text) { take(row, text); });
  return line;
}

void RowForm::take(const ExportRow& row, const QVariant& value) {
  row.write(m_order, value);
  emit changed();
}

}  // namespace sline::widgets

#include "moc_row_form.cpp"
