// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/print_proof_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "widgets/export/straight_image.h"
#include "widgets/text/told.h"

namespace sline::widgets {

namespace {

constexpr int pictureWidth = 460;
constexpr int proofSamples = 2;

render::ProofSettings settingsOf(bool all) {
  return {.all = all};
}

QString textOf(render::Vision vision) {
  switch (vision) {
    case render::Vision::grey:
      return PrintProofDialog::tr("in grey");
    case render::Vision::protanopia:
      return PrintProofDialog::tr("with protanopia");
    case render::Vision::deuteranopia:
      return PrintProofDialog::tr("with deuteranopia");
    case render::Vision::tritanopia:
      return PrintProofDialog::tr("with tritanopia");
    case render::Vision::normal:
      break;
  }
  return PrintProofDialog::tr("on the screen");
}

bool listed(const render::ProofPair& pair, const render::ProofSettings& settings) {
  return pair.alikeAnywhere(settings) && (settings.all || !pair.alikeOnScreen(settings));
}

QTreeWidget* table(const char* name, const QString& title, const QStringList& columns) {
  auto* made = new QTreeWidget;
  made->setObjectName(QLatin1String(name));
  made->setAccessibleName(title);
  made->setRootIsDecorated(false);
  made->setUniformRowHeights(true);
  made->setHeaderLabels(columns);
  made->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  made->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  made->header()->setStretchLastSection(false);
  return made;
}

QIcon swatch(const Colour& colour) {
  QPixmap pixmap(16, 16);
  pixmap.fill(QColor(colour.red, colour.green, colour.blue));
  return pixmap;
}

/// Returns the picture as those eyes see it, or as the press prints it.
QImage seenAs(const QImage& picture, render::Vision vision) {
  const render::Image image = render::simulateVision(straightImage(picture), vision);
  return QImage(image.rgba.data(), image.width, image.height, qsizetype(4) * image.width,
                QImage::Format_RGBA8888)
      .copy();
}

}  // namespace

PrintProofDialog::PrintProofDialog(render::ExportOrder order, const DisplayNames& names,
                                   Viewport& viewport, QWidget* parent)
    : QDialog(parent),
      m_order(std::move(order)),
      m_names(names),
      m_viewport(&viewport),
      m_told(new QLabel),
      m_pairs(table("proofPairs", tr("Neighbours that look alike"),
                    {tr("Neighbours"), tr("Look alike")})),
      m_changes(table("proofChanges", tr("What would help"), {tr("What would help"), tr("New")})),
      m_all(new QCheckBox(tr("&Also what looks alike on the screen"))),
      m_picture(new QLabel),
      m_vision(new QComboBox),
      m_changed(new QCheckBox(tr("&With the changes"))),
      m_apply(new QPushButton(tr("Make the &Changes"))) {
  setObjectName(QStringLiteral("printProofDialog"));
  setWindowTitle(tr("Print Proof"));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(18);
  columns->addWidget(makeFindings(), 1);
  columns->addWidget(makePreviewColumn());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 14);
  layout->addLayout(columns, 1);
  layout->addWidget(makeButtons());
  connect(&viewport, &Viewport::previewed, this,
          [this](PreviewsOf asker, int number, const QImage& image) {
            if (asker != PreviewsOf::exported || number / 2 != m_asked)
              return;
            m_pictures[std::size_t(number % 2)] = image;
            showPicture();
          });
  startProof();
  resize(1000, 620);
}

PrintProofDialog::~PrintProofDialog() {
  m_queue.drop();
  if (m_viewport)
    m_viewport->askPreviews({.previews = {}, .asker = PreviewsOf::exported});
}

QWidget* PrintProofDialog::makeFindings() {
  auto* column = new QWidget;
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  m_told->setObjectName(QStringLiteral("proofTold"));
  m_told->setTextFormat(Qt::PlainText);
  m_told->setWordWrap(true);
  m_all->setObjectName(QStringLiteral("proofAll"));
  m_all->setToolTip(tr("Which may be meant: both kidneys have one colour"));
  connect(m_all, &QCheckBox::toggled, this, &PrintProofDialog::startProof);
  layout->addWidget(m_told);
  layout->addWidget(m_pairs, 3);
  layout->addWidget(m_all);
  layout->addWidget(m_changes, 2);
  return column;
}

QWidget* PrintProofDialog::makePreviewColumn() {
  auto* column = new QWidget;
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  m_vision->setObjectName(QStringLiteral("proofVision"));
  m_vision->setAccessibleName(tr("As it is seen"));
  for (const render::Vision vision : render::visions)
    m_vision->addItem(tr("Seen %1").arg(textOf(vision)), int(vision));
  m_vision->setCurrentIndex(int(render::Vision::grey));
  m_changed->setObjectName(QStringLiteral("proofChanged"));
  m_picture->setObjectName(QStringLiteral("proofPicture"));
  m_picture->setAccessibleName(tr("Preview"));
  m_picture->setFixedSize(pictureWidth, pictureWidth);
  m_picture->setAlignment(Qt::AlignCenter);
  connect(m_vision, &QComboBox::currentIndexChanged, this, &PrintProofDialog::showPicture);
  connect(m_changed, &QCheckBox::toggled, this, &PrintProofDialog::showPicture);
  layout->addWidget(m_vision);
  layout->addWidget(m_picture, 1);
  layout->addWidget(m_changed);
  return column;
}

