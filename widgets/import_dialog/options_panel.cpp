// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/options_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <algorithm>

#include "widgets/form/control.h"
#include "widgets/import_dialog/choice_rows.h"
#include "widgets/import_dialog/plan_texts.h"

namespace sline::widgets {

OptionsPanel::OptionsPanel(ImportDraft& draft, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_rows(rows()),
      m_frameReason(reason("frameReason")),
      m_unitReason(reason("unitReason")) {
  setObjectName(QStringLiteral("importOptions"));
  for (Row& row : m_rows)
    row.control = makeControl(row.field, [this, write = row.write](const QVariant& value) {
      model::ImportOptions options = m_draft.plan().options;
      write(options, value);
      m_draft.setOptions(options);
    });
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  place(*grid);
  connect(&draft, &ImportDraft::chosen, this, &OptionsPanel::refresh);
  connect(&draft, &ImportDraft::planned, this, &OptionsPanel::refresh);
  refresh();
}

std::vector<OptionsPanel::Row> OptionsPanel::rows() {
  const QString found = tr("As found");
  return {
      {{QStringLiteral("importFrame"), {}, {}, choiceField(found, frameRows())},
       [](const auto& o) { return idOf(o.frame, frameRows()); },
       [](auto& o, const QVariant& id) { o.frame = meaningOf(id, frameRows()); }},
      {{QStringLiteral("importUnit"), {}, {}, choiceField(found, unitRows())},
       [](const auto& o) { return idOf(o.unit, unitRows()); },
       [](auto& o, const QVariant& id) { o.unit = meaningOf(id, unitRows()); }},
      {{QStringLiteral("importSmoothing"),
        {},
        tr("Automatic: takes away the steps of label maps, and refines what is too "
           "coarse to draw; steps: so much everywhere"),
        choiceField(QString(), smoothingRows())},
       [](const auto& o) { return idOf(std::optional(o.smoothing), smoothingRows()); },
       [](auto& o, const QVariant& id) {
         o.smoothing = meaningOf(id, smoothingRows()).value_or(model::Smoothing());
       }},
      {{QStringLiteral("importDecimation"),
        {},
        tr("As few triangles as can be with no part of a surface moved by more than this"),
        NumberField{.high = 100.0,
                    .decimals = 2,
                    .step = 0.05,
                    .unit = tr("mm"),
                    .lowestText = tr("Keep all")}},
       [](const auto& o) { return double(o.decimateMm); },
       [](auto& o, const QVariant& millimetres) { o.decimateMm = millimetres.toFloat(); }},
      {{QStringLiteral("importRepair"), tr("&Mend faces"),
        tr("Leaves out faces without area or given twice, and turns those that look "
           "inwards"),
        SwitchField{}},
       [](const auto& o) { return o.repair; },
       [](auto& o, const QVariant& on) { o.repair = on.toBool(); }},
      {{QStringLiteral("importKeepNames"), tr("Kee&p names"),
        tr("Names of files, folders and what is in them stay whole; else words that are no anatomy "
           "are left out, as they may be a person's name"),
        SwitchField{}},
       [](const auto& o) { return o.keepFileNames; },
       [](auto& o, const QVariant& on) { o.keepFileNames = on.toBool(); }},
      {{QStringLiteral("importOverlay"), tr("Lay molecules &over each other"), {}, SwitchField{}},
       [](const auto& o) { return o.overlay == model::Overlay::automatic; },
       [](auto& o, const QVariant& on) {
         o.overlay = on.toBool() ? model::Overlay::automatic : model::Overlay::off;
       }}};
}

QWidget* OptionsPanel::controlOf(const char* id) const {
  return std::find_if(m_rows.begin(), m_rows.end(),
                      [id](const Row& row) { return row.field.id == QLatin1String(id); })
      ->control;
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
  row(0, tr("Coor&dinates"), controlOf("importFrame"), m_frameReason);
  row(1, tr("&Length of a unit"), controlOf("importUnit"), m_unitReason);
  auto* more = new QWidget;
  auto* layout = new QHBoxLayout(more);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* fewer = new QLabel(tr("Fewer t&riangles, within"));
  fewer->setBuddy(controlOf("importDecimation"));
  layout->addWidget(fewer);
  layout->addWidget(controlOf("importDecimation"));
  layout->addSpacing(12);
  layout->addWidget(controlOf("importRepair"));
  layout->addWidget(controlOf("importKeepNames"));
  layout->addWidget(controlOf("importOverlay"));
  layout->addStretch(1);
  row(2, tr("S&moothing"), controlOf("importSmoothing"), more);
  grid.setColumnStretch(2, 1);
  grid.setHorizontalSpacing(12);
}

void OptionsPanel::refresh() {
  const model::ImportPlan& plan = m_draft.plan();
  for (const Row& row : m_rows)
    showValue(*row.control, row.field.kind, row.read(plan.options));
  controlOf("importOverlay")->setVisible(m_draft.figures().entries > 1);
  if (!model::isRead(plan))
    return;
  for (const auto& [label, text] :
       {std::pair(m_frameReason, frameText(plan)), std::pair(m_unitReason, unitReasonText(plan))}) {
    constexpr int widest = 680;  // pixels, so that the dialog opens narrow; the tip has all of it
    label->setText(label->fontMetrics().elidedText(text, Qt::ElideRight, widest));
    label->setToolTip(text.toHtmlEscaped());
  }
}

}  // namespace sline::widgets

#include "moc_options_panel.cpp"
