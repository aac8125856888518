// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/panel_table.h"

#include <QAction>
#include <QDockWidget>
#include <QLayout>
#include <QMainWindow>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStyle>
#include <QUndoView>
#include <algorithm>

#include "widgets/annotations/annotations_panel.h"
#include "widgets/annotations/in_picture/label_actions.h"
#include "widgets/annotations/in_picture/picture_labels.h"
#include "widgets/focus/focus_panel.h"
#include "widgets/gamma/drawing_panel.h"
#include "widgets/gamma/gamma_panel.h"
#include "widgets/gamma/stage_previews.h"
#include "widgets/pockets/pockets_panel.h"
#include "widgets/preferences/preferences.h"
#include "widgets/sections/sections_panel.h"
#include "widgets/shell/window_actions.h"
#include "widgets/structure_tree/structure_tree.h"
#include "widgets/views/tour_actions.h"
#include "widgets/views/views_panel.h"
#include "widgets/window/drawing_grounds.h"
#include "widgets/window/main_window.h"

namespace sline::widgets {

namespace {

QWidget* makeGamma(const PanelContext& context) {
  auto* panel = new GammaPanel(context.session, context.settings);
  QObject::connect(panel, &GammaPanel::focusWanted, &context.actions[QStringLiteral("focus")],
                   &QAction::trigger);
  QAction& brush = context.actions[QStringLiteral("brush")];
  QObject::connect(panel, &GammaPanel::brushWanted, &brush, [&brush] {
    if (!brush.isChecked())
      brush.trigger();
  });
  drawStages(context.session, context.viewport, panel->stages());
  offerDrawings(context.session, context.viewport, panel->drawings());
  auto* grounds = new DrawingGrounds(context.session, context.preferences, panel);
  QObject::connect(&panel->drawings(), &DrawingPanel::backgroundWanted, grounds,
                   &DrawingGrounds::take);
  return panel;
}

QWidget* makeFocus(const PanelContext& context) {
  auto* panel = new FocusPanel(context.session, context.focus, context.nearness);
  QObject::connect(panel, &FocusPanel::focusWanted, &context.actions[QStringLiteral("focus")],
                   &QAction::trigger);
  return panel;
}

QWidget* makePockets(const PanelContext& context) {
  auto* panel = new PocketsPanel(context.session, context.viewport);
  // Who opens a protein finds the panel among the tabs.
  QObject::connect(&context.session, &Session::opened, panel, [panel] {
    for (QWidget* above = panel; panel->hasMolecules() && above; above = above->parentWidget())
      if (auto* dock = qobject_cast<QDockWidget*>(above))
        dock->show();
  });
  return panel;
}

QWidget* makeHistory(const PanelContext& context) {
  auto* history = new QUndoView(&context.session.history());
  history->setObjectName(QStringLiteral("history"));
  history->setAccessibleName(MainWindow::tr("History"));
  history->setEmptyLabel(MainWindow::tr("As opened"));
  return history;
}

/// Makes the dock around the panel as high as the panel now wants to be.
void fitDock(QWidget& panel) {
  panel.layout()->activate();
  for (QWidget* above = &panel; above; above = above->parentWidget())
    if (auto* dock = qobject_cast<QDockWidget*>(above))
      if (auto* window = qobject_cast<QMainWindow*>(dock->parentWidget()))
        window->resizeDocks({dock}, {panel.sizeHint().height()}, Qt::Vertical);
}

QWidget* makeViews(const PanelContext& context) {
  auto* panel =
      new ViewsPanel(context.session, context.viewport, context.tour, context.preferences);
  panel->addButtons(context.actions[QStringLiteral("addView")],
                    context.actions[QStringLiteral("present")]);
  const QString key = QStringLiteral("views/words");
  panel->showWords(context.settings.value(key).toBool());
  QObject::connect(panel, &ViewsPanel::wordsShown, panel,
                   [panel, &settings = context.settings, key](bool shown) {
                     settings.setValue(key, shown);
                     fitDock(*panel);
                   });
  return panel;
}

QWidget* makeLabels(const PanelContext& context) {
  auto* panel = new AnnotationsPanel(context.session, context.preferences);
  panel->addButtons(labelMakers(context.actions));
  const PictureLabels& labels = context.viewport.labels();
  const auto tell = [panel, &labels] { panel->setSights(labels.sights()); };
  QObject::connect(&labels, &PictureLabels::sighted, panel, tell);
  tell();
  return panel;
}

/// Holds a panel and scrolls where the screen is too small for it: however large letters are, a
/// side of the window takes at most a third of the screen's width and a quarter of its height.
class PanelArea : public QScrollArea {
 public:
  PanelArea(const QString& panel, QWidget* content) {
    setObjectName(panel + QStringLiteral("Area"));
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::NoFocus);
    setWidget(content);
  }
  QSize sizeHint() const override { return widget()->sizeHint(); }
  QSize minimumSizeHint() const override {
    const QSize whole = screen()->availableGeometry().size();
    return least().boundedTo(whole / 4);
  }

