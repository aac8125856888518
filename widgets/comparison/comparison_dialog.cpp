// SPDX-License-Identifier: Apache-2.0
#include "widgets/comparison/comparison_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "model/scene/visible_structures.h"
#include "render/export/comparison/comparison_file.h"
#include "render/lines/techniques/technique_list.h"
#include "widgets/gamma/technique_texts.h"
#include "widgets/text/path_text.h"
#include "widgets/text/told.h"

namespace sline::widgets {

namespace {

constexpr int columns = 4;
// Pictures are drawn twice as large and averaged, as they consist of little but edges.
constexpr int comparedSamples = 2;
constexpr double comparedPen = 1.2;  ///< pixels of the window
constexpr float sheetPen = 0.18f;    ///< mm, of `comparedScene`
constexpr float sheetDpi = 300.0f;
constexpr int mostPlaces = 256;
constexpr int soon = 15;  ///< milliseconds
constexpr double roomOfScreen = 0.92;

}  // namespace

ComparisonDialog::ComparisonDialog(Subject subject, Viewport& viewport, BackgroundQueue& queue,
                                   QWidget* parent)
    : QDialog(parent),
      m_subject(std::move(subject)),
      m_viewport(&viewport),
      m_queue(queue),
      m_rows({m_subject.whole}, m_subject.camera),
      m_scroll(new QScrollArea),
      m_apart(new QCheckBox(tr("Ro&w for each"))),
      m_surface(new QComboBox),
      m_told(new QLabel),
      m_save(new QPushButton(tr("&Save Sheet…"))) {
  setObjectName(QStringLiteral("comparisonDialog"));
  setWindowTitle(tr("Compare Techniques"));
  m_scroll->setObjectName(QStringLiteral("comparisonGrid"));
  m_scroll->setWidgetResizable(true);
  m_scroll->setFrameShape(QFrame::NoFrame);
  m_scroll->setFocusPolicy(Qt::NoFocus);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(m_scroll, 1);
  layout->addWidget(makeBottom());
  m_soon.setSingleShot(true);
  m_soon.setInterval(soon);
  connect(&m_soon, &QTimer::timeout, this, &ComparisonDialog::ask);
  connect(&viewport, &Viewport::previewed, this, &ComparisonDialog::took);
  makeRows();
  // All columns side by side want the screen's width.
  const QSize usual(1080, 700);
  resize(m_apart->isChecked() ? usual.expandedTo(screen()->availableSize() * roomOfScreen) : usual);
}

ComparisonDialog::~ComparisonDialog() {
  if (m_viewport)
    m_viewport->askPreviews({.previews = {}, .asker = PreviewsOf::compared});
}

void ComparisonDialog::makeRows() {
  m_rows = ComparisonRows(m_apart->isChecked() ? m_subject.apart : std::vector{m_subject.whole},
                          m_subject.camera);
  m_columns.clear();
  m_places.clear();
  m_next = 0;
  m_made = m_round + 1;
  m_scroll->setWidget(makeGrid());
  roughen();
}

QWidget* ComparisonDialog::makeGrid() {
  QStringList names;
  for (std::size_t row = 0; row < m_rows.count(); ++row)
    names.append(QString::fromStdString(m_rows.shown(row).name));
  auto* grid = new QWidget;
  auto* layout = new QGridLayout(grid);
  layout->setHorizontalSpacing(names.size() > 1 ? 6 : 12);
  layout->setVerticalSpacing(10);
  int room = 0;
  for (const render::TechniqueFacts& facts : render::techniqueList()) {
    if (!facts.drawsLines())
      continue;
    auto* column = new ComparisonColumn(facts.technique, names);
    column->showThresholds(m_thresholds);
    connect(column, &ComparisonColumn::thresholdChanged, this, &ComparisonDialog::setThreshold);
    for (std::size_t row = 0; row < m_rows.count(); ++row) {
      ComparisonPicture* picture = column->pictures()[row];
      connect(picture, &ComparisonPicture::turned, this, [this, row](const model::Camera& camera) {
        m_rows.turn(row, camera);
        change();
      });
      m_places.push_back({.picture = picture, .technique = facts.technique, .row = row});
    }
    room = std::max(room, column->below().sizeHint().height());
    m_columns.push_back(column);
  }
  // Several models stand one below the other in all columns, so these stand side by side.
  const int across = names.size() > 1 ? int(m_columns.size()) : columns;
  for (int place = 0; place < int(m_columns.size()); ++place) {
    ComparisonColumn* column = m_columns[std::size_t(place)];
    if (names.size() > 1)
      column->below().setMinimumHeight(room);
    layout->addWidget(column, place / across, place % across);
    layout->setColumnStretch(place % across, 1);
  }
  return grid;
}

QWidget* ComparisonDialog::makeBottom() {
  auto* bottom = new QWidget;
  auto* layout = new QHBoxLayout(bottom);
  layout->setContentsMargins(0, 0, 0, 0);
  m_apart->setObjectName(QStringLiteral("comparedApart"));
  m_apart->setToolTip(tr("Shows what was selected one below the other, else all of it together"));
  m_apart->setVisible(!m_subject.apart.empty());
  m_apart->setChecked(!m_subject.apart.empty());
  connect(m_apart, &QCheckBox::toggled, this, &ComparisonDialog::makeRows);
  auto* label = new QLabel(tr("Su&rface:"));
  label->setBuddy(m_surface);
  m_surface->setObjectName(QStringLiteral("comparedSurface"));
  m_surface->addItem(tr("As it is"));
  m_surface->addItem(tr("With staircase"));
  m_surface->addItem(tr("With jitter"));
  m_surface->setToolTip(
      tr("Roughens the surface, to see which techniques bear what segmentation leaves on it"));
  connect(m_surface, &QComboBox::currentIndexChanged, this, &ComparisonDialog::roughen);
  auto* reset = new QPushButton(tr("Reset &Thresholds"));
  reset->setObjectName(QStringLiteral("comparisonReset"));
  connect(reset, &QPushButton::clicked, this, &ComparisonDialog::resetThresholds);
  m_told->setObjectName(QStringLiteral("comparisonTold"));
  m_told->setTextFormat(Qt::PlainText);
  m_told->setWordWrap(true);
  m_save->setObjectName(QStringLiteral("comparisonSave"));
  m_save->setToolTip(tr("As PDF, SVG or PNG, with what the pictures take and draw"));
  connect(m_save, &QPushButton::clicked, this, &ComparisonDialog::chooseFile);
  auto* close = new QPushButton(tr("Close"));
  close->setObjectName(QStringLiteral("comparisonClose"));
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  for (QPushButton* button : {reset, m_save, close})
    button->setAutoDefault(false);
  layout->addWidget(m_apart);
  layout->addWidget(label);
  layout->addWidget(m_surface);
  layout->addWidget(reset);
  layout->addWidget(m_told, 1);
  layout->addWidget(m_save);
  layout->addWidget(close);
  return bottom;
}

void ComparisonDialog::change() {
  for (const Place& place : m_places)
    place.picture->setCamera(m_rows.shown(place.row).camera, m_rows.pivot(place.row),
                             m_rows.ends(place.row));
  ++m_round;
  m_soon.start();
}

void ComparisonDialog::setThreshold(const QString& name, double value) {
  m_thresholds.set(name.toStdString(), float(value));
  change();
}

void ComparisonDialog::resetThresholds() {
  m_thresholds = {};
  for (ComparisonColumn* column : m_columns)
    column->showThresholds(m_thresholds);
  change();
}

void ComparisonDialog::roughen() {
  const int kind = m_surface->currentIndex() - 1;
  m_rows.roughen(kind < 0 ? std::nullopt
                          : std::optional(render::Noise{render::NoiseKind(kind),
                                                        render::usualNoise[std::size_t(kind)]}));
  change();
}

void ComparisonDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  change();
}

void ComparisonDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  m_soon.start();
}

void ComparisonDialog::ask() {
  if (!m_viewport || m_places.empty() || !isVisible())
    return;
  PreviewRequest request{.previews = {}, .asker = PreviewsOf::compared};
  const double ratio = devicePixelRatioF();
  // Only pictures of one size can be compared.
  int room = m_places.front().picture->room();
  for (const Place& place : m_places)
    room = std::min(room, place.picture->room());
  for (const Place& place : m_places)
    place.picture->setSide(room);
  const int side = int(room * ratio) * comparedSamples;
  // A picture that high in millimetres has the pen of a sheet where the window has its own.
  const float mm = sheetPen * float(side) / float(comparedPen * ratio * comparedSamples);
  for (std::size_t i = 0; i < m_places.size(); ++i) {
    const std::size_t at = (m_next + i) % m_places.size();
    const Place& place = m_places[at];
    if (place.took == m_round)
      continue;
    const render::ComparedModel& shown = m_rows.shown(place.row);
    request.previews.push_back(
        {.id = m_round * mostPlaces + int(at),
         .scene = render::comparedScene(shown.scene, place.technique, m_thresholds, mm),
         .camera = shown.camera,
         .settings = {.width = side,
                      .height = side,
                      .environment = {.background = render::Background::white, .light = {}}},
         .samples = comparedSamples});
  }
  m_viewport->askPreviews(std::move(request));
}

