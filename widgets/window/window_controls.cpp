// SPDX-License-Identifier: Apache-2.0
// Makes the controls of the window, and makes them again in another language.
#include <QAction>
#include <QDockWidget>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QSettings>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <filesystem>
#include <functional>
#include <memory>
#include <utility>

#include "model/disk/cache_folder.h"
#include "model/look/opening_look.h"
#include "widgets/annotations/in_picture/label_actions.h"
#include "widgets/brush/brush_actions.h"
#include "widgets/brush/brush_tool.h"
#include "widgets/comparison/comparison_actions.h"
#include "widgets/export/export_actions.h"
#include "widgets/figure/figure_actions.h"
#include "widgets/focus/focus_context.h"
#include "widgets/focus/near_tool.h"
#include "widgets/import_dialog/import_actions.h"
#include "widgets/language/languages.h"
#include "widgets/sections/section_actions.h"
#include "widgets/sections/section_tool.h"
#include "widgets/sections/sections_panel.h"
#include "widgets/session/demo_scenes.h"
#include "widgets/shell/message_bar.h"
#include "widgets/start/demo_pictures.h"
#include "widgets/start/start_page.h"
#include "widgets/structure_tree/structure_actions.h"
#include "widgets/structure_tree/structure_tree.h"
#include "widgets/structure_tree/structure_tree_view.h"
#include "widgets/structure_tree/style_actions.h"
#include "widgets/viewport/viewport.h"
#include "widgets/views/tour_actions.h"
#include "widgets/views/view_actions.h"
#include "widgets/views/view_tour.h"
#include "widgets/views/views_panel.h"
#include "widgets/window/file_actions.h"
#include "widgets/window/interface_state.h"
#include "widgets/window/main_window.h"
#include "widgets/window/opening_styles.h"
#include "widgets/window/panel_table.h"
#include "widgets/window/picture_menu.h"
#include "widgets/window/picture_preferences.h"
#include "widgets/window/sides_actions.h"

