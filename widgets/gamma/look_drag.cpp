// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/look_drag.h"

namespace sline::widgets {

void LookDrag::begin(NodeIds ids) {
  cancel();
  m_ids = std::move(ids);
}

void LookDrag::moveTo(const model::Style& look) {
  if (active())
    m_session.preview(model::withLook(m_session.sceneBeforePreview(), m_ids, look).scene);
}

void LookDrag::finish(const QString& what) {
  if (!active())
    return;
  const QString name = lookStepName(what, m_session.scene(), m_ids);
  m_ids.clear();
  m_session.commitPreview(name);
}

void LookDrag::cancel() {
  if (!active())
    return;
  m_ids.clear();
  m_session.cancelPreview();
}

QString gammaText() {
  return QStringLiteral("Γ");
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
