// SPDX-License-Identifier: Apache-2.0
#include "widgets/gamma/gamma_drag.h"

#include "model/edit/emphasis.h"

namespace sline::widgets {

void GammaDrag::begin(NodeIds ids) {
  cancel();
  m_ids = std::move(ids);
}

void GammaDrag::moveTo(Gamma gamma) {
  if (!active())
    return;
  model::Edited edited = model::withGamma(m_session.sceneBeforePreview(), m_ids, gamma);
  m_session.preview(std::move(edited.scene));
}

void GammaDrag::finish() {
  if (!active())
    return;
  const QString name = gammaStepName(m_session.scene(), m_ids);
  m_ids.clear();
  m_session.commitPreview(name);
}

void GammaDrag::cancel() {
  if (!active())
    return;
  m_ids.clear();
  m_session.cancelPreview();
}

QString gammaStepName(const model::Scene& scene, const NodeIds& ids) {
  const model::Node* only = ids.size() == 1 ? scene.find(ids.front()) : nullptr;
  return only ? Session::tr("Γ of %1").arg(QString::fromStdString(only->name))
              : Session::tr("Γ of %n items", nullptr, int(ids.size()));
}

}  // namespace sline::widgets
