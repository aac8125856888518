// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/tools/camera_tool.h"

namespace sline::widgets {

bool CameraTool::press(const Pointer& pointer) {
  const auto kind = dragOf(m_preset, pointer.button, pointer.keys);
  if (!kind)
    return false;
  m_before = m_view.camera();
  m_drag.emplace(model::CameraDrag::Start{.kind = *kind,
                                          .pixel = pointer.pixel,
                                          .camera = m_before,
                                          .pivot = m_view.pivot(),
                                          .ends = m_view.zoomEnds()});
  return true;
}

void CameraTool::move(const Pointer& pointer) {
  if (m_drag)
    m_view.move(m_drag->at(pointer.pixel, pointer.size));
}

void CameraTool::release(const Pointer&) {
  m_drag.reset();
}

void CameraTool::cancel() {
  if (m_drag)
    m_view.move(m_before);
  m_drag.reset();
}

}  // namespace sline::widgets
