// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMimeData>
#include <QProgressBar>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QUndoView>
#include <algorithm>
#include <array>

#include "model/edit/emphasis.h"
#include "model/edit/tree.h"
#include "model/edit/visibility.h"
#include "model/import/file_kinds.h"
#include "widgets/gamma/gamma_panel.h"
#include "widgets/gamma/stage_strip.h"
#include "widgets/preferences/preferences_dialog.h"
#include "widgets/session/demo_scenes.h"
#include "widgets/structure_tree/structure_tree.h"
#include "widgets/structure_tree/structure_tree_view.h"
#include "widgets/viewport/stage_previews.h"
#include "widgets/viewport/viewport.h"
#include "widgets/window/about_dialog.h"
#include "widgets/window/controls_dialog.h"
#include "widgets/window/message_bar.h"
#include "widgets/window/section_actions.h"
#include "widgets/window/view_actions.h"

namespace sline::widgets {

namespace {

constexpr const char* geometryKey = "window/geometry";
constexpr const char* stateKey = "window/state";
constexpr const char* backgroundKey = "picture/background";
constexpr const char* folderKey = "files/folder";

QDockWidget* dock(const QString& title, const char* name, QWidget* content) {
  auto* panel = new QDockWidget(title);
  panel->setObjectName(QLatin1String(name));
  panel->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
  panel->setWidget(content);
  return panel;
}

render::Background backgroundOf(const QString& choice) {
  return choice == QLatin1String("dark")    ? render::Background::dark
         : choice == QLatin1String("paper") ? render::Background::paper
                                            : render::Background::white;
}

/// The small pictures beside the Γ slider come from the picture's renderer.
void connectPreviews(Session& session, Viewport& viewport, StageStrip& stages) {
  auto* previews = new StagePreviews(session, viewport, &stages);
  QObject::connect(&stages, &StageStrip::picturesWanted, previews,
                   [previews, &stages](QSize size, double ratio) {
                     previews->want(stages.pictured(), size, ratio);
                   });
  QObject::connect(previews, &StagePreviews::made, &stages, &StageStrip::showPicture);
  QObject::connect(previews, &StagePreviews::cleared, &stages, &StageStrip::clearPictures);
}

QString summaryOf(const model::Scene& scene) {
  std::size_t structures = 0;
  std::size_t triangles = 0;
  for (const model::Node& node : scene.nodes())
    if (!node.isGroup()) {
      ++structures;
      triangles += node.mesh->triangleCount();
    }
  return MainWindow::tr("Structures: %1   Triangles: %2")
      .arg(QLocale().toString(qulonglong(structures)), QLocale().toString(qulonglong(triangles)));
}

bool hasLocalFiles(const QMimeData& data) {
  const QList<QUrl> urls = data.urls();
  return std::any_of(urls.begin(), urls.end(), [](const QUrl& url) { return url.isLocalFile(); });
}

/// "*.sline *.mrml *.obj …", for a file dialog.
QString readablePatterns() {
  QStringList patterns{QStringLiteral("*.sline"), QStringLiteral("*.mrml"), QStringLiteral("*.mrb"),
                       QStringLiteral("*.fcsv"), QStringLiteral("*.mrk.json")};
  for (const model::FileKind& kind : model::fileKinds())
    patterns << QStringLiteral("*") +
                    QString::fromUtf8(kind.extension.data(), qsizetype(kind.extension.size()));
  return patterns.join(QLatin1Char(' '));
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
  makeCentre();
  makePanels();
  makeStatus();
  makeMenus();
  makeTools();
  connectSession();
  connectActions();
  connectViews();
  restore();
  documentChange({}, session.document());
}

MainWindow::~MainWindow() = default;

void MainWindow::makeCentre() {
  m_message = new MessageBar;
  m_viewport = new Viewport(m_session);
  auto* centre = new QWidget;
  auto* layout = new QGridLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  // A message lies over the picture's upper edge: pushing it down would draw it anew.
  layout->addWidget(m_viewport, 0, 0);
  layout->addWidget(m_message, 0, 0, Qt::AlignTop);
  m_message->raise();
  setCentralWidget(centre);
}

void MainWindow::makePanels() {
  m_tree = new StructureTree(m_session);
  m_gamma = new GammaPanel(m_session, m_settings);
  addDockWidget(Qt::LeftDockWidgetArea, dock(tr("Structures"), "structuresPanel", m_tree));
  addDockWidget(Qt::RightDockWidgetArea, dock(tr("Line Style"), "gammaPanel", m_gamma));
  auto* history = new QUndoView(&m_session.history());
  history->setObjectName(QStringLiteral("history"));
  history->setAccessibleName(tr("History"));
  history->setEmptyLabel(tr("As opened"));
  QDockWidget* steps = dock(tr("History"), "historyPanel", history);
  addDockWidget(Qt::RightDockWidgetArea, steps);
  steps->hide();
  resizeDocks({findChild<QDockWidget*>(QStringLiteral("structuresPanel")),
               findChild<QDockWidget*>(QStringLiteral("gammaPanel"))},
              {380, 250}, Qt::Horizontal);
}

void MainWindow::makeStatus() {
  m_summary = new QLabel;
  m_summary->setObjectName(QStringLiteral("summary"));
  m_job = new QLabel;
  m_job->setObjectName(QStringLiteral("jobText"));
  m_progress = new QProgressBar;
  m_progress->setObjectName(QStringLiteral("progress"));
  m_progress->setAccessibleName(tr("Progress"));
  m_progress->setFixedWidth(180);
  m_progress->setTextVisible(false);
  m_cancel = new QToolButton;
  m_cancel->setObjectName(QStringLiteral("cancel"));
  m_cancel->setText(tr("Cancel"));
  connect(m_cancel, &QToolButton::clicked, this, [this] { m_session.cancelJob(); });
  statusBar()->addPermanentWidget(m_job);
  statusBar()->addPermanentWidget(m_progress);
  statusBar()->addPermanentWidget(m_cancel);
  statusBar()->addPermanentWidget(m_summary);
  jobShown(false);
}

void MainWindow::jobShown(bool running) {
  for (QWidget* widget : {static_cast<QWidget*>(m_job), static_cast<QWidget*>(m_progress),
                          static_cast<QWidget*>(m_cancel)})
    widget->setVisible(running);
  m_progress->setRange(0, 0);  // busy, until the job says how far it is
}

void MainWindow::makeMenus() {
  m_menus.emplace(*this, m_actions);
  const WindowMenus& menus = *m_menus;
  for (const DemoScene& demo : demoScenes()) {
    QAction* action = menus[QStringLiteral("demoMenu")].addAction(demo.title);
    action->setObjectName(QStringLiteral("demo-") + demo.id);
    connect(action, &QAction::triggered, this,
            [this, demo] { m_session.openMade(demo.title, demo.make); });
  }
  for (QAction* action : menus[QStringLiteral("structureMenu")].actions())
    m_tree->view().addAction(action);
  m_views = new ViewActions(m_session, *m_viewport, m_settings, m_actions,
                            menus[QStringLiteral("savedViews")]);
  m_sections = new SectionActions(m_session, *m_viewport, m_actions, this);
  for (QDockWidget* panel : findChildren<QDockWidget*>())
    menus[QStringLiteral("panelMenu")].addAction(panel->toggleViewAction());
  makeBackgrounds(menus[QStringLiteral("backgroundMenu")]);
}

void MainWindow::makeBackgrounds(QMenu& menu) {
  const QString id = QLatin1String(backgroundKey);
  const std::vector<PreferenceRow> rows = preferenceRows();
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&id](const PreferenceRow& each) { return each.id == id; });
  auto* group = new QActionGroup(&menu);
  for (const ChoiceOf::Row& choice : std::get<ChoiceOf>(row->kind).rows) {
    QAction* action = menu.addAction(choice.text);
    action->setObjectName(QStringLiteral("background-") + choice.id);
    action->setCheckable(true);
    group->addAction(action);
    connect(action, &QAction::triggered, this,
            [this, id, chosen = choice.id] { m_preferences.set(id, chosen); });
  }
  const auto follow = [this, id, group] {
    const QString chosen = m_preferences.choice(id);
    for (QAction* action : group->actions())
      action->setChecked(action->objectName() == QStringLiteral("background-") + chosen);
    m_viewport->setBackground(backgroundOf(chosen));
  };
  connect(&m_preferences, &Preferences::changed, group, follow);
  follow();
}