QWidget* PrintProofDialog::makeButtons() {
  auto* buttons = new QDialogButtonBox;
  m_apply->setObjectName(QStringLiteral("proofApply"));
  buttons->addButton(m_apply, QDialogButtonBox::AcceptRole);
  QPushButton* close = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
  close->setObjectName(QStringLiteral("proofClose"));
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  connect(m_apply, &QPushButton::clicked, this, [this] {
    const std::vector<render::ProofProposal> proposals = m_proof->proposals;
    accept();
    emit changesWanted(proposals);
  });
  return buttons;
}

void PrintProofDialog::startProof() {
  ++m_asked;
  m_proof.reset();
  m_pictures = {};
  m_told->setText(tr("Looking at the picture…"));
  showFindings();
  m_queue.drop();
  m_queue.add([this, order = m_order, settings = settingsOf(m_all->isChecked()),
               asked = m_asked](const std::stop_token& stop) {
    auto proof = render::printProof(
        order, settings, [&stop](double, std::string_view) { return !stop.stop_requested(); });
    return BackgroundQueue::Sequel([this, asked, proof = std::move(proof)] {
      if (asked == m_asked)
        took(proof);
    });
  });
}

void PrintProofDialog::took(const Result<render::PrintProof>& proof) {
  if (!proof.ok()) {
    m_told->setText(told(proof.error().text()));
    return;
  }
  m_proof = *proof;
  const render::ProofSettings settings = settingsOf(m_all->isChecked());
  int found = 0;
  int left = 0;
  for (const render::ProofPair& pair : m_proof->neighbours)
    found += listed(pair, settings) ? 1 : 0;
  for (const render::ProofPair& pair : m_proof->afterwards)
    left += listed(pair, settings) ? 1 : 0;
  QString told = found == 0 ? tr("All neighbours can be told apart in grey and by all eyes.")
                            : tr("%n pairs of neighbours look alike in print or to some eyes.",
                                 nullptr, found);
  if (left > 0)
    told += QLatin1Char(' ') + tr("For %n of them no change was found.", nullptr, left);
  m_told->setText(told);
  showFindings();
  askPictures();
}

void PrintProofDialog::showFindings() {
  m_pairs->clear();
  const render::ProofSettings settings = settingsOf(m_all->isChecked());
  const auto nameOf = [this](model::NodeId id) {
    return m_names.shown(m_order.scene.find(id)->name);
  };
  if (m_proof)
    for (const render::ProofPair& pair : m_proof->neighbours) {
      if (!listed(pair, settings))
        continue;
      QStringList where;
      for (const render::Vision vision : render::visions)
        if (pair.alike(vision, settings))
          where << textOf(vision);
      new QTreeWidgetItem(m_pairs, {tr("%1 and %2").arg(nameOf(pair.a), nameOf(pair.b)),
                                    where.join(QStringLiteral(", "))});
    }
  showProposals();
}

void PrintProofDialog::showProposals() {
  m_changes->clear();
  if (m_proof)
    for (const render::ProofProposal& proposal : m_proof->proposals) {
      auto* item = new QTreeWidgetItem(m_changes);
      item->setText(0, m_names.shown(m_order.scene.find(proposal.node)->name));
      item->setIcon(0, swatch(m_order.scene.resolve(proposal.node).colour));
      QStringList change;
      if (proposal.colour) {
        item->setIcon(1, swatch(*proposal.colour));
        change << tr("colour");
      }
      if (proposal.gamma)
        change << tr("Γ %1").arg(QLocale().toString(double(proposal.gamma->value()), 'f', 2));
      item->setText(1, change.join(QStringLiteral(", ")));
    }
  const bool any = m_proof && !m_proof->proposals.empty();
  m_apply->setEnabled(any);
  m_changed->setEnabled(any);
  if (!any)
    m_changed->setChecked(false);
}

void PrintProofDialog::askPictures() {
  const float aspect = m_order.page.sizeMm.x / m_order.page.sizeMm.y;
  const int width = int(pictureWidth * std::min(1.0f, aspect) * float(devicePixelRatioF()));
  PreviewRequest request{.previews = {}, .asker = PreviewsOf::exported};
  for (int changed = 0; changed < (m_proof->proposals.empty() ? 1 : 2); ++changed)
    request.previews.push_back(
        {.id = 2 * m_asked + changed,
         .scene = changed == 1 ? m_proof->proposed : m_order.scene,
         .camera = m_order.camera,
         .settings = {.width = proofSamples * std::max(width, 16),
                      .height = proofSamples * std::max(int(float(width) / aspect), 16),
                      .environment = m_order.environment},
         .samples = proofSamples});
  if (m_viewport)
    m_viewport->askPreviews(std::move(request));
}

void PrintProofDialog::showPicture() {
  const QImage& picture = m_pictures[m_changed->isChecked() ? 1 : 0];
  if (picture.isNull()) {
    m_picture->setText(tr("Drawing…"));
    return;
  }
  const auto vision = render::Vision(m_vision->currentData().toInt());
  QPixmap shown = QPixmap::fromImage(seenAs(picture, vision));
  shown.setDevicePixelRatio(devicePixelRatioF());
  m_picture->setPixmap(shown);
}

}  // namespace sline::widgets

#include "moc_print_proof_dialog.cpp"
