// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/tour_actions.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QPointer>
#include <algorithm>
#include <glm/geometric.hpp>

#include "widgets/viewport/viewport.h"
#include "widgets/views/presentation.h"
#include "widgets/views/view_tour.h"
#include "widgets/views/views_panel.h"

namespace sline::widgets {

namespace {

/// Tells whether the view is left: one looks from another direction. Who goes nearer or aside, to
/// point better, is still there.
bool isLeft(const model::Camera& view, const model::Camera& now) {
  constexpr float still = 0.966f;  // the cosine of 15°
  return glm::dot(model::cameraFrame(view).back, model::cameraFrame(now).back) < still;
}

}  // namespace

TourActions::TourActions(const Context& context, QObject* parent)
    : QObject(parent),
      m_session(context.session),
      m_add(context.actions[QStringLiteral("addView")]),
      m_present(context.actions[QStringLiteral("present")]),
      m_tour(context.tour),
      m_presentation(new Presentation(context.window, context.session, context.viewport, this)),
      m_panel(context.panel),
      m_dock(context.dock) {
  m_dock.installEventFilter(this);
  m_dock.setVisible(m_tour.count() > 0);
  connect(m_dock.toggleViewAction(), &QAction::triggered, this, [this](bool on) { m_wanted = on; });
  connect(&m_add, &QAction::triggered, &m_tour, &ViewTour::add);
  connect(&m_present, &QAction::triggered, this,
          [this] { m_presentation->begin(std::max(0, m_panel.current())); });
  connect(&m_session, &Session::documentChanged, this, &TourActions::documentChange);
  context.viewport.labels().setCurrentView(
      [panel = QPointer(&m_panel), viewport = QPointer(&context.viewport),
       session = QPointer(&m_session)]() -> std::optional<std::size_t> {
        const int current = panel && viewport && session ? panel->current() : -1;
        if (current < 0 || std::size_t(current) >= session->scene().views().size() ||
            isLeft(session->scene().views()[std::size_t(current)].camera, viewport->camera()))
          return std::nullopt;
        return std::size_t(current);
      });
  showState();
}

bool TourActions::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &m_dock && event->type() == QEvent::Close)
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
    m_dock.setVisible(m_wanted.value_or(are));
}

void TourActions::showState() {
  m_add.setEnabled(m_session.document().opening != 0);
  m_present.setEnabled(m_tour.count() > 0);
}

}  // namespace sline::widgets

#include "moc_tour_actions.cpp"
