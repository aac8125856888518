// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QSettings>
#include <QStatusBar>
#include <QToolButton>
#include <utility>

#include "widgets/comparison/comparison_actions.h"
#include "widgets/export/export_actions.h"
#include "widgets/focus/focus_context.h"
#include "widgets/focus/near_tool.h"
#include "widgets/focus/subject_popup.h"
#include "widgets/form/longest_text.h"
#include "widgets/help/help_key.h"
#include "widgets/preferences/preferences_dialog.h"
#include "widgets/shell/message_bar.h"
#include "widgets/start/start_page.h"
#include "widgets/structure_tree/structure_tree.h"
#include "widgets/viewport/viewport.h"
#include "widgets/window/about_dialog.h"
#include "widgets/window/control_wheel.h"
#include "widgets/window/controls_dialog.h"
#include "widgets/window/file_actions.h"
#include "widgets/window/focus_ring.h"
#include "widgets/window/number_limits.h"
#include "widgets/window/screen_fit.h"
#include "widgets/window/undo_keys.h"

namespace sline::widgets {

namespace {

constexpr const char* geometryKey = "window/geometry";
constexpr const char* stateKey = "window/state";

QString summaryOf(const model::Scene& scene) {
  std::size_t structures = 0;
  std::size_t triangles = 0;
  bool refined = false;
  for (const model::Node& node : scene.nodes())
    if (!node.isGroup()) {
      ++structures;
      triangles += node.mesh->triangleCount();
      refined = refined || node.provenance.refinementSteps > 0;
    }
  return (refined ? MainWindow::tr("Structures: %1   Triangles: %2 (refined)")
                  : MainWindow::tr("Structures: %1   Triangles: %2"))
      .arg(QLocale().toString(qulonglong(structures)), QLocale().toString(qulonglong(triangles)));
}

}  // namespace

MainWindow::MainWindow(Session& session, QSettings& settings, QWidget* parent)
    : QMainWindow(parent),
      m_session(session),
      m_settings(settings),
      m_preferences(settings),
      m_actions(*this) {
  setObjectName(QStringLiteral("mainWindow"));
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowTabbedDocks);
  new HelpKey(this);
  new ScreenFit(this);
  new FocusRing(this);
  new ControlWheel(this);
  new NumberLimits(this);
  new LongestText(this);
  new UndoKeys(*this, m_actions);
  makeCentre();
  makeControls();
  restore();
}

MainWindow::~MainWindow() {
  // Hiding accepts a name that is being typed while its receivers still exist.
  hide();
}

void MainWindow::sizePanels() {
  const auto panel = [this](const char* name) {
    return findChild<QDockWidget*>(QLatin1String(name));
  };
  // On a small screen the picture keeps two fifths of the window.
  resizeDocks({panel("structuresPanel"), panel("gammaPanel")},
              {std::min(400, 32 * width() / 100), std::min(304, 28 * width() / 100)},
              Qt::Horizontal);
  // The Γ slider must be visible as a whole on small screens, too.
  resizeDocks({panel("gammaPanel"), panel("focusPanel")}, {3, 2}, Qt::Vertical);
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  // A window that was never laid out does not keep sizes.
  if (!std::exchange(m_sized, true))
    QMetaObject::invokeMethod(this, &MainWindow::sizePanels, Qt::QueuedConnection);
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    remakeControls();
  QMainWindow::changeEvent(event);
}

void MainWindow::jobShown(bool running) {
  for (QWidget* widget : {static_cast<QWidget*>(m_job), static_cast<QWidget*>(m_progress),
                          static_cast<QWidget*>(m_cancel)})
    widget->setVisible(running);
  // The bar is busy until the job reports its progress.
  m_progress->setRange(0, 0);
}

void MainWindow::showStart() {
  const bool wanted = m_session.document().opening == 0 && !m_session.busy();
  if (wanted == m_start->isVisibleTo(this))
    return;
  m_start->setVisible(wanted);
  // Help and Tab begin with what is seen.
  (wanted ? static_cast<QWidget*>(m_start) : m_viewport)->setFocus();
  placeMessage(wanted);
}

void MainWindow::placeMessage(bool onStartPage) {
  // A message must not lie beneath the page.
  if (onStartPage)
    m_start->messagePlace().addWidget(m_message);
  else
    static_cast<QGridLayout*>(centralWidget()->layout())->addWidget(m_message, 0, 0);
}

void MainWindow::refuse(const Error& error) {
  m_refused = error;
  m_message->showError(error);
}

