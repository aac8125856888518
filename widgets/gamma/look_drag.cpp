// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/look_drag.h"

#include <QCursor>
#include <QToolTip>
#include <cmath>
#include <utility>

#include "model/edit/look.h"

namespace sline::widgets {

namespace {

void sayHeld() {
  QToolTip::showText(QCursor::pos(),
                     Session::tr("One of them has reached the end, and all keep their "
                                 "differences. A drag with Shift makes them equal."));
}

}  // namespace

void LookDrag::begin(Start start) {
  cancel();
  m_start = std::move(start);
  m_held = false;
}

void LookDrag::moveTo(float number) {
  if (!active())
    return;
  const model::Scene& before = m_session.sceneBeforePreview();
  if (m_start.levels) {
    m_session.preview(model::withLook(before, m_start.ids, m_number.look(number)).scene);
    return;
  }
  m_session.preview(
      model::withLookMoved(before, m_start.ids, m_number, m_start.from, number).scene);
  const float by = number - m_start.from;
  constexpr float noticed = 0.01f;
  m_held = std::abs(model::roomToMove(before, m_start.ids, m_number, by) - by) >
           noticed * (m_number.limits.high - m_number.limits.low);
  if (m_held)
    sayHeld();
}

void LookDrag::finish(const QString& what) {
  if (!active())
    return;
  // The release of the button hides tips.
  if (std::exchange(m_held, false))
    QMetaObject::invokeMethod(&m_session, sayHeld, Qt::QueuedConnection);
  const QString name = lookStepName(what, m_session, m_start.ids);
  m_start = {};
  m_session.commitPreview(name);
}

void LookDrag::cancel() {
  if (!active())
    return;
  m_start = {};
  m_session.cancelPreview();
}

QString gammaText() {
  return QStringLiteral("Γ");
}

model::LookNumber gammaNumber() {
  return model::lookNumber<model::style_fields::gamma>();
}

QString differencesText() {
  return Session::tr("Structures that differ keep their differences; with Shift all become equal");
}

QString lookStepName(const QString& what, Session& session, const NodeIds& ids) {
  const model::Node* only = ids.size() == 1 ? session.scene().find(ids.front()) : nullptr;
  return only ? Session::tr("%1 of %2").arg(what, session.names().shown(only->name))
              : Session::tr("%1 of %n items", nullptr, int(ids.size())).arg(what);
}

QString lookSeries(const QString& kind, const NodeIds& ids) {
  QString series = kind;
  for (const model::NodeId id : ids)
    series += QStringLiteral(" %1").arg(id.value);
  return series;
}

}  // namespace sline::widgets
