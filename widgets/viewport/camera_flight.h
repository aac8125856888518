// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/scene/camera.h"

namespace sline::widgets {

/// A short way from one camera to another: it turns by the shortest arc, and what it looks at
/// grows or shrinks evenly.
class CameraFlight {
 public:
  CameraFlight(const model::Camera& from, const model::Camera& to) : m_from(from), m_to(to) {}
  /// `part` of the time, 0 … 1; slow at both ends, and exactly the last camera at the end.
  model::Camera at(double part) const;

 private:
  model::Camera m_from;
  model::Camera m_to;
};

}  // namespace sline::widgets