void ComparisonDialog::took(PreviewsOf asker, int id, const QImage& image) {
  if (asker != PreviewsOf::compared)
    return;
  const std::size_t at = std::size_t(id % mostPlaces);
  const int round = id / mostPlaces;
  if (at >= m_places.size() || round < m_made || round < m_places[at].took)
    return;
  m_places[at].took = round;
  m_next = at + 1;
  m_places[at].picture->setImage(image);
}

bool ComparisonDialog::upToDate() const {
  return std::all_of(m_places.begin(), m_places.end(),
                     [this](const Place& place) { return place.took == m_round; });
}

render::ComparisonOrder ComparisonDialog::order() const {
  render::ComparisonOrder order;
  order.thresholds = m_thresholds;
  order.models = m_rows.sheet();
  for (const ComparisonColumn* column : m_columns)
    order.techniques.push_back(column->technique());
  return order;
}

render::ComparisonWords ComparisonDialog::words() {
  render::ComparisonWords words;
  words.triangles = tr("%1 triangles").toStdString();
  words.time = tr("ms: median time to find and join the lines of a view, contours among them, once "
                  "the surface is prepared.")
                   .toStdString();
  words.length = tr("mm⁻¹: length of the technique's visible lines, without contours, per area "
                    "that the model covers, as drawn here.")
                     .toStdString();
  words.sizes = tr("F: radius of the model's bounding sphere; F_c: its median radius of curvature, "
                   "at most F; H, κ1: mean curvature, the stronger principal curvature; f: light "
                   "from the eye.")
                    .toStdString();
  for (const render::TechniqueFacts& facts : render::techniqueList())
    words.techniques.push_back(linesName(facts.technique).toStdString());
  words.meaning = [](const char* meaning) { return thresholdMeaning(meaning).toStdString(); };
  return words;
}

void ComparisonDialog::chooseFile() {
  auto* dialog = new QFileDialog(this, tr("Save Sheet"), m_subject.folder);
  dialog->setObjectName(QStringLiteral("comparisonFileDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setNameFilters({tr("PDF (*.pdf)"), tr("SVG drawing (*.svg)"), tr("PNG picture (*.png)"),
                          tr("TIFF picture (*.tiff)")});
  dialog->setDefaultSuffix(QStringLiteral("pdf"));
  connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
    dialog->setDefaultSuffix(filter.section(QLatin1Char('.'), -1).chopped(1));
  });
  connect(dialog, &QFileDialog::fileSelected, this, &ComparisonDialog::save);
  dialog->open();
}

void ComparisonDialog::save(const QString& path) {
  const std::filesystem::path target = pathOf(path);
  if (const Status named = render::checkSheetName(target); !named.ok())
    return m_told->setText(told(named.error().text()));
  m_subject.folder = QFileInfo(path).absolutePath();
  m_save->setEnabled(false);
  m_told->setText(tr("Drawing the sheet…"));
  m_queue.add([dialog = QPointer(this), path, target, order = order(),
               words = words()](const std::stop_token& stop) {
    const Result<render::Comparison> comparison =
        render::compareTechniques(order, render::ExportProgress([&stop](double, std::string_view) {
                                    return !stop.stop_requested();
                                  }));
    const Status status =
        comparison.ok()
            ? render::writeSheet(render::comparisonSheet(*comparison, words), target, sheetDpi)
            : Status(comparison.error());
    return BackgroundQueue::Sequel([dialog, path, status] {
      if (dialog)
        dialog->savedAs(path, status);
    });
  });
}

void ComparisonDialog::savedAs(const QString& path, const Status& status) {
  m_save->setEnabled(true);
  m_told->setText(status.ok() ? tr("Saved %1").arg(QFileInfo(path).fileName())
                              : told(status.error().text()));
}

}  // namespace sline::widgets

#include "moc_comparison_dialog.cpp"
