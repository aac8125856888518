// SPDX-License-Identifier: Apache-2.0
#include "render/measures/ramp.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/measures/tone.h"

namespace sline::render {

namespace {

constexpr double stepOfGamma = 1.0 / double(stepsPerStage);
// Tone is averaged over this many output units, so that strokes count as the grey they make.
constexpr float toneReach = 8.0f;
// The pixels at the structure's own edges that have a soft fill.
constexpr int softEdge = 2;

double gammaOf(int index) {
  return double(index) / double(stepsPerStage);
}

PixelRect unite(const PixelRect& a, const PixelRect& b) {
  if (a.empty() || b.empty())
    return a.empty() ? b : a;
  const int x = std::min(a.x, b.x);
  const int y = std::min(a.y, b.y);
  return {x, y, std::max(a.right(), b.right()) - x, std::max(a.top(), b.top()) - y};
}

/// Finds pixels with values that rise by more than `least` above an earlier value and later fall by
/// more than `least`.
class TurningPixels {
 public:
  TurningPixels(std::size_t count, float least)
      : m_least(least), m_extreme(count, 1e9f), m_peak(count, 0), m_state(count, State::falling) {}

  void add(int index, const std::vector<float>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const float value = values[i];
      if (m_state[i] == State::falling) {
        if (value - m_extreme[i] > m_least) {
          m_state[i] = State::risen;
          raise(i, index, value);
        } else {
          m_extreme[i] = std::min(m_extreme[i], value);
        }
      } else if (m_state[i] == State::risen) {
        if (value > m_extreme[i])
          raise(i, index, value);
        else if (m_extreme[i] - value > m_least)
          m_state[i] = State::turned;
      }
    }
  }

  /// Returns the index of the picture in which each pixel that turned was lightest, −1 for all
  /// others.
  std::vector<int> peaks() const {
    std::vector<int> result(m_peak.size(), -1);
    for (std::size_t i = 0; i < result.size(); ++i)
      if (m_state[i] == State::turned)
        result[i] = m_peak[i];
    return result;
  }

 private:
  enum class State : std::uint8_t { falling, risen, turned };
  void raise(std::size_t i, int index, float value) {
    m_extreme[i] = value;
    m_peak[i] = index;
  }

  float m_least;
  std::vector<float> m_extreme;  ///< the lowest value so far; once risen, the highest since
  std::vector<int> m_peak;
  std::vector<State> m_state;
};

/// Holds what the ends of a ramp tell before all its pictures are looked at.
struct Frame {
  Image first;
  Image last;
  PixelMask mask;
  double luminanceAtEnd = 0.0;
};

Result<Frame> frameOf(const RampPictures& pictures) {
  Frame frame;
  const Image fill = TRY(pictures.fill(rampGamma(rampSteps)));
  const PixelRect covered = coveredArea(fill);
  if (covered.empty())
    return Error{.reason = "the structure covers no pixel",
                 .remedy = "Choose a camera that sees it, or a larger picture"};
  for (const auto& [image, index] : {std::pair(&frame.first, 0), {&frame.last, rampSteps}}) {
    *image = TRY(pictures.whole(rampGamma(index)));
  }
  // The outline lies outside what it surrounds.
  frame.mask = coveredMask(fill, unite(covered, inkedArea(frame.first)));
  frame.luminanceAtEnd = mean(luminance(frame.last, frame.mask.area), frame.mask);
  return frame;
}

Status measurePictures(const RampPictures& pictures, const Frame& frame, Ramp& ramp) {
  const PixelRect& area = frame.mask.area;
  const int reach = int(std::lround(0.5f * toneReach * float(frame.first.height) / 720.0f));
  const MaskedBlur blur(frame.mask, std::max(reach, 1));
  TurningPixels turning(frame.mask.inside.size(), float(toneLimit * frame.luminanceAtEnd));
  Image before;
  Image stageStart;
  std::array<double, rampStages> endToEnd{};
  for (int i = 0; i <= rampSteps; ++i) {
    Image drawn = TRY(i == 0           ? Result<Image>(frame.first)
                      : i == rampSteps ? Result<Image>(frame.last)
                                       : pictures.whole(rampGamma(i)));
    if (i > 0)
      ramp.steps.push_back(meanDifference(before, drawn, area));
    if (i % stepsPerStage == 0) {
      if (i > 0)
        endToEnd[std::size_t(i / stepsPerStage - 1)] = meanDifference(stageStart, drawn, area);
      stageStart = drawn;
    }
    const PixelValues light = luminance(drawn, area);
    ramp.tone.luminance.push_back(mean(light, frame.mask));
    turning.add(i, blur(light).values);
    before = std::move(drawn);
  }
  for (std::size_t s = 0; s < ramp.stages.size(); ++s)
    ramp.stages[s] = measureStage(std::span(ramp.steps).subspan(s * stepsPerStage, stepsPerStage),
                                  double(s), endToEnd[s]);
  const double share = 1.0 / double(ramp.pixels);
  for (const int peak : turning.peaks())
    if (peak >= 0) {
      ramp.tone.bumpedPixels += share;
      ramp.tone.bumpedByStage[std::size_t(std::min(peak, rampSteps - 1) / stepsPerStage)] += share;
    }
  return Unit{};
}

void measureTone(RampTone& tone) {
  const double end = tone.luminance.back();
  const auto lowest = std::min_element(tone.luminance.begin(), tone.luminance.end());
  const double unit = 1.0 / std::max(end, 1e-6);
  tone.lowest = *lowest * unit;
  tone.lowestAt = gammaOf(int(lowest - tone.luminance.begin()));
  tone.bump = largestBump(tone.luminance);
  tone.bump.height *= unit;
}

Result<RampFill> measureFill(const RampPictures& pictures, const PixelMask& mask) {
  RampFill fill;
  std::vector<float> highest(mask.inside.size(), 0.0f);
  std::vector<std::uint8_t> fallen(mask.inside.size(), 0);
  for (int i = 0; i <= rampSteps; ++i) {
    const Image drawn = TRY(pictures.fill(rampGamma(i)));
    const PixelValues opacities = opacity(drawn, mask.area);
    for (std::size_t k = 0; k < highest.size(); ++k) {
      const double fall = highest[k] - opacities.values[k];
      fallen[k] = fallen[k] || fall > fillFallLimit;
      if (fall > fill.largestFall) {
        fill.largestFall = fall;
        fill.fallAt = gammaOf(i);
      }
      highest[k] = std::max(highest[k], opacities.values[k]);
    }
    if (i == rampSteps) {
      const PixelMask inner = shrunk(mask, softEdge);
      std::size_t open = 0;
      for (std::size_t k = 0; k < highest.size(); ++k)
        open += inner.inside[k] && opacities.values[k] < completeOpacity;
      fill.openAtEnd = double(open) / double(std::max(inner.count(), std::size_t(1)));
    }
  }
  fill.fallenPixels =
      std::accumulate(fallen.begin(), fallen.end(), 0.0) / double(mask.inside.size());
  return fill;
}

}  // namespace

