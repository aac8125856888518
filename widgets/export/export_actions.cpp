// SPDX-License-Identifier: Apache-2.0
#include "widgets/export/export_actions.h"

#include <QAction>
#include <QDesktopServices>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QMainWindow>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QStatusBar>
#include <QToolButton>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "render/export/order/view_orders.h"
#include "widgets/export/export_job.h"
#include "widgets/export/export_texts.h"
#include "widgets/export/note_texts.h"
#include "widgets/export/page_presets.h"
#include "widgets/export/picture_copier.h"
#include "widgets/export/print_proof_dialog.h"
#include "widgets/shell/message_bar.h"
#include "widgets/shell/window_actions.h"
#include "widgets/text/path_text.h"
#include "widgets/viewport/viewport.h"

namespace sline::widgets {

namespace {

constexpr const char* exportFolderKey = "export/folder";
constexpr const char* widthKey = "export/width";

QString nameOf(const render::ExportPiece& file) {
  return textOf(file.target.filename());
}

}  // namespace

ExportActions::ExportActions(const Context& context, QMainWindow& window)
    : QObject(&window),
      m_session(context.session),
      m_settings(context.settings),
      m_actions(context.actions),
      m_message(context.message),
      m_viewport(context.viewport),
      m_window(window),
      m_copier(new PictureCopier(context.viewport, this)) {
  connect(m_copier, &PictureCopier::copied, this, [this] {
    constexpr int readable = 4000;  // milliseconds
    m_window.statusBar()->showMessage(tr("The picture is on the clipboard"), readable);
  });
  connect(&m_session, &Session::documentChanged, this,
          [this](const Document& before, const Document& now) {
            showState();
            // What was exported is no longer what is open.
            if (before.opening != now.opening)
              m_message.hideDone();
          });
  connectActions();
}

ExportActions::~ExportActions() = default;

void ExportActions::connectActions() {
  connect(&m_actions[QStringLiteral("export")], &QAction::triggered, this,
          &ExportActions::showDialog);
  connect(&m_actions[QStringLiteral("copyPicture")], &QAction::triggered, this,
          &ExportActions::copyPicture);
  connect(&m_actions[QStringLiteral("printProof")], &QAction::triggered, this,
          &ExportActions::showProof);
  showState();
}

void ExportActions::controlsRemade() {
  connectActions();
  if (m_job)
    showProgress();
}

void ExportActions::showState() {
  QAction& action = m_actions[QStringLiteral("export")];
  const auto& nodes = m_session.scene().nodes();
  const bool any = std::any_of(nodes.begin(), nodes.end(),
                               [](const model::Node& node) { return !node.isGroup(); });
  action.setEnabled(any && !m_job);
  m_actions[QStringLiteral("copyPicture")].setEnabled(any);
  m_actions[QStringLiteral("printProof")].setEnabled(any);
}

ExportSource ExportActions::source() const {
  return {.scene = m_session.sceneBeforePreview(),
          .camera = m_viewport.camera(),
          .aspect = float(m_viewport.width()) / float(std::max(1, m_viewport.height())),
          .keyLight = m_viewport.keyLight(),
          .title = m_session.title(),
          .seen = seen()};
}

render::ExportOrder ExportActions::seen() const {
  render::ExportOrder order;
  order.environment = m_viewport.environment();
  order.labels = m_viewport.labels().style();
  order.marks.scaleBar = m_viewport.marks().scaleBar;
  return order;
}

void ExportActions::copyPicture() {
  ExportDraft draft = rememberedDraft(m_settings, {});
  follow(draft, draft.order, seen());
  m_copier->copy(source(), draft.order);
}

void ExportActions::showProof() {
  const ExportSource seen = source();
  render::ExportOrder order;
  order.scene = seen.scene;
  order.camera = seen.camera;
  order.page.sizeMm = render::usualHeightMm * glm::vec2(seen.aspect, 1.0f);
  order.environment.background = render::Background::white;
  order.environment.keyLight = seen.keyLight;
  order.labels.mode = render::LabelMode::off;
  order.marks = render::ExportMarks::none();
  auto* dialog = new PrintProofDialog(std::move(order), m_session.names(), m_viewport, &m_window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PrintProofDialog::changesWanted, this,
          [this](const std::vector<render::ProofProposal>& proposals) {
            m_session.apply(tr("Print proof"),
                            {render::withProposals(m_session.scene(), proposals), true});
          });
  dialog->open();
}

void ExportActions::prepareDraft() {
  const int opening = m_session.document().opening;
  const render::ExportOrder before = std::exchange(m_seen, seen());
  if (m_prepared == opening) {
    follow(m_draft, before, m_seen);
    return;
  }
  m_prepared = opening;
  m_draft = rememberedDraft(m_settings, m_seen);
  if (!m_settings.contains(QLatin1String(widthKey))) {
    // The first export gets a common paper, turned like the picture in the window.
    const std::vector<PagePreset> papers = pagePresets();
    const auto a4 = std::find_if(papers.begin(), papers.end(), [](const PagePreset& each) {
      return each.id == QLatin1String("a4");
    });
    m_draft.order.page.sizeMm =
        turnedAs(a4->sizeMm, {float(m_viewport.width()), float(m_viewport.height())});
  }
  QString folder = m_settings.value(QLatin1String(exportFolderKey)).toString();
  const std::filesystem::path& file = m_session.file().path;
  if (folder.isEmpty() || !QFileInfo(folder).isDir())
    folder = file.empty() ? QDir::homePath() : textOf(file.parent_path());
  const QString name =
      QString::fromStdString(render::safeFileName(m_session.publicTitle().toStdString()));
  m_draft.target = withEndingOf(QDir(folder).filePath(name), m_draft.kind);
}

void ExportActions::showDialog() {
  if (m_dialog) {
    m_dialog->raise();
    m_dialog->activateWindow();
    return;
  }
  prepareDraft();
  m_dialog = new ExportDialog(m_draft, source(), m_viewport, &m_window);
  m_dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(m_dialog, &ExportDialog::exportWanted, this, &ExportActions::begin);
  connect(m_dialog, &QDialog::finished, this, [this] { remember(m_draft, m_seen, m_settings); });
  m_dialog->open();
}

void ExportActions::begin(const QString& kind, const std::vector<render::ExportPiece>& files) {
  const render::ExportFormat* format = formatOf(kind);
  if (m_job || !format || files.empty())
    return;
  m_message.hide();
  m_job = std::make_unique<ExportJob>(*format, files);
  showProgress();
  showState();
  connect(m_job.get(), &ExportJob::progressed, this, [this](double share, const QString& what) {
    if (!m_progress)
      return;
    m_progress->setRange(0, 1000);
    m_progress->setValue(int(1000.0 * share));
    m_progress->setToolTip(what);
  });
  connect(m_job.get(), &ExportJob::done, this, [this] {
    const std::vector<render::ExportPiece> written = m_job->files();
    const render::ExportNotes notes = m_job->notes();
    end();
    tellDone(written, notes);
  });
  connect(m_job.get(), &ExportJob::failed, this, [this](const Error& error) {
    end();
    m_message.showError(error);
  });
  connect(m_job.get(), &ExportJob::cancelled, this, [this] {
    end();
    constexpr int readable = 4000;  // milliseconds
    m_window.statusBar()->showMessage(tr("The export was stopped"), readable);
  });
  m_job->start();
}

void ExportActions::showProgress() {
  const std::vector<render::ExportPiece>& files = m_job->files();
  const QString text = files.size() == 1 ? tr("Exporting %1").arg(nameOf(files.front()))
                                         : tr("Exporting %n files", nullptr, int(files.size()));
  m_what = new QLabel(text);
  m_what->setObjectName(QStringLiteral("exportText"));
  m_what->setTextFormat(Qt::PlainText);
  m_progress = new QProgressBar;
  m_progress->setObjectName(QStringLiteral("exportProgress"));
  m_progress->setAccessibleName(text);
  m_progress->setTextVisible(false);
  m_progress->setRange(0, 0);  // until the writer reports its progress
  m_progress->setFixedWidth(160);
  m_cancel = new QToolButton;
  m_cancel->setObjectName(QStringLiteral("exportCancel"));
  m_cancel->setText(tr("Cancel"));
  connect(m_cancel, &QToolButton::clicked, this, [this] {
    m_cancel->setEnabled(false);
    m_job->cancel();
  });
  int place = 0;
  for (QWidget* widget : {static_cast<QWidget*>(m_what), static_cast<QWidget*>(m_progress),
                          static_cast<QWidget*>(m_cancel)})
    m_window.statusBar()->insertPermanentWidget(place++, widget);
}

void ExportActions::end() {
  // The job itself is the caller, so it must not be deleted at once.
  m_job.release()->deleteLater();
  delete m_what;
  delete m_progress;
  if (m_cancel)
    m_cancel->deleteLater();
  m_cancel = nullptr;
  showState();
  if (m_closing)
    QMetaObject::invokeMethod(this, &ExportActions::closeNow, Qt::QueuedConnection);
}

bool ExportActions::mayClose() {
  if (!m_job)
    return true;
  auto* box = new QMessageBox(&m_window);
  box->setObjectName(QStringLiteral("exportingDialog"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setText(tr("An export is under way. Stop it and close the window?"));
  QPushButton* stop = box->addButton(tr("Stop and Close"), QMessageBox::AcceptRole);
  stop->setObjectName(QStringLiteral("stopExport"));
  box->setDefaultButton(box->addButton(tr("Go On"), QMessageBox::RejectRole));
  connect(box, &QDialog::finished, this, [this, box, stop] {
    if (box->clickedButton() != stop)
      return;
    m_closing = true;
    m_job ? m_job->cancel() : closeNow();
  });
  box->open();
  return false;
}

void ExportActions::closeNow() {
  if (std::exchange(m_closing, false))
    m_window.close();
}

void ExportActions::tellDone(const std::vector<render::ExportPiece>& files,
                             const render::ExportNotes& notes) {
  m_offers = std::make_unique<QObject>();
  const QString first = textOf(files.front().target);
  const auto offer = [this](const QString& text, const QString& tip, const QString& path) {
    auto* action = new QAction(text, m_offers.get());
    action->setToolTip(tip);
    connect(action, &QAction::triggered, this,
            [path] { QDesktopServices::openUrl(QUrl::fromLocalFile(path)); });
    return action;
  };
  QList<QAction*> offers;
  if (files.size() == 1)
    offers << offer(tr("Open"), tr("With the program that this system has for it"), first);
  offers << offer(tr("Show Folder"), tr("Where it was written to"),
                  QFileInfo(first).absolutePath());
  m_message.showDone(files.size() == 1 ? tr("Exported %1").arg(nameOf(files.front()))
                                       : tr("Exported %n files", nullptr, int(files.size())),
                     QDir::toNativeSeparators(QFileInfo(first).absolutePath()), offers,
                     noteTexts(notes));
}

}  // namespace sline::widgets

#include "moc_export_actions.cpp"
