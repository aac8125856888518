// SPDX-License-Identifier: Apache-2.0
#include "widgets/import_dialog/threshold_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "widgets/import_dialog/intensity_range.h"
#include "widgets/import_dialog/scan_slices.h"
#include "widgets/text/told.h"

namespace sline::widgets {

namespace {

QDoubleSpinBox* numberField(const char* name) {
  auto* box = new QDoubleSpinBox;
  box->setObjectName(QLatin1String(name));
  box->setKeyboardTracking(false);
  return box;
}

/// Returns a preset of the table in the user's language.
QString presetText(std::string_view name) {
  if (name == "bone")
    return ThresholdPanel::tr("Bone");
  if (name == "skin")
    return ThresholdPanel::tr("Skin");
  if (name == "vessels")
    return ThresholdPanel::tr("Contrast vessels");
  return QString::fromUtf8(name.data(), qsizetype(name.size()));
}

}  // namespace

ThresholdPanel::ThresholdPanel(ImportDraft& draft, QWidget* parent)
    : QWidget(parent),
      m_draft(draft),
      m_scans(new QComboBox),
      m_about(new QLabel),
      m_range(new IntensityRange),
      m_name(new QLineEdit),
      m_low(numberField("thresholdLow")),
      m_high(numberField("thresholdHigh")),
      m_add(new QPushButton),
      m_made(new QLabel),
      m_keep(new QCheckBox(tr("&Keep the scan with the scene (for slices)"))),
      m_slices(new QLabel) {
  setObjectName(QStringLiteral("thresholdPanel"));
  m_scans->setObjectName(QStringLiteral("scanChoice"));
  m_scans->setAccessibleName(tr("Scan"));
  m_about->setTextFormat(Qt::PlainText);
  m_about->setObjectName(QStringLiteral("scanAbout"));
  m_slices->setObjectName(QStringLiteral("scanSlices"));
  m_slices->setAccessibleName(tr("Axial, coronal and sagittal slice through the middle"));
  m_slices->setAlignment(Qt::AlignCenter);
  m_slices->setMinimumHeight(200);
  m_made->setObjectName(QStringLiteral("thresholdsMade"));
  m_made->setTextFormat(Qt::PlainText);
  m_made->setWordWrap(true);
  m_keep->setObjectName(QStringLiteral("keepScan"));
  auto* layout = new QVBoxLayout(this);
  auto* top = new QHBoxLayout;
  top->addWidget(m_scans);
  top->addWidget(m_about, 1);
  layout->addLayout(top);
  layout->addWidget(m_slices, 1);
  layout->addWidget(m_range);
  auto* grid = new QGridLayout;
  makeFields(*grid);
  layout->addLayout(grid);
  layout->addWidget(m_made);
  layout->addWidget(m_keep);
  connectControls();
  connect(&draft, &ImportDraft::planned, this, &ThresholdPanel::refresh);
  connect(&draft, &ImportDraft::chosen, this, &ThresholdPanel::showMade);
}

void ThresholdPanel::makePresets(QHBoxLayout& row) {
  for (const model::ThresholdPreset& preset : model::thresholdPresets()) {
    const std::string name(preset.name);
    auto* button = new QPushButton(presetText(preset.name));
    button->setObjectName(QStringLiteral("preset_") + QString::fromStdString(name));
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [this, name] { choosePreset(name); });
    row.addWidget(button);
    m_presets.push_back(button);
  }
  row.addStretch(1);
}

void ThresholdPanel::makeFields(QGridLayout& grid) {
  m_name->setObjectName(QStringLiteral("thresholdName"));
  m_name->setPlaceholderText(tr("Name of the structure"));
  m_add->setObjectName(QStringLiteral("addThreshold"));
  m_add->setAutoDefault(false);
  auto* presets = new QHBoxLayout;
  makePresets(*presets);
  grid.addLayout(presets, 0, 0, 1, 7);
  const auto place = [&grid](int column, const QString& text, QWidget* field) {
    auto* label = new QLabel(text);
    label->setBuddy(field);
    grid.addWidget(label, 1, column);
    grid.addWidget(field, 1, column + 1);
  };
  place(0, tr("&Name"), m_name);
  place(2, tr("&From"), m_low);
  place(4, tr("t&o"), m_high);
  grid.addWidget(m_add, 1, 6);
  grid.setColumnStretch(1, 1);
}

void ThresholdPanel::connectControls() {
  connect(m_scans, &QComboBox::activated, this, [this] { showScan(); });
  connect(m_range, &IntensityRange::boundsChanged, this, &ThresholdPanel::setBounds);
  const auto byNumber = [this] {
    model::IntensityBounds bounds{m_low->value(), m_high->value()};
    if (m_high->value() == m_high->maximum())
      bounds.high.reset();
    setBounds(bounds);
  };
  connect(m_low, &QDoubleSpinBox::valueChanged, this, byNumber);
  connect(m_high, &QDoubleSpinBox::valueChanged, this, byNumber);
  connect(m_name, &QLineEdit::textChanged, this, [this] { showMade(); });
  connect(m_add, &QPushButton::clicked, this, &ThresholdPanel::addStructure);
  connect(m_keep, &QCheckBox::clicked, this, [this](bool on) {
    model::ImportOptions options = m_draft.plan().options;
    options.keepScans = on;
    m_draft.setOptions(options);
  });
}