void MainWindow::makeTools() {
  QToolBar* tools = makeToolBar(*this, m_actions);
  const auto follow = [this, tools] {
    tools->setToolButtonStyle(m_preferences.isOn(QStringLiteral("appearance/toolTexts"))
                                  ? Qt::ToolButtonTextUnderIcon
                                  : Qt::ToolButtonIconOnly);
  };
  connect(&m_preferences, &Preferences::changed, tools, follow);
  follow();
}

void MainWindow::connectSession() {
  connect(&m_session, &Session::documentChanged, this, &MainWindow::documentChange);
  connect(&m_session, &Session::selectionChanged, this, &MainWindow::updateActions);
  connect(&m_session, &Session::failed, m_message, &MessageBar::showError);
  connect(&m_session, &Session::remarked, m_message, &MessageBar::showRemarks);
  connect(&m_session, &Session::jobStarted, this, [this](const QString& title) {
    m_message->hide();
    m_job->setText(tr("Opening %1").arg(title));
    jobShown(true);
  });
  connect(&m_session, &Session::jobProgressed, this, [this](double done, const QString& what) {
    m_progress->setRange(0, 1000);
    m_progress->setValue(int(1000.0 * done));
    m_progress->setToolTip(what);
  });
  connect(&m_session, &Session::jobEnded, this, [this] { jobShown(false); });
  QUndoStack& history = m_session.history();
  const auto name = [](QAction& action, const QString& text, const QString& step) {
    action.setText(step.isEmpty() ? text : text + QLatin1Char(' ') + step);
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

void MainWindow::connectActions() {
  const auto on = [this](const char* id, auto function) {
    connect(&m_actions[QLatin1String(id)], &QAction::triggered, this, function);
  };
  on("openFiles", [this] { chooseFiles(); });
  on("openFolder", [this] { chooseFolder(); });
  on("reload", [this] { m_session.reloadSources(); });
  on("quit", [this] { close(); });
  on("undo", [this] { m_session.undo(); });
  on("redo", [this] { m_session.redo(); });
  on("find", [this] { m_tree->find(); });
  on("focus", [this] { editSelection(tr("Focus"), model::withFocus); });
  on("context", [this] { editSelection(tr("Context"), model::withContext); });
  on("inherit", [this] { editSelection(tr("Inherit Γ"), model::withGammaInherited); });
  on("toggle", [this] { m_tree->view().toggleSelection(); });
  on("isolate", [this] { editSelection(tr("Isolate"), model::withOnlyVisible); });
  on("showAll", [this] {
    NodeIds all;
    for (const model::Node& node : m_session.scene().nodes())
      all.push_back(node.id);
    m_session.apply(tr("Show All"), model::withShown(m_session.scene(), all));
  });
  on("remove", [this] { editSelection(tr("Remove"), model::removed); });
  on("fit", [this] { m_viewport->fitAll(); });
  on("controls", [this] { (new ControlsDialog(this))->open(); });
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
  connect(m_viewport, &Viewport::pivotChosen, this, [this](const QString& structure) {
    constexpr int readable = 4000;  // milliseconds
    statusBar()->showMessage(tr("Turning around this place on %1").arg(structure), readable);
  });
  connectPreviews(m_session, *m_viewport, m_gamma->stages());
}

void MainWindow::restore() {
  resize(1360, 860);
  restoreGeometry(m_settings.value(QLatin1String(geometryKey)).toByteArray());
  restoreState(m_settings.value(QLatin1String(stateKey)).toByteArray());
}

void MainWindow::closeEvent(QCloseEvent* event) {
  m_settings.setValue(QLatin1String(geometryKey), saveGeometry());
  m_settings.setValue(QLatin1String(stateKey), saveState());
  m_session.cancelJob();
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (hasLocalFiles(*event->mimeData()))
    event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile())
      paths << url.toLocalFile();
  event->acceptProposedAction();
  openPaths(paths);
}

void MainWindow::chooseFiles() {
  auto* dialog =
      new QFileDialog(this, tr("Open Files"), m_settings.value(QLatin1String(folderKey)).toString(),
                      tr("Meshes and scenes (%1);;All files (*)").arg(readablePatterns()));
  dialog->setObjectName(QStringLiteral("openFilesDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  connect(dialog, &QFileDialog::filesSelected, this, &MainWindow::openPaths);
  dialog->open();
}

void MainWindow::chooseFolder() {
  auto* dialog = new QFileDialog(this, tr("Open Folder"),
                                 m_settings.value(QLatin1String(folderKey)).toString());
  dialog->setObjectName(QStringLiteral("openFolderDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  connect(dialog, &QFileDialog::filesSelected, this, &MainWindow::openPaths);
  dialog->open();
}

void MainWindow::openPaths(const QStringList& paths) {
  if (paths.isEmpty())
    return;
  m_settings.setValue(QLatin1String(folderKey), QFileInfo(paths.front()).absolutePath());
  std::vector<std::filesystem::path> files;
  for (const QString& path : paths)
    files.emplace_back(path.toStdString());
  m_session.openPaths(std::move(files));
}

void MainWindow::editSelection(const QString& name,
                               model::Edited (*edit)(const model::Scene&,
                                                     std::span<const model::NodeId>)) {
  if (!m_session.selection().empty())
    m_session.apply(name, edit(m_session.scene(), m_session.selection()));
}

void MainWindow::documentChange(const Document& before, const Document& now) {
  if (before.opening != now.opening || now.opening == 0) {
    setWindowTitle(now.title.isEmpty() ? tr("Sline") : tr("%1 – Sline").arg(now.title));
    m_summary->setText(now.opening == 0 ? QString() : summaryOf(now.scene));
  }
  updateActions();
}

void MainWindow::updateActions() {
  const bool any = !m_session.selection().empty();
  for (const char* id : {"focus", "context", "inherit", "toggle", "isolate", "remove"})
    m_actions[QLatin1String(id)].setEnabled(any);
  m_actions[QStringLiteral("reload")].setEnabled(m_session.canReload());
}

}  // namespace sline::widgets