 private:
  QSize least() const {
    const QSize hint = widget()->minimumSizeHint();
    const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent);
    return hint.expandedTo(widget()->minimumSize()) + QSize(hint.height() > height() ? bar : 0, 0);
  }
};

QDockWidget* dockOf(const PanelRow& row, QWidget* content) {
  auto* dock = new QDockWidget(row.title);
  dock->setObjectName(QLatin1String(row.id));
  dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable);
  dock->setWidget(qobject_cast<QAbstractScrollArea*>(content)
                      ? content
                      : new PanelArea(dock->objectName(), content));
  if (row.area == Qt::BottomDockWidgetArea) {
    // Its title stands beside it, because the picture needs the height.
    dock->setFeatures(dock->features() | QDockWidget::DockWidgetVerticalTitleBar);
    dock->setAllowedAreas(Qt::BottomDockWidgetArea | Qt::TopDockWidgetArea);
  }
  return dock;
}

}  // namespace

std::vector<PanelRow> panelRows() {
  constexpr Qt::DockWidgetArea left = Qt::LeftDockWidgetArea;
  constexpr Qt::DockWidgetArea right = Qt::RightDockWidgetArea;
  // The right side has no height for three panels, and a list of labels is as long as that of
  // structures.
  return {
      {"structuresPanel", MainWindow::tr("Structures"), left, "", true,
       [](const PanelContext& context) { return new StructureTree(context.session); }},
      {"gammaPanel", MainWindow::tr("Line Style"), right, "", true, makeGamma},
      {"focusPanel", MainWindow::tr("Focus and Context"), right, "", true, makeFocus},
      {"sectionsPanel", MainWindow::tr("Sections"), right, "focusPanel", true,
       [](const PanelContext& context) { return new SectionsPanel(context.session); }},
      {"historyPanel", MainWindow::tr("History"), right, "focusPanel", false, makeHistory},
      {"viewsPanel", TourActions::tr("Views"), Qt::BottomDockWidgetArea, "", true, makeViews},
      {"annotationsPanel", LabelActions::tr("Labels"), left, "structuresPanel", true, makeLabels},
      {"pocketsPanel", PocketsPanel::tr("Pockets"), left, "structuresPanel", false, makePockets}};
}

void addPanels(QMainWindow& window, const PanelContext& context) {
  // The views lie below the picture alone, because the panels at the sides need their height.
  window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  for (const PanelRow& row : panelRows()) {
    QDockWidget* dock = dockOf(row, row.make(context));
    window.addDockWidget(row.area, dock);
    if (*row.beside) {
      auto* front = window.findChild<QDockWidget*>(QLatin1String(row.beside));
      window.tabifyDockWidget(front, dock);
      front->raise();
    }
    if (!row.shown)
      dock->hide();
  }
}

void HiddenPanels::toggle(QMainWindow& window) {
  const QList<QDockWidget*> docks = window.findChildren<QDockWidget*>();
  const bool any = std::any_of(docks.begin(), docks.end(),
                               [](const QDockWidget* dock) { return !dock->isHidden(); });
  if (any) {
    m_shown = window.saveState();
    for (QDockWidget* dock : docks)
      dock->hide();
  } else if (!m_shown.isEmpty()) {
    window.restoreState(m_shown);
  } else {
    // They were hidden when the program was closed.
    for (const PanelRow& row : panelRows())
      window.findChild<QDockWidget*>(QLatin1String(row.id))->setVisible(row.shown);
  }
}

}  // namespace sline::widgets