const ScanFigures* ThresholdPanel::scan() const {
  const auto& scans = m_draft.figures().scans;
  const auto index = std::size_t(std::max(0, m_scans->currentIndex()));
  return index < scans.size() ? scans[index].get() : nullptr;
}

void ThresholdPanel::refresh() {
  const auto& scans = m_draft.figures().scans;
  const int index = std::max(0, m_scans->currentIndex());
  m_scans->clear();
  for (const auto& one : scans)
    m_scans->addItem(QString::fromStdString(one->file));
  m_scans->setCurrentIndex(std::min(index, int(scans.size()) - 1));
  m_scans->setVisible(scans.size() > 1);
  if (scan() && m_shown != scan()->volume.get())
    showScan();
  showMade();
}

void ThresholdPanel::showScan() {
  const ScanFigures& shown = *scan();
  m_shown = shown.volume.get();
  m_about->setText((m_scans->count() > 1 ? QString() : QString::fromStdString(shown.file + ": ")) +
                   QString::fromStdString(shown.text));
  m_range->setHistogram(shown.histogram);
  const double span = shown.histogram.greatest() - shown.histogram.least();
  const int decimals = std::clamp(2 - int(std::floor(std::log10(std::max(span, 1e-6)))), 0, 6);
  for (QDoubleSpinBox* field : {m_low, m_high}) {
    const QSignalBlocker quiet(*field);
    field->setDecimals(decimals);
    field->setRange(std::floor(shown.histogram.least()), std::ceil(shown.histogram.greatest()));
    field->setSingleStep(std::max(span / 200.0, std::pow(10.0, -decimals)));
    field->setSuffix(shown.volume->hounsfield ? tr(" HU") : QString());
  }
  for (std::size_t i = 0; i < m_presets.size(); ++i) {
    const model::Threshold preset{std::string(model::thresholdPresets()[i].name), {}, {}};
    const auto bounds = model::boundsOf(preset, shown.volume->hounsfield, shown.histogram);
    m_presets[i]->setEnabled(bounds.ok());
    m_presets[i]->setToolTip(bounds.ok() ? QString() : told(bounds.error().text()));
  }
  const auto able = std::find_if(m_presets.begin(), m_presets.end(),
                                 [](const QPushButton* button) { return button->isEnabled(); });
  if (able != m_presets.end())
    choosePreset(
        std::string(model::thresholdPresets()[std::size_t(able - m_presets.begin())].name));
}

void ThresholdPanel::choosePreset(const std::string& name) {
  if (!scan())
    return;
  const auto bounds =
      model::boundsOf({name, {}, {}}, scan()->volume->hounsfield, scan()->histogram);
  if (!bounds.ok())
    return;
  m_name->setText(QString::fromStdString(name));
  setBounds(*bounds);
}

void ThresholdPanel::setBounds(const model::IntensityBounds& bounds) {
  const QSignalBlocker quietLow(*m_low);
  const QSignalBlocker quietHigh(*m_high);
  m_low->setValue(bounds.low.value_or(m_low->minimum()));
  m_high->setValue(bounds.high.value_or(m_high->maximum()));
  m_range->setBounds(bounds);
  showSlices();
}

void ThresholdPanel::showSlices() {
  if (!scan())
    return;
  constexpr int tall = 200;
  constexpr int gap = 10;
  std::vector<QImage> images;
  int wide = 0;
  for (const ScanSlice& slice : scan()->slices) {
    const double ratio = slice.aspect * slice.width / std::max(1, slice.height);
    const int width = std::clamp(int(tall * ratio), 20, 420);
    images.push_back(tinted(slice, *scan(), m_range->bounds())
                         .scaled(width, std::min(tall, int(width / ratio)), Qt::IgnoreAspectRatio,
                                 Qt::SmoothTransformation));
    wide += images.back().width() + gap;
  }
  QPixmap all(wide - gap, tall);
  all.fill(Qt::black);
  QPainter painter(&all);
  int x = 0;
  for (const QImage& image : images) {
    painter.drawImage(x, (tall - image.height()) / 2, image);
    x += image.width() + gap;
  }
  painter.end();
  m_slices->setPixmap(all);
}

void ThresholdPanel::showMade() {
  const model::ImportOptions& options = m_draft.plan().options;
  QStringList made;
  for (const model::Threshold& threshold : options.thresholds)
    made << QString::fromStdString(threshold.name);
  m_made->setText(made.isEmpty() ? tr("No structure is made of the scan yet")
                                 : tr("Made of scans: %1").arg(made.join(QStringLiteral(", "))));
  m_add->setText(made.isEmpty() ? tr("&Add structure") : tr("&Add another structure"));
  m_add->setEnabled(scan() && !m_name->text().trimmed().isEmpty());
  m_keep->setChecked(options.keepScans);
}

void ThresholdPanel::addStructure() {
  model::ImportOptions options = m_draft.plan().options;
  const model::IntensityBounds& bounds = m_range->bounds();
  model::Threshold added{m_name->text().trimmed().toStdString(), bounds.low, bounds.high,
                         m_scans->count() > 1 ? scan()->file : std::string()};
  const auto same =
      std::find_if(options.thresholds.begin(), options.thresholds.end(),
                   [&](const auto& t) { return t.name == added.name && t.scan == added.scan; });
  if (same != options.thresholds.end())
    *same = std::move(added);
  else
    options.thresholds.push_back(std::move(added));
  m_draft.setOptions(options);
}

}  // namespace sline::widgets

#include "moc_threshold_panel.cpp"
