// SPDX-License-Identifier: Apache-2.0
#include "widgets/structure_tree/switch_sweep.h"

#include <algorithm>

#include "model/edit/locks.h"
#include "model/edit/visibility.h"

namespace sline::widgets {

void SwitchSweep::begin(Switch what, model::NodeId pressed, NodeIds ids) {
  cancel();
  const model::Scene& scene = m_session.scene();
  m_what = what;
  m_ids = std::move(ids);
  m_on = what == Switch::eye ? model::visibilityOf(scene, pressed) != model::Visibility::all
                             : !scene.find(pressed)->locked;
  show();
}

void SwitchSweep::add(model::NodeId id) {
  if (!active() || std::find(m_ids.begin(), m_ids.end(), id) != m_ids.end())
    return;
  m_ids.push_back(id);
  show();
}

void SwitchSweep::show() {
  const model::Scene& scene = m_session.sceneBeforePreview();
  if (m_what == Switch::lock)
    m_session.preview(model::withLocked(scene, m_ids, m_on).scene);
  else
    m_session.preview(
        (m_on ? model::withShown(scene, m_ids) : model::withHidden(scene, m_ids)).scene);
}

void SwitchSweep::finish() {
  if (!active())
    return;
  m_ids.clear();
  if (m_what == Switch::lock)
    m_session.commitPreview(m_on ? Session::tr("Lock") : Session::tr("Unlock"));
  else
    m_session.commitPreview(m_on ? Session::tr("Show") : Session::tr("Hide"));
}

void SwitchSweep::cancel() {
  if (!active())
    return;
  m_ids.clear();
  m_session.cancelPreview();
}

}  // namespace sline::widgets
