// SPDX-License-Identifier: Apache-2.0
#include "widgets/viewport/motion_quality.h"

#include <array>

namespace sline::widgets {

namespace {
constexpr std::array<float, 4> scales{1.0f, 0.75f, 0.5f, 1.0f / 3.0f};
/// The milliseconds above which turning the scene feels like pushing it.
constexpr double fluent = 60.0;
/// The part of a picture's time that depends on its pixels; the rest goes into lines and triangles.
constexpr double pixelShare = 0.7;
}  // namespace

void MotionQuality::took(double milliseconds, float scale) {
  const double area = double(scale) * scale;
  const double whole = milliseconds / (pixelShare * area + 1.0 - pixelShare);
  m_scale = scales.back();
  for (const float s : scales)
    if (whole * (pixelShare * double(s) * s + 1.0 - pixelShare) <= fluent) {
      m_scale = s;
      break;
    }
}

}  // namespace sline::widgets
