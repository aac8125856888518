// SPDX-License-Identifier: Apache-2.0
#include "render/picture/motion_quality.h"

#include <algorithm>
#include <array>

namespace sline::render {

namespace {

/// A fineness, and the milliseconds that a picture of it should not exceed. Above 60, turning feels
/// like pushing; but blurred lines are worse than that, up to four pictures a second.
struct Choice {
  Fineness fineness;
  double limit;
};
constexpr double fluent = 60.0;
constexpr double bearable = 250.0;
constexpr int coarsest = MotionQuality::coarsestStep;
constexpr std::array choices{
    Choice{{1.0f, 1}, fluent},          Choice{{1.0f, 2}, fluent},
    Choice{{1.0f, coarsest}, bearable}, Choice{{0.75f, coarsest}, bearable},
    Choice{{0.5f, coarsest}, bearable}, Choice{{1.0f / 3.0f, coarsest}, bearable}};

/// The parts of a full picture's time that depend on the pixels of surfaces and on those of all
/// else; the rest goes into lines and triangles.
constexpr double surfaceShare = 0.25;
constexpr double pixelShare = 0.35;

/// Returns what a picture takes, of a full one's time.
double share(const Fineness& fineness) {
  const double area = double(fineness.scale) * fineness.scale;
  const double step = fineness.surfaceStep;
  return area * (surfaceShare / (step * step) + pixelShare) + 1.0 - surfaceShare - pixelShare;
}

}  // namespace

void MotionQuality::took(double milliseconds, const Fineness& fineness) {
  const double full = milliseconds / share(fineness);
  const auto found = std::find_if(choices.begin(), choices.end() - 1, [full](const Choice& choice) {
    return full * share(choice.fineness) <= choice.limit;
  });
  m_fineness = found->fineness;
}

}  // namespace sline::render
