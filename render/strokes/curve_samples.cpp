// SPDX-License-Identifier: Apache-2.0
#include "render/strokes/curve_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "model/base/wide_loops.h"

namespace sline::render {

namespace {

// Pressures (METHOD §11.4).
constexpr float leastTip = 0.3f;
constexpr float lightShare = 0.25f;
constexpr float nearestPressure = 1.1f;
constexpr float farthestPressure = 0.85f;

SLINE_WIDE_LOOPS
void makeUnit(float* x, float* y, float* z, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const float perLength = 1.0f / std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
    x[i] *= perLength;
    y[i] *= perLength;
    z[i] *= perLength;
  }
}

/// The rows of a matrix that make a point's x, y and w.
struct ProjectedRows {
  glm::vec4 x;
  glm::vec4 y;
  glm::vec4 w;
  glm::vec2 size;
};

/// Adds in the order in which PictureView::project does.
inline float applied(const glm::vec4& row, float x, float y, float z) {
  return (row.x * x + row.y * y) + (row.z * z + row.w);
}

struct InRows {
  const float* x;
  const float* y;
  const float* z;
};
struct OutRows {
  float* x;
  float* y;
};

SLINE_WIDE_LOOPS
void findPixels(const InRows& in, std::size_t count, const ProjectedRows& to, const OutRows& out) {
  const float *px = in.x, *py = in.y, *pz = in.z;
  float *pixelX = out.x, *pixelY = out.y;
  const ProjectedRows rows = to;
  for (std::size_t i = 0; i < count; ++i) {
    const float w = applied(rows.w, px[i], py[i], pz[i]);
    const float x = applied(rows.x, px[i], py[i], pz[i]) / w;
    const float y = applied(rows.y, px[i], py[i], pz[i]) / w;
    pixelX[i] = (0.5f * x + 0.5f) * rows.size.x;
    pixelY[i] = (0.5f * y + 0.5f) * rows.size.y;
  }
}

struct CameraRows {
  glm::vec4 right;
  glm::vec4 up;
  glm::vec4 back;
  bool atInfinity;
};

/// See PictureView::projectedDirection.
SLINE_WIDE_LOOPS
void findDirections(const InRows& places, const InRows& normals, std::size_t count,
                    const CameraRows& camera, const OutRows& out) {
  const float *px = places.x, *py = places.y, *pz = places.z;
  const float *nx = normals.x, *ny = normals.y, *nz = normals.z;
  float *outX = out.x, *outY = out.y;
  const CameraRows c = camera;
  const float parallel = c.atInfinity ? 1.0f : 0.0f, perspective = 1.0f - parallel;
  SLINE_INDEPENDENT_ROUNDS
  for (std::size_t i = 0; i < count; ++i) {
    const float right = c.right.x * nx[i] + c.right.y * ny[i] + c.right.z * nz[i];
    const float up = c.up.x * nx[i] + c.up.y * ny[i] + c.up.z * nz[i];
    const float back = c.back.x * nx[i] + c.back.y * ny[i] + c.back.z * nz[i];
    const float qx = applied(c.right, px[i], py[i], pz[i]);
    const float qy = applied(c.up, px[i], py[i], pz[i]);
    const float qz = applied(c.back, px[i], py[i], pz[i]);
    const float x = right * (parallel - perspective * qz) + perspective * (qx * back);
    const float y = up * (parallel - perspective * qz) + perspective * (qy * back);
    const float length = std::sqrt(x * x + y * y);
    const float perLength = length > 1e-20f ? 1.0f / length : 0.0f;
    outX[i] = x * perLength;
    outY[i] = y * perLength;
  }
}

/// What pressures depend on besides the rule.
struct PressureRows {
  InRows place;
  const float* opacity;
  const float* outwardX;
  const float* outwardY;
  float step;   ///< λ
  float reach;  ///< λ
};

SLINE_WIDE_LOOPS
void fillPressures(const PressureRows& rows, std::size_t count, const PressureRule& rule,
                   float* pressure) {
  const float *px = rows.place.x, *py = rows.place.y, *pz = rows.place.z;
  const float *opacity = rows.opacity, *outwardX = rows.outwardX, *outwardY = rows.outwardY;
  const glm::vec3 back = rule.back;
  const glm::vec2 light = rule.light;
  const float low = rule.low;
  const float perDepth = 1.0f / std::max(rule.high - rule.low, 1e-6f);
  const float perReach = rows.reach > 0.0f ? 1.0f / rows.reach : 0.0f;
  const float whole = rows.reach > 0.0f ? 0.0f : 1.0f;
  const float variation = rule.variation;
  const float outlined = rule.outline ? 1.0f : 0.0f;
  const float step = rows.step;
  const int last = int(count) - 1;
  SLINE_INDEPENDENT_ROUNDS
  for (int i = 0; i <= last; ++i) {
    const float along = -(px[i] * back.x + py[i] * back.y + pz[i] * back.z);
    const float depth = std::min(std::max((along - low) * perDepth, 0.0f), 1.0f);
    const float byDepth = nearestPressure + depth * (farthestPressure - nearestPressure);
    const float byLight = 1.0f - lightShare * (outwardX[i] * light.x + outwardY[i] * light.y);
    const float byOpacity = (0.35f + 0.4f * opacity[i]) / (0.45f + 0.55f * opacity[i]);
    const float fromEnd = step * float(std::min(i, last - i));
    const float t = std::min(std::max(fromEnd * perReach + whole, 0.0f), 1.0f);
    const float tip = leastTip + t * t * (3.0f - 2.0f * t) * (1.0f - leastTip);
    const float byKind = outlined * byLight + (1.0f - outlined) * byOpacity;
    const float full = byDepth * byKind * tip;
    pressure[i] = 1.0f + variation * (full - 1.0f);
  }
}

/// What shares depend on besides the bounds.
struct MoveRows {
  const float* moveX;
  const float* moveY;
  const float* outwardX;
  const float* outwardY;
};

SLINE_WIDE_LOOPS
bool fillShares(const MoveRows& rows, std::size_t count, const MoveBounds& bounds, float* shares) {
  const float *moveX = rows.moveX, *moveY = rows.moveY;
  const float *outwardX = rows.outwardX, *outwardY = rows.outwardY;
  const auto [most, outwards, inwards] = bounds;
  int held = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = moveX[i], y = moveY[i];
    const float length = std::sqrt(x * x + y * y);
    const float out = x * outwardX[i] + y * outwardY[i];
    const float along = std::abs(out);
    const float limit = out > 0.0f ? outwards : inwards;
    const float byLength = most / std::max(length, 1e-20f);
    const float bySide = limit / std::max(along, 1e-20f);
    const float share = std::min(std::min(byLength, bySide), 1.0f);
    shares[i] = share;
    held |= int(share < 1.0f);
  }
  return held != 0;
}

