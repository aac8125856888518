// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sline::widgets {

/// Decides how fine pictures are while the camera moves: coarser where a full one takes long, full
/// again when it rests. The first of a scene is coarse: a full one that takes long would hold up
/// the move.
class MotionQuality {
 public:
  /// Notes how long a picture took that was drawn anew at that scale.
  void took(double milliseconds, float scale);
  /// Returns the share of the full width and height to draw while moving: 1, 3/4, 1/2 or 1/3.
  float scale() const { return m_scale; }

 private:
  float m_scale = 0.5f;
};

}  // namespace sline::widgets
