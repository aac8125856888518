// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/page_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "render/vectors/vector_drawing.h"
#include "widgets/export/export_texts.h"
#include "widgets/export/option_form.h"
#include "widgets/export/page_presets.h"

namespace sline::widgets {

PagePanel::PagePanel(ExportDraft& draft, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_preset(new QComboBox),
      m_turn(new QPushButton(tr("T&urn"))),
      m_width(number("exportWidth")),
      m_height(number("exportHeight")),
      m_unit(new QComboBox),
      m_dpiText(new QLabel(tr("Reso&lution"))),
      m_dpi(number("exportDpi")),
      m_other(new QLabel) {
  m_preset->setObjectName(QStringLiteral("exportPaper"));
  m_preset->addItem(tr("Custom size"), QString());
  for (const PagePreset& preset : pagePresets())
    m_preset->addItem(preset.text, preset.id);
  m_turn->setObjectName(QStringLiteral("exportTurn"));
  m_turn->setToolTip(tr("Upright or lying: width and height change places"));
  m_turn->setAutoDefault(false);
  m_width->setAccessibleName(tr("Width"));
  m_height->setAccessibleName(tr("Height"));
  m_unit->setObjectName(QStringLiteral("exportUnit"));
  m_unit->setAccessibleName(tr("Unit of width and height"));
  m_unit->addItem(tr("mm"), int(PageUnit::millimetres));
  m_unit->addItem(tr("px"), int(PageUnit::pixels));
  m_dpi->setRange(double(render::dpiLimits.low), double(render::dpiLimits.high));
  m_dpi->setSuffix(tr(" dpi"));
  m_dpi->setSingleStep(50.0);
  m_dpiText->setBuddy(m_dpi);
  m_other->setObjectName(QStringLiteral("exportOtherSize"));
  m_other->setTextFormat(Qt::PlainText);
  m_other->setEnabled(false);
  auto* grid = new QGridLayout(this);
  place(*grid);
  connectControls();
  refresh();
}

QDoubleSpinBox* PagePanel::number(const char* name) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(QLatin1String(name));
  box->setDecimals(0);
  box->setKeyboardTracking(false);
  return box;
}

void PagePanel::place(QGridLayout& grid) {
  grid.setContentsMargins(0, 0, 0, 0);
  grid.setHorizontalSpacing(12);
  grid.setVerticalSpacing(8);
  grid.setColumnMinimumWidth(0, captionWidth);
  auto* paper = new QLabel(tr("&Paper"));
  paper->setBuddy(m_preset);
  grid.addWidget(paper, 0, 0);
  auto* first = new QHBoxLayout;
  first->setSpacing(6);
  first->addWidget(m_preset, 1);
  first->addWidget(m_turn);
  grid.addLayout(first, 0, 1);
  auto* size = new QLabel(tr("Si&ze"));
  size->setBuddy(m_width);
  grid.addWidget(size, 1, 0);
  auto* second = new QHBoxLayout;
  second->setSpacing(6);
  second->addWidget(m_width, 1);
  second->addWidget(new QLabel(QStringLiteral("×")));
  second->addWidget(m_height, 1);
  second->addWidget(m_unit);
  grid.addLayout(second, 1, 1);
  grid.addWidget(m_dpiText, 2, 0);
  auto* third = new QHBoxLayout;
  third->addWidget(m_dpi);
  third->addWidget(m_other, 1);
  third->setSpacing(12);
  grid.addLayout(third, 2, 1);
  grid.setColumnStretch(1, 1);
}

void PagePanel::connectControls() {
  connect(m_preset, &QComboBox::activated, this, [this](int at) {
    for (const PagePreset& preset : pagePresets())
      if (preset.id == m_preset->itemData(at).toString())
        setSize(preset.turns ? turnedAs(preset.sizeMm, m_draft.order.page.sizeMm) : preset.sizeMm);
  });
  connect(m_turn, &QPushButton::clicked, this, [this] {
    const glm::vec2 size = m_draft.order.page.sizeMm;
    setSize({size.y, size.x});
  });
  connect(m_width, &QDoubleSpinBox::valueChanged, this, &PagePanel::typed);
  connect(m_height, &QDoubleSpinBox::valueChanged, this, &PagePanel::typed);
  connect(m_unit, &QComboBox::activated, this, [this](int at) {
    m_draft.unit = PageUnit(m_unit->itemData(at).toInt());
    refresh();
    emit changed();
  });
  connect(m_dpi, &QDoubleSpinBox::valueChanged, this, [this](double dpi) {
    render::ExportPage& page = m_draft.order.page;
    // A number of pixels that was typed stays the same.
    if (m_draft.unit == PageUnit::pixels)
      page.sizeMm *= page.dpi / float(dpi);
    page.dpi = float(dpi);
    refresh();
    emit changed();
  });
}

float PagePanel::millimetresPerUnit() const {
  return m_draft.unit == PageUnit::pixels && pageUseOf(m_draft.kind) == render::PageUse::pixels
             ? render::millimetresPerInch / m_draft.order.page.dpi
             : 1.0f;
}

void PagePanel::typed() {
  setSize(millimetresPerUnit() * glm::vec2(float(m_width->value()), float(m_height->value())));
}

void PagePanel::setSize(const glm::vec2& sizeMm) {
  m_draft.order.page.sizeMm = sizeMm;
  refresh();
  emit changed();
}

void PagePanel::refresh() {
  const bool pixels = pageUseOf(m_draft.kind) == render::PageUse::pixels;
  const render::ExportPage& page = m_draft.order.page;
  const float unit = millimetresPerUnit();
  const bool inPixels = unit != 1.0f;
  const float most =
      pixels ? std::min(render::pageLimitsMm.high,
                        float(render::pixelSideLimits.high) / page.dpi * render::millimetresPerInch)
             : render::pageLimitsMm.high;
  const std::pair<QDoubleSpinBox*, float> sides[] = {{m_width, page.sizeMm.x},
                                                     {m_height, page.sizeMm.y}};
  for (const auto& [box, millimetres] : sides) {
    const QSignalBlocker quiet(box);
    box->setDecimals(inPixels ? 0 : 1);
    box->setSingleStep(inPixels ? 100.0 : 10.0);
    box->setRange(double(render::pageLimitsMm.low / unit),
                  double(std::max(most, millimetres) / unit));
    box->setValue(double(millimetres / unit));
  }
  const QSignalBlocker quietDpi(m_dpi);
  m_dpi->setValue(double(page.dpi));
  m_unit->setCurrentIndex(
      m_unit->findData(int(inPixels ? PageUnit::pixels : PageUnit::millimetres)));
  m_unit->setEnabled(pixels);
  m_dpi->setVisible(pixels);
  m_dpiText->setVisible(pixels);
  m_other->setVisible(pixels);
  m_other->setText(inPixels ? millimetresText(page) : pixelsText(page));
  const std::optional<PagePreset> preset = presetOf(page.sizeMm);
  m_preset->setCurrentIndex(std::max(0, m_preset->findData(preset ? preset->id : QString())));
}

}  // namespace sline::widgets

#include "moc_page_panel.cpp"