namespace sline::widgets {

namespace {

constexpr const char* demoPicturesKey = "start/demoPictures";

}  // namespace

void MainWindow::makeCentre() {
  m_message = new MessageBar;
  m_viewport = new Viewport(m_session);
  auto sectionTool = std::make_unique<SectionTool>(m_session, *m_viewport);
  sectionTool->showOver(*m_viewport);
  m_viewport->addTool(std::move(sectionTool));
  auto nearness = std::make_unique<NearTool>(m_session, *m_viewport);
  nearness->showOver(*m_viewport);
  m_nearness = nearness.get();
  m_viewport->addTool(std::move(nearness));
  auto brush = std::make_unique<BrushTool>(m_session, *m_viewport);
  brush->showOver(*m_viewport);
  m_brush = brush.get();
  m_viewport->addTool(std::move(brush));
  m_focus = new FocusContext(
      m_session, [this] { return m_viewport->camera(); }, this);
  connect(m_focus, &FocusContext::failed, this, &MainWindow::refuse);
  // The picture's shape may have changed since the look was asked for, as while panels fill.
  connect(m_focus, &FocusContext::lookChosen, m_viewport, [this](const model::OpeningLook& look) {
    m_viewport->flyTo(
        model::framedCamera(look, pictureAspect(), m_viewport->freeSides(look.scene, look.camera)));
  });
  connect(&m_session, &Session::opened, this, [this] {
    const model::DrawingStyle* style = openingStyle(m_preferences);
    if (!style || !m_session.opensWithoutLook())
      return;
    prepareBackground(m_preferences, *style);
    m_focus->openWith(*style, pictureAspect());
  });
  auto* centre = new QWidget;
  auto* layout = new QGridLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  // What is said stands beside the picture: it would hide anatomy if it lay over it.
  layout->addWidget(m_message, 0, 0);
  layout->addWidget(m_viewport, 1, 0);
  layout->setRowStretch(1, 1);
  setCentralWidget(centre);
}

void MainWindow::makeControls() {
  m_parts = new QObject(this);
  makePanels();
  makeStatus();
  makeMenus();
  makeFiles();
  makeExports();
  makeStart();
  makeTools();
  connectSession();
  makeImports();
  connectActions();
  connectViews();
  nameStructures();
  documentChange({}, m_session.document());
}

void MainWindow::makePanels() {
  auto* tour = new ViewTour(m_session, *m_viewport, m_parts);
  addPanels(*this, {.session = m_session,
                    .settings = m_settings,
                    .preferences = m_preferences,
                    .viewport = *m_viewport,
                    .focus = *m_focus,
                    .nearness = *m_nearness,
                    .tour = *tour,
                    .actions = m_actions});
  m_tree = findChild<StructureTree*>();
  m_tree->setExplanation([this](model::NodeId id) { return m_focus->explanation(id); });
  m_tour = tour;
  new TourActions({.window = *this,
                   .session = m_session,
                   .viewport = *m_viewport,
                   .actions = m_actions,
                   .tour = *tour,
                   .dock = *findChild<QDockWidget*>(QStringLiteral("viewsPanel")),
                   .panel = *findChild<ViewsPanel*>()},
                  m_parts);
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
  jobShown(m_session.busy());
}

void MainWindow::makeMenus() {
  m_menus.emplace(*this, m_actions);
  const WindowMenus& menus = *m_menus;
  for (const DemoScene& demo : demoScenes()) {
    QAction* action = menus[QStringLiteral("demoMenu")].addAction(demo.title);
    action->setObjectName(QStringLiteral("demo-") + demo.id);
    connect(action, &QAction::triggered, this, [this, demo] { m_files->openDemo(demo); });
  }
  for (QAction* action : menus[QStringLiteral("structureMenu")].actions())
    m_tree->view().addAction(action);
  m_views = new ViewActions(m_session, *m_viewport, m_settings, m_actions,
                            menus[QStringLiteral("savedViews")]);
  connect(m_views, &ViewActions::viewChosen, m_tour, &ViewTour::goTo);
  new StructureActions(m_session, *m_tree, *m_viewport, m_actions, m_parts);
  new StyleActions(m_session, m_actions, m_parts);
  new BrushActions(m_session, *m_brush, *m_viewport, m_actions, m_parts);
  m_sections = new SectionActions(m_session, *m_viewport, m_actions, m_parts);
  connect(m_sections, &SectionActions::refused, this, &MainWindow::refuse);
  new SidesActions(m_session, m_actions, *static_cast<QGridLayout*>(centralWidget()->layout()),
                   m_parts);
  m_sections->fillAddMenu(findChild<SectionsPanel*>()->addButton());
  new LabelActions({.window = *this,
                    .session = m_session,
                    .picture = *m_viewport,
                    .view = *m_viewport,
                    .labels = m_viewport->labels(),
                    .preferences = m_preferences,
                    .actions = m_actions,
                    .shown = menus[QStringLiteral("labelModeMenu")]},
                   m_parts);
  new PicturePreferences(*m_viewport, m_preferences, m_actions,
                         menus[QStringLiteral("backgroundMenu")], m_parts);
  new PictureMenu(m_session, *m_viewport, *m_sections, *m_menus, m_parts);
  for (QDockWidget* panel : findChildren<QDockWidget*>())
    menus[QStringLiteral("panelMenu")].addAction(panel->toggleViewAction());
}

void MainWindow::makeFiles() {
  // It holds what is being written and must outlive a change of language.
  if (m_files)
    return m_files->controlsRemade();
  m_files = new FileActions({.session = m_session,
                             .settings = m_settings,
                             .preferences = m_preferences,
                             .actions = m_actions,
                             .message = *m_message,
                             .viewport = *m_viewport},
                            *this);
}

void MainWindow::makeExports() {
  // It holds what is being written, too.
  if (m_exports) {
    m_exports->controlsRemade();
    m_figures->controlsRemade();
    return m_comparisons->controlsRemade();
  }
  m_exports = new ExportActions({.session = m_session,
                                 .settings = m_settings,
                                 .actions = m_actions,
                                 .message = *m_message,
                                 .viewport = *m_viewport},
                                *this);
  m_figures = new FigureActions(m_session, m_actions, *this);
  m_comparisons = new ComparisonActions(
      {.session = m_session, .actions = m_actions, .viewport = *m_viewport}, *this);
}

void MainWindow::makeStart() {
  const std::filesystem::path cache = model::userCacheFolder();
  m_start = new StartPage(*this, m_files->recent(),
                          {builtDemoPictures(), cache.empty() ? cache : cache / "pictures"});
  m_start->setDrawing(m_settings.value(QLatin1String(demoPicturesKey), true).toBool());
  offerOpeningStyles(m_start->drawings(), m_preferences);
  connect(m_start, &StartPage::filesWanted, &m_actions[QStringLiteral("openFiles")],
          &QAction::trigger);
  connect(m_start, &StartPage::folderWanted, &m_actions[QStringLiteral("openFolder")],
          &QAction::trigger);
  connect(m_start, &StartPage::demoChosen, m_files, &FileActions::openDemo);
  connect(m_start, &StartPage::recentChosen, m_files, &FileActions::openRecent);
  connect(m_start, &StartPage::recoverWanted, m_files, &FileActions::recover);
  connect(m_start, &StartPage::forgetWanted, m_files, &FileActions::forget);
  const auto follow = [this] { m_start->setRecoverable(m_files->recoverable()); };
  connect(m_files, &FileActions::recoverableChanged, m_start, follow);
  follow();
}

void MainWindow::makeImports() {
  m_imports = new ImportActions({.session = m_session,
                                 .settings = m_settings,
                                 .preferences = m_preferences,
                                 .actions = m_actions,
                                 .message = *m_message},
                                *this);
  m_imports->setGuard([this](const std::function<void()>& then) { m_files->whenSafe(then); });
  m_files->setDropHandler([this](const QStringList& paths) {
    if (!m_imports->asksFor(paths, {}))
      m_files->open(paths);
  });
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

void MainWindow::remakeControls() {
  const InterfaceState memory(*this);
  // Objects that outlive the controls must not stay connected to the old ones.
  for (QObject* source :
       {static_cast<QObject*>(&m_session), static_cast<QObject*>(&m_preferences),
        static_cast<QObject*>(&m_session.history()), static_cast<QObject*>(m_viewport)})
    for (QObject* listener : {static_cast<QObject*>(this), static_cast<QObject*>(m_message)})
      source->disconnect(listener);
  placeMessage(false);
  delete m_start;
  delete m_imports;
  delete m_parts;
  clearControls(*this);
  m_actions.remake(*this);
  setLocale(QLocale());
  makeControls();
  memory.restore(*this);
}

void MainWindow::nameStructures() {
  const auto follow = [this] {
    m_session.names().setLanguage(
        namesLanguage(m_preferences.choice(QStringLiteral("language/structures")), QLocale()));
  };
  connect(&m_preferences, &Preferences::changed, m_parts, follow);
  follow();
  const auto tellTree = [this] {
    m_tree->view().setNames(
        {.shown = [this](const QString& name) { return m_session.names().shown(name); },
         .alsoCalled = [this](const QString& name) { return m_session.names().alsoCalled(name); }});
  };
  connect(&m_session.names(), &DisplayNames::changed, m_parts, tellTree);
  tellTree();
}

}  // namespace sline::widgets