InRows inRows(const std::array<CurveSamples::Row, 3>& rows) {
  return {rows[0].data(), rows[1].data(), rows[2].data()};
}

}  // namespace

PressureRule::PressureRule(const PictureView& view, const glm::vec3& towards, bool ofOutline,
                           float varied)
    : outline(ofOutline),
      variation(varied),
      light(towards.x, towards.y),
      back(view.toPatient({0.0f, 0.0f, 1.0f})),
      low(std::numeric_limits<float>::infinity()),
      high(-std::numeric_limits<float>::infinity()) {
  for (const glm::vec3& corner : view.bounds().corners()) {
    low = std::min(low, -glm::dot(corner, back));
    high = std::max(high, -glm::dot(corner, back));
  }
}

void CurveSamples::start(std::size_t count) {
  for (std::array<Row, 3>* rows : {&place, &normal})
    for (Row& row : *rows)
      row.resize(count);
  for (Row* row : {&opacity, &entry, &gamma, &pixel[0], &pixel[1]})
    row->resize(count);
  for (Row* row : {&outward[0], &outward[1], &move[0], &move[1]})
    row->assign(count, 0.0f);
  pressure.assign(count, 1.0f);
  segments.resize(count > 0 ? count - 1 : 0);
  concave.resize(segments.size());
}

void CurveSamples::set(std::size_t sample, const Segment& s, bool reversed, float t) {
  const float u = reversed ? 1.0f - t : t;
  const auto put = [&](const glm::vec3& at, const glm::vec3& turnedTo, const glm::vec3& values) {
    place[0][sample] = at.x;
    place[1][sample] = at.y;
    place[2][sample] = at.z;
    normal[0][sample] = turnedTo.x;
    normal[1][sample] = turnedTo.y;
    normal[2][sample] = turnedTo.z;
    opacity[sample] = values.x;
    entry[sample] = values.y;
    gamma[sample] = values.z;
  };
  const glm::vec3 atA(s.opacityA, s.entryA, s.gammaA);
  const glm::vec3 atB(s.opacityB, s.entryB, s.gammaB);
  if (u <= 0.0f)
    put(s.a, s.normalA, atA);
  else if (u >= 1.0f)
    put(s.b, s.normalB, atB);
  else
    put(glm::mix(s.a, s.b, u), glm::mix(s.normalA, s.normalB, u), glm::mix(atA, atB, u));
}

void CurveSamples::normalise() {
  makeUnit(normal[0].data(), normal[1].data(), normal[2].data(), size());
}

void CurveSamples::project(const PictureView& view, bool outwards) {
  const auto row = [](const glm::mat4& m, glm::length_t i) {
    return glm::vec4(m[0][i], m[1][i], m[2][i], m[3][i]);
  };
  const glm::mat4& to = view.viewProjection();
  findPixels(inRows(place), size(), {row(to, 0), row(to, 1), row(to, 3), view.size()},
             {pixel[0].data(), pixel[1].data()});
  if (!outwards)
    return;
  const glm::mat4& camera = view.viewMatrix();
  findDirections(inRows(place), inRows(normal), size(),
                 {row(camera, 0), row(camera, 1), row(camera, 2), view.eye().atInfinity},
                 {outward[0].data(), outward[1].data()});
}

bool CurveSamples::findShares(bool outline, const MoveBounds& bounds, Row& shares) const {
  shares.resize(size());
  const float none = std::numeric_limits<float>::max();
  return fillShares(
      {move[0].data(), move[1].data(), outward[0].data(), outward[1].data()}, size(),
      {bounds.most, outline ? bounds.outwards : none, outline ? bounds.inwards : none},
      shares.data());
}

void CurveSamples::findPressures(const PressureRule& rule, float reach, float unit) {
  fillPressures(
      {inRows(place), opacity.data(), outward[0].data(), outward[1].data(), step / unit, reach},
      size(), rule, pressure.data());
}

}  // namespace sline::render
