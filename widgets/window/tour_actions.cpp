// SPDX-License-Identifier: Apache-2.0
#include "widgets/window/tour_actions.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QPointer>
#include <algorithm>

#include "widgets/viewport/viewport.h"
#include "widgets/views/presentation.h"
#include "widgets/views/view_tour.h"
#include "widgets/views/views_panel.h"

namespace sline::widgets {

TourActions::TourActions(QMainWindow& window, Session& session, Viewport& viewport,
                         const WindowActions& actions, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_add(actions[QStringLiteral("addView")]),
      m_present(actions[QStringLiteral("present")]),
      m_tour(new ViewTour(session, viewport, this)),
      m_presentation(new Presentation(window, session, viewport, this)) {
  makeDock(window, viewport);
  connect(&m_add, &QAction::triggered, m_tour, &ViewTour::add);
  connect(&m_present, &QAction::triggered, this,
          [this] { m_presentation->begin(std::max(0, m_panel->current())); });
  connect(&session, &Session::documentChanged, this, &TourActions::documentChange);
  viewport.labels().setCurrentView([panel = QPointer(m_panel)] {
    const int current = panel ? panel->current() : -1;
    return current < 0 ? std::nullopt : std::optional(std::size_t(current));
  });
  showState();
}

void TourActions::makeDock(QMainWindow& window, Viewport& viewport) {
  m_panel = new ViewsPanel(m_session, viewport, *m_tour);
  m_panel->addButtons(m_add, m_present);
  m_dock = new QDockWidget(tr("Views"));
  m_dock->setObjectName(QStringLiteral("viewsPanel"));
  // Its title stands beside it: the picture needs the height.
  m_dock->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable |
                      QDockWidget::DockWidgetVerticalTitleBar);
  m_dock->setAllowedAreas(Qt::BottomDockWidgetArea | Qt::TopDockWidgetArea);
  m_dock->setWidget(m_panel);
  m_dock->installEventFilter(this);
  // Below the picture alone: what stands at the sides needs its height.
  window.setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  window.addDockWidget(Qt::BottomDockWidgetArea, m_dock);
  m_dock->setVisible(m_tour->count() > 0);
  connect(m_dock->toggleViewAction(), &QAction::triggered, this,
          [this](bool on) { m_wanted = on; });
}

bool TourActions::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_dock && event->type() == QEvent::Close)
    m_wanted = false;
  return QObject::eventFilter(watched, event);
}

void TourActions::documentChange(const Document& before, const Document& now) {
  const bool another = before.opening != now.opening;
  if (another)
    m_wanted.reset();
  const bool were = !before.scene.views().empty();
  const bool are = !now.scene.views().empty();
  if (!another && were == are)
    return;
  showState();
  if (!m_presentation->running())
    m_dock->setVisible(m_wanted.value_or(are));
}

void TourActions::showState() {
  m_add.setEnabled(m_session.document().opening != 0);
  m_present.setEnabled(m_tour->count() > 0);
}

}  // namespace sline::widgets

#include "moc_tour_actions.cpp"
