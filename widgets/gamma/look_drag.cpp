// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/look_drag.h"

namespace sline::widgets {

void LookDrag::begin() {
  cancel();
  m_ids = m_session.selection();
}

void LookDrag::moveTo(const model::Style& look) {
  if (!m_ids.empty())
    m_session.preview(model::withLook(m_session.sceneBeforePreview(), m_ids, look).scene);
}

void LookDrag::finish(const QString& name) {
  if (m_ids.empty())
    return;
  m_ids.clear();
  m_session.commitPreview(name);
}

void LookDrag::cancel() {
  if (m_ids.empty())
    return;
  m_ids.clear();
  m_session.cancelPreview();
}

QString lookStepName(const QString& what, const model::Scene& scene, const NodeIds& ids) {
  const model::Node* only = ids.size() == 1 ? scene.find(ids.front()) : nullptr;
  return only ? Session::tr("%1 of %2").arg(what, QString::fromStdString(only->name))
              : Session::tr("%1 of %n items", nullptr, int(ids.size())).arg(what);
}

QString lookSeries(const QString& kind, const NodeIds& ids) {
  QString series = kind;
  for (const model::NodeId id : ids)
    series += QStringLiteral(" %1").arg(id.value);
  return series;
}

}  // namespace sline::widgets
