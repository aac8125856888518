// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/threshold_editor.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "render/lines/techniques/technique_list.h"
#include "widgets/gamma/selected_looks.h"
#include "widgets/gamma/technique_texts.h"

namespace sline::widgets {

ThresholdEditor::ThresholdEditor(Session& session, QWidget* parent)
    : StyleEditor(session, QStringLiteral("lineThresholds"), tr("Thresholds of lines"), parent) {
  setToolTip(tr("How strong lines must be for their technique to draw them"));
  auto* head = new QHBoxLayout;
  head->setSpacing(8);
  head->addWidget(&label(), 1);
  head->addWidget(&resetButton());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(head);
  for (const render::TechniqueFacts& facts : render::techniqueList()) {
    QWidget* page = makePage(facts.technique);
    page->hide();
    layout->addWidget(page);
  }
  connect(&resetButton(), &QToolButton::clicked, this,
          [this] { inherit({.lineThresholds = model::ThresholdValues()}); });
}

QWidget* ThresholdEditor::makePage(model::Technique technique) {
  Page page{.widget = new QWidget, .boxes = {}};
  auto* rows = new QVBoxLayout(page.widget);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(2);
  for (const render::TechniqueThreshold& threshold : render::factsOf(technique).thresholds) {
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QStringLiteral("threshold_") + QString::fromStdString(threshold.name));
    box->setAccessibleName(linesName(technique) + QStringLiteral(": ") +
                           QString::fromUtf8(threshold.id));
    box->setToolTip(thresholdMeaning(threshold.meaning));
    box->setAccessibleDescription(box->toolTip());
    box->setDecimals(3);
    box->setRange(double(threshold.limits.low), double(threshold.limits.high));
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    box->setKeyboardTracking(false);
    auto* caption = new QLabel(QString::fromUtf8(threshold.id));
    caption->setBuddy(box);
    caption->setToolTip(box->toolTip());
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(caption, 1);
    row->addWidget(box);
    rows->addLayout(row);
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, name = threshold.name](double value) { choose(name, value); });
    page.boxes.push_back(box);
  }
  m_pages.push_back(page);
  return page.widget;
}

void ThresholdEditor::choose(const std::string& name, double value) {
  m_values.set(name, float(value));
  apply({.lineThresholds = m_values});
}

void ThresholdEditor::showSelection() {
  const std::vector<model::ResolvedStyle> looks = looksOf(session().scene(), session().selection());
  if (looks.empty())
    return;
  m_values = looks.front().lineThresholds;
  const model::Technique first = looks.front().technique;
  const bool mixed = std::any_of(looks.begin(), looks.end(),
                                 [first](const auto& look) { return look.technique != first; });
  for (std::size_t i = 0; i < m_pages.size(); ++i) {
    const bool shown = !mixed && i == std::size_t(first);
    m_pages[i].widget->setVisible(shown);
    const auto& thresholds = render::techniqueList()[i].thresholds;
    for (std::size_t k = 0; shown && k < thresholds.size(); ++k) {
      const QSignalBlocker quiet(m_pages[i].boxes[k]);
      m_pages[i].boxes[k]->setValue(double(render::valueOf(thresholds[k], m_values)));
    }
  }
  resetButton().setEnabled(
      anyBelowSays(session().scene(), session().selection(),
                   [](const model::Style& style) { return style.lineThresholds.has_value(); }));
}

}  // namespace sline::widgets

#include "moc_threshold_editor.cpp"