void MainWindow::connectSession() {
  connect(&m_session, &Session::documentChanged, this,
          [this](const Document& before, const Document& now) {
            // What was said of another document, or of opening it, is not so of this one.
            if (before.opening != now.opening)
              m_message->hide();
            // Of what has changed since, something else may be so.
            if (const auto error = std::exchange(m_refused, std::nullopt))
              m_message->hideError(*error);
            documentChange(before, now);
          });
  connect(&m_session, &Session::failed, this, [this](const Error& error) {
    // What tells of no file is an edit that was refused.
    error.file.empty() ? refuse(error) : m_message->showError(error);
  });
  connect(&m_session, &Session::remarked, this, [this](const QStringList& remarks) {
    m_remarkedAt = m_session.history().index();
    m_message->showRemarks(remarks);
  });
  connect(&m_session.history(), &QUndoStack::indexChanged, this, [this](int at) {
    if (at < m_remarkedAt)
      m_message->hideRemarks();
  });
  connect(&m_session, &Session::jobStarted, this, [this](const QString& title) {
    m_message->hide();
    m_job->setText(tr("Opening %1").arg(title));
    jobShown(true);
    showStart();
  });
  connect(&m_session, &Session::jobProgressed, this, [this](double done, const QString& what) {
    m_progress->setRange(0, 1000);
    m_progress->setValue(int(1000.0 * done));
    m_progress->setToolTip(what);
  });
  connect(&m_session, &Session::jobEnded, this, [this] {
    jobShown(false);
    showStart();
  });
  QUndoStack& history = m_session.history();
  const auto name = [](QAction& action, const QString& text, const QString& step) {
    // The status tip is what the action's row says.
    const QString& tip = action.statusTip();
    action.setText(step.isEmpty() ? text : text + QLatin1Char(' ') + step);
    action.setToolTip(step.isEmpty() ? tip : tip + QStringLiteral(": ") + step);
    action.setIconText(QString(text).remove(QLatin1Char('&')));
    action.setEnabled(!step.isEmpty());
  };
  QAction& undo = m_actions[QStringLiteral("undo")];
  QAction& redo = m_actions[QStringLiteral("redo")];
  const auto nameUndo = [=, &undo](const QString& s) { name(undo, tr("&Undo"), s); };
  const auto nameRedo = [=, &redo](const QString& s) { name(redo, tr("&Redo"), s); };
  connect(&history, &QUndoStack::undoTextChanged, this, nameUndo);
  connect(&history, &QUndoStack::redoTextChanged, this, nameRedo);
  nameUndo(history.undoText());
  nameRedo(history.redoText());
}

float MainWindow::pictureAspect() const {
  return float(m_viewport->width()) / float(std::max(m_viewport->height(), 1));
}

void MainWindow::connectActions() {
  const auto on = [this](const char* id, auto function) {
    connect(&m_actions[QLatin1String(id)], &QAction::triggered, this, function);
  };
  on("undo", [this] { m_session.undo(); });
  on("redo", [this] { m_session.redo(); });
  on("find", [this] {
    findChild<QDockWidget*>(QStringLiteral("structuresPanel"))->raise();
    m_tree->find();
  });
  on("focus", [this] { m_focus->focusOn(m_session.selection()); });
  on("focusNear", [this] {
    if (m_session.selection().empty())
      m_nearness->setPlacing(true);
    else
      m_nearness->focusOn(m_session.selection());
  });
  on("focusPlace", [this] { m_nearness->setPlacing(true); });
  on("plate", [this] { m_focus->chooseLook(pictureAspect(), 0); });
  on("anotherSubject", [this] { m_focus->chooseLook(pictureAspect(), m_focus->subject() + 1); });
  on("subjects", [this] { (new SubjectPopup(m_session, *m_focus, *m_viewport))->open(); });
  on("fit", [this] { m_viewport->fitAll(); });
  on("panels", [this] { m_hiddenPanels.toggle(*this); });
  on("help", [this] { showHelp(); });
  on("controls",
     [this] { (new ControlsDialog(controlRows(m_viewport->mousePreset()), this))->open(); });
  on("preferences", [this] { (new PreferencesDialog(m_preferences, this))->open(); });
  on("about", [this] { (new AboutDialog(m_viewport->driver(), this))->open(); });
}

void MainWindow::connectViews() {
  for (std::size_t i = 0; i < model::anatomicalViewNames.size(); ++i) {
    const std::string_view id = model::anatomicalViewNames[i];
    QAction& action = m_actions[QLatin1String(id.data(), qsizetype(id.size()))];
    action.setIconText(action.shortcut().toString());
    connect(&action, &QAction::triggered, this,
            [this, i] { m_viewport->showFrom(model::AnatomicalView(i)); });
  }
  connect(m_viewport, &Viewport::failed, m_message, &MessageBar::showError);
  connect(m_viewport, &Viewport::mended, m_message, &MessageBar::hideError);
  connect(m_viewport, &Viewport::pivotChosen, this, [this](const QString& structure) {
    constexpr int readable = 4000;  // milliseconds
    statusBar()->showMessage(tr("Turning around this place on %1").arg(structure), readable);
  });
}

void MainWindow::showHelp() {
  QWidget* focus = QApplication::focusWidget();
  HelpKey::showHelp(focus && focus->window() == this ? *focus : *this);
}

void MainWindow::restore() {
  resize(1360, 860);
  restoreGeometry(m_settings.value(QLatin1String(geometryKey)).toByteArray());
  m_sized = restoreState(m_settings.value(QLatin1String(stateKey)).toByteArray());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!m_exports->mayClose() || !m_files->mayClose()) {
    event->ignore();
    return;
  }
  m_files->letGo();
  m_settings.setValue(QLatin1String(geometryKey), saveGeometry());
  m_settings.setValue(QLatin1String(stateKey), saveState());
  m_session.cancelJob();
  QMainWindow::closeEvent(event);
}

void MainWindow::documentChange(const Document& before, const Document& now) {
  if (before.opening != now.opening || now.opening == 0) {
    m_summary->setText(now.opening == 0 ? QString() : summaryOf(now.scene));
    showStart();
  }
  updateActions();
}

void MainWindow::updateActions() {
  m_actions[QStringLiteral("reload")].setEnabled(m_session.canReload());
}

}  // namespace sline::widgets

#include "moc_main_window.cpp"
