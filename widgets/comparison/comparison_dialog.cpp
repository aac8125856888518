// SPDX-License-Identifier: Apache-2.0
#include "widgets/comparison/comparison_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "model/scene/visible_structures.h"
#include "render/export/comparison/comparison_file.h"
#include "render/lines/technique_list.h"
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
constexpr int mostCells = 64;
constexpr int soon = 15;  ///< milliseconds

}  // namespace

ComparisonDialog::ComparisonDialog(Subject subject, Viewport& viewport, BackgroundQueue& queue,
                                   QWidget* parent)
    : QDialog(parent),
      m_subject(std::move(subject)),
      m_viewport(&viewport),
      m_queue(queue),
      m_surface(new QComboBox),
      m_told(new QLabel),
      m_save(new QPushButton(tr("&Save Sheet…"))) {
  setObjectName(QStringLiteral("comparisonDialog"));
  setWindowTitle(tr("Compare Techniques"));
  m_model = {.name = m_subject.name.toStdString(),
             .note = {},
             .scene = m_subject.scene,
             .camera = model::fittedToVisible(m_subject.scene, m_subject.camera, 1.0f)};
  m_shown = m_model;
  m_camera = m_model.camera;
  m_pivot = m_subject.scene.visibleBounds().centre();
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(makeGrid(), 1);
  layout->addWidget(makeBottom());
  m_soon.setSingleShot(true);
  m_soon.setInterval(soon);
  connect(&m_soon, &QTimer::timeout, this, &ComparisonDialog::ask);
  connect(&viewport, &Viewport::previewed, this, &ComparisonDialog::took);
  turn(m_camera);
  resize(1080, 700);
}

ComparisonDialog::~ComparisonDialog() {
  if (m_viewport)
    m_viewport->askPreviews({.previews = {}, .asker = PreviewsOf::compared});
}

QWidget* ComparisonDialog::makeGrid() {
  auto* grid = new QWidget;
  auto* layout = new QGridLayout(grid);
  layout->setHorizontalSpacing(12);
  layout->setVerticalSpacing(10);
  for (const render::TechniqueFacts& facts : render::techniqueList()) {
    if (!facts.drawsLines())
      continue;
    auto* cell = new ComparisonCell(facts.technique);
    cell->showThresholds(m_thresholds);
    connect(&cell->picture(), &ComparisonPicture::turned, this, &ComparisonDialog::turn);
    connect(cell, &ComparisonCell::thresholdChanged, this, &ComparisonDialog::setThreshold);
    const int place = int(m_cells.size());
    layout->addWidget(cell, place / columns, place % columns);
    m_cells.push_back(cell);
  }
  m_took.assign(m_cells.size(), -1);
  for (int column = 0; column < columns; ++column)
    layout->setColumnStretch(column, 1);
  auto* scroll = new QScrollArea;
  scroll->setObjectName(QStringLiteral("comparisonGrid"));
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(grid);
  return scroll;
}

QWidget* ComparisonDialog::makeBottom() {
  auto* bottom = new QWidget;
  auto* layout = new QHBoxLayout(bottom);
  layout->setContentsMargins(0, 0, 0, 0);
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
  layout->addWidget(label);
  layout->addWidget(m_surface);
  layout->addWidget(reset);
  layout->addWidget(m_told, 1);
  layout->addWidget(m_save);
  layout->addWidget(close);
  return bottom;
}

void ComparisonDialog::turn(const model::Camera& camera) {
  m_camera = camera;
  for (ComparisonCell* cell : m_cells)
    cell->picture().setCamera(camera, m_pivot);
  ++m_round;
  m_soon.start();
}

void ComparisonDialog::setThreshold(const QString& name, double value) {
  m_thresholds.set(name.toStdString(), float(value));
  ++m_round;
  m_soon.start();
}

void ComparisonDialog::resetThresholds() {
  m_thresholds = {};
  for (ComparisonCell* cell : m_cells)
    cell->showThresholds(m_thresholds);
  ++m_round;
  m_soon.start();
}

void ComparisonDialog::roughen() {
  m_shown = m_model;
  if (const int kind = m_surface->currentIndex() - 1; kind >= 0)
    m_shown = render::roughened(m_model,
                                {render::NoiseKind(kind), render::usualNoise[std::size_t(kind)]});
  ++m_round;
  m_soon.start();
}

void ComparisonDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  ++m_round;
  m_soon.start();
}

void ComparisonDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  m_soon.start();
}

void ComparisonDialog::ask() {
  if (!m_viewport || m_cells.empty() || !isVisible())
    return;
  PreviewRequest request{.previews = {}, .asker = PreviewsOf::compared};
  const double ratio = devicePixelRatioF();
  // Only pictures of one size can be compared.
  int room = m_cells.front()->picture().room();
  for (ComparisonCell* cell : m_cells)
    room = std::min(room, cell->picture().room());
  for (ComparisonCell* cell : m_cells)
    cell->picture().setSide(room);
  const int side = int(room * ratio) * comparedSamples;
  for (std::size_t i = 0; i < m_cells.size(); ++i) {
    const std::size_t place = (m_next + i) % m_cells.size();
    if (m_took[place] == m_round)
      continue;
    // A picture that high in millimetres has the pen of a sheet where the window has its own.
    const float mm = sheetPen * float(side) / float(comparedPen * ratio * comparedSamples);
    request.previews.push_back(
        {.id = m_round * mostCells + int(place),
         .scene =
             render::comparedScene(m_shown.scene, m_cells[place]->technique(), m_thresholds, mm),
         .camera = m_camera,
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
  const std::size_t place = std::size_t(id % mostCells);
  if (place >= m_cells.size() || id / mostCells < m_took[place])
    return;
  m_took[place] = id / mostCells;
  m_next = place + 1;
  m_cells[place]->picture().setImage(image);
}

bool ComparisonDialog::upToDate() const {
  return std::all_of(m_took.begin(), m_took.end(), [this](int round) { return round == m_round; });
}

render::ComparisonOrder ComparisonDialog::order() const {
  render::ComparisonOrder order;
  order.thresholds = m_thresholds;
  order.models.push_back(m_model);
  if (m_surface->currentIndex() > 0)
    order.models.push_back(m_shown);
  for (render::ComparedModel& model : order.models)
    model.camera = m_camera;
  for (const ComparisonCell* cell : m_cells)
    order.techniques.push_back(cell->technique());
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
  dialog->setNameFilters({tr("PDF (*.pdf)"), tr("SVG drawing (*.svg)"), tr("PNG picture (*.png)")});
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
