// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/camera/camera.h"

namespace sline::model {

/// Describes a short way from one camera to another: it turns by the shortest arc, and what it
/// looks at grows or shrinks evenly.
class CameraFlight {
 public:
  CameraFlight(const Camera& from, const Camera& to) : m_from(from), m_to(to) {}
  /// Returns the camera at `part` of the time, 0 … 1; it moves slowly at both ends and is exactly
  /// the last camera at the end.
  Camera at(double part) const;

 private:
  Camera m_from;
  Camera m_to;
};

}  // namespace sline::model
