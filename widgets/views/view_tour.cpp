// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/view_tour.h"

#include <algorithm>

#include "model/edit/views.h"
#include "widgets/views/view_list.h"

namespace sline::widgets {

ViewTour::ViewTour(Session& session, Viewport& viewport, QObject* parent)
    : QObject(parent), m_session(session), m_viewport(viewport) {}

const model::View* ViewTour::at(int index) const {
  return index >= 0 && index < count() ? &m_session.scene().views()[std::size_t(index)] : nullptr;
}

void ViewTour::goTo(int index) {
  const model::View* view = at(index);
  if (!view)
    return;
  m_session.cancelPreview();
  const model::Camera camera = view->camera;
  const QString step = tr("View “%1”").arg(shownName(*view));
  const model::Scene before = m_session.scene();
  model::Scene after = model::withViewApplied(before, *view).scene;
  const bool changed = !(after == before);
  // The flight begins first, so that no picture shows the new looks before the transition.
  m_viewport.travelTo(camera, before, after);
  m_session.apply(step, {std::move(after), changed});
  emit arrived(index);
}

void ViewTour::add() {
  if (m_session.document().opening == 0)
    return;
  m_session.cancelPreview();
  // The number must be free: after a deletion the next name is not "View 3 2".
  const model::Scene& scene = m_session.scene();
  std::string name;
  for (int number = count() + 1; name.empty(); ++number)
    if (const std::string wanted = tr("View %1").arg(number).toStdString();
        model::freeViewName(scene, wanted) == wanted)
      name = wanted;
  if (m_session.apply(tr("Add View"), model::withNewView(scene, m_viewport.camera(), name)))
    emit arrived(count() - 1);
}

void ViewTour::update(int index) {
  const model::View* view = at(index);
  if (!view)
    return;
  m_session.cancelPreview();
  const model::Scene& scene = m_session.scene();
  m_session.apply(tr("Update View “%1”").arg(shownName(*view)),
                  model::withViewUpdated(scene, std::size_t(index),
                                         model::viewOf(scene, m_viewport.camera(), view->name)));
}

void ViewTour::remove(int index) {
  const model::View* view = at(index);
  if (!view)
    return;
  m_session.apply(tr("Delete View “%1”").arg(shownName(*view)),
                  model::withoutView(m_session.scene(), std::size_t(index)));
}

void ViewTour::rename(int index, const QString& name) {
  if (!at(index))
    return;
  m_session.apply(tr("Rename View"), model::withViewRenamed(m_session.scene(), std::size_t(index),
                                                            name.toStdString()));
}

void ViewTour::move(int index, int to) {
  if (!at(index) || to < 0)
    return;
  m_session.apply(tr("Move View"),
                  model::withViewMoved(m_session.scene(), std::size_t(index), std::size_t(to)));
}

}  // namespace sline::widgets

#include "moc_view_tour.cpp"
