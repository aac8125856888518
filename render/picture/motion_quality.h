// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace sline::render {

/// Says how fine a picture is drawn.
struct Fineness {
  float scale = 1.0f;   ///< the share of the full width and height
  int surfaceStep = 1;  ///< see PictureSettings
  bool operator==(const Fineness&) const = default;
  bool full() const { return *this == Fineness{}; }
};

/// Decides how fine pictures are while the camera moves, and full again when it rests: where a full
/// one takes long, surfaces are coarser, under lines as sharp as ever; only where that takes too
/// long, too, all is smaller. The first of a scene has coarse surfaces: a full one that takes long
/// would hold up the move.
class MotionQuality {
 public:
  /// The coarsest that surfaces become.
  static constexpr int coarsestStep = 3;

  /// Notes how long a picture took that was drawn anew that fine.
  void took(double milliseconds, const Fineness& fineness);
  Fineness fineness() const { return m_fineness; }

 private:
  Fineness m_fineness{.surfaceStep = coarsestStep};
};

}  // namespace sline::render