RampStage measureStage(std::span<const double> steps, double first, double endToEnd) {
  RampStage stage;
  stage.whole = std::accumulate(steps.begin(), steps.end(), 0.0);
  stage.endToEnd = endToEnd;
  stage.mean = stage.whole / double(steps.size());
  if (!(stage.mean > 0.0))
    return stage;
  const auto largest = std::max_element(steps.begin(), steps.end());
  stage.largest = *largest / stage.mean;
  stage.largestAt = first + stepOfGamma * double(largest - steps.begin());
  stage.weakest = stage.largest;
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    const double rate = 0.5 * (steps[i] + steps[i + 1]) / stage.mean;
    const double start = first + stepOfGamma * double(i);
    if (rate < stage.weakest) {
      stage.weakest = rate;
      stage.weakestAt = start;
    }
    if (rate < deadLimit)
      stage.dead.push_back(start);
  }
  double done = 0.0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double after = done + steps[i] / stage.whole;
    for (; next < stage.timing.size() && after >= 0.1 * double(next + 1) - 1e-12; ++next) {
      const double within = (0.1 * double(next + 1) - done) * stage.whole / steps[i];
      stage.timing[next] = (double(i) + within) / double(steps.size());
    }
    done = after;
  }
  return stage;
}

Bump largestBump(std::span<const double> series) {
  Bump bump;
  if (series.empty())
    return bump;
  std::vector<double> lowestAfter(series.begin(), series.end());
  for (std::size_t i = series.size() - 1; i-- > 0;)
    lowestAfter[i] = std::min(lowestAfter[i], lowestAfter[i + 1]);
  double lowestBefore = series.front();
  for (std::size_t j = 0; j < series.size(); ++j) {
    lowestBefore = std::min(lowestBefore, series[j]);
    const double height = series[j] - std::max(lowestBefore, lowestAfter[j]);
    if (height > bump.height)
      bump = {.height = height, .at = int(j)};
  }
  return bump;
}

Result<Ramp> measureRamp(const RampPictures& pictures) {
  const Frame frame = TRY(frameOf(pictures));
  Ramp ramp;
  ramp.area = frame.mask.area;
  ramp.pixels = frame.mask.count();
  TRY(measurePictures(pictures, frame, ramp));
  measureTone(ramp.tone);
  ramp.fill = TRY(measureFill(pictures, frame.mask));
  return ramp;
}

}  // namespace sline::render
