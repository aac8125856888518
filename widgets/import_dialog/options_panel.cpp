// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/options_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

#include "widgets/import_dialog/choice_rows.h"
#include "widgets/import_dialog/plan_texts.h"

namespace sline::widgets {

OptionsPanel::OptionsPanel(ImportDraft& draft, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_frame(combo("importFrame")),
      m_frameReason(reason("frameReason")),
      m_unit(combo("importUnit")),
      m_unitReason(reason("unitReason")),
      m_smoothing(combo("importSmoothing")),
      m_decimation(new QDoubleSpinBox),
      m_repair(new QCheckBox(tr("&Mend faces"))),
      m_overlay(new QCheckBox(tr("Lay molecules &over each other"))) {
  setObjectName(QStringLiteral("importOptions"));
  const QString found = tr("As found");
  addChoices(*m_frame, found, frameRows());
  addChoices(*m_unit, found, unitRows());
  addChoices(*m_smoothing, QString(), smoothingRows());
  m_smoothing->setToolTip(
      tr("Automatic: takes away the steps of label maps, and refines what is too "
         "coarse to draw; steps: so much everywhere"));
  m_decimation->setObjectName(QStringLiteral("importDecimation"));
  m_decimation->setRange(0.0, 100.0);
  m_decimation->setDecimals(2);
  m_decimation->setSingleStep(0.05);
  m_decimation->setSuffix(tr(" mm"));
  m_decimation->setSpecialValueText(tr("Keep all"));
  m_decimation->setKeyboardTracking(false);
  m_decimation->setToolTip(
      tr("As few triangles as can be with no part of a surface moved by more than this"));
  m_repair->setObjectName(QStringLiteral("importRepair"));
  m_repair->setToolTip(
      tr("Leaves out faces without area or given twice, and turns those that look "
         "inwards"));
  m_overlay->setObjectName(QStringLiteral("importOverlay"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  place(*grid);
  connectControls();
  connect(&draft, &ImportDraft::chosen, this, &OptionsPanel::refresh);
  connect(&draft, &ImportDraft::planned, this, &OptionsPanel::refresh);
  refresh();
}

QComboBox* OptionsPanel::combo(const char* name) {
  auto* box = new QComboBox;
  box->setObjectName(QLatin1String(name));
  return box;
}

QLabel* OptionsPanel::reason(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setTextFormat(Qt::PlainText);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

void OptionsPanel::place(QGridLayout& grid) {
  const auto row = [&grid](int at, const QString& text, QWidget* control, QWidget* beside) {
    auto* label = new QLabel(text);
    label->setBuddy(control);
    grid.addWidget(label, at, 0);
    grid.addWidget(control, at, 1);
    grid.addWidget(beside, at, 2);
  };
  row(0, tr("Coor&dinates"), m_frame, m_frameReason);
  row(1, tr("&Length of a unit"), m_unit, m_unitReason);
  auto* more = new QWidget;
  auto* layout = new QHBoxLayout(more);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* fewer = new QLabel(tr("Fewer t&riangles, within"));
  fewer->setBuddy(m_decimation);
  layout->addWidget(fewer);
  layout->addWidget(m_decimation);
  layout->addSpacing(12);
  layout->addWidget(m_repair);
  layout->addWidget(m_overlay);
  layout->addStretch(1);
  row(2, tr("S&moothing"), m_smoothing, more);
  grid.setColumnStretch(2, 1);
  grid.setHorizontalSpacing(12);
}

void OptionsPanel::connectControls() {
  connect(m_frame, &QComboBox::activated, this, [this](int index) {
    change([value = valueAt(*m_frame, index, frameRows())](auto& o) { o.frame = value; });
  });
  connect(m_unit, &QComboBox::activated, this, [this](int index) {
    change([value = valueAt(*m_unit, index, unitRows())](auto& o) { o.unit = value; });
  });
  connect(m_smoothing, &QComboBox::activated, this, [this](int index) {
    const auto value = valueAt(*m_smoothing, index, smoothingRows());
    change([value](auto& o) { o.smoothing = value.value_or(model::Smoothing()); });
  });
  connect(m_decimation, &QDoubleSpinBox::valueChanged, this,
          [this](double value) { change([value](auto& o) { o.decimateMm = float(value); }); });
  connect(m_repair, &QCheckBox::clicked, this,
          [this](bool on) { change([on](auto& o) { o.repair = on; }); });
  connect(m_overlay, &QCheckBox::clicked, this, [this](bool on) {
    change([on](auto& o) { o.overlay = on ? model::Overlay::automatic : model::Overlay::off; });
  });
}

void OptionsPanel::change(const std::function<void(model::ImportOptions&)>& how) {
  model::ImportOptions options = m_draft.plan().options;
  how(options);
  m_draft.setOptions(options);
}

void OptionsPanel::refresh() {
  const model::ImportPlan& plan = m_draft.plan();
  const model::ImportOptions& options = plan.options;
  showValue(*m_frame, options.frame, frameRows());
  showValue(*m_unit, options.unit, unitRows());
  showValue(*m_smoothing, std::optional(options.smoothing), smoothingRows());
  const QSignalBlocker quiet(*m_decimation);
  m_decimation->setValue(double(options.decimateMm));
  m_repair->setChecked(options.repair);
  m_overlay->setChecked(options.overlay == model::Overlay::automatic);
  m_overlay->setVisible(m_draft.figures().entries > 1);
  if (!plan.read)
    return;
  for (const auto& [label, text] :
       {std::pair(m_frameReason, frameText(plan)), std::pair(m_unitReason, unitReasonText(plan))}) {
    constexpr int widest = 680;  // of a dialog as it opens; the tip has all of it
    label->setText(label->fontMetrics().elidedText(text, Qt::ElideRight, widest));
    label->setToolTip(text.toHtmlEscaped());
  }
}

}  // namespace sline::widgets

#include "moc_options_panel.cpp"
