// SPDX-License-Identifier: Apache-2.0
// Models the liver as a wedge: a dome that fits under the diaphragm, cut from below by the visceral
// surface, a height field over the horizontal plane that falls to a sharp margin in front and is
// marked by the fissures around the quadrate and caudate lobes. Neighbours press in later.
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "model/demo/abdomen/parts.h"

namespace sline::model {

namespace {

/// Returns a smooth hill of height 1 with the given half widths, turned by `angle` about the
/// vertical.
float hill(const glm::vec2& p, const glm::vec2& centre, const glm::vec2& width,
           float angle = 0.0f) {
  const glm::vec2 d = p - centre;
  const glm::vec2 q(std::cos(angle) * d.x + std::sin(angle) * d.y,
                    std::cos(angle) * d.y - std::sin(angle) * d.x);
  return std::exp(-0.5f * glm::dot(q / width, q / width));
}

float ramp(float low, float high, float x) {
  const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * t * (10.0f + t * (6.0f * t - 15.0f));
}

/// Returns the field of the part that the diaphragm moulds: a high right dome, a flat left lobe
/// that thins to its tip, and behind them the hollow for the spine and the crura.
float domeField(const glm::vec3& p) {
  // The dome is fuller below than an ellipsoid: the flank falls steeply to the inferior margin.
  glm::vec3 r = p - glm::vec3(-66, -10, 20);
  r.z *= 0.86f + 0.14f * std::tanh(r.z / 45.0f);
  const float right = cushion(r, {76.0f, 84.0f, 89.0f}, 0.3f);
  glm::vec3 l = p - glm::vec3(4, -40, 62);
  l.z += 0.0012f * l.x * l.x - 0.10f * l.x;
  l.y -= 0.0016f * l.x * l.x;
  // The lobe thins towards its tip.
  const float taper = 1.0f - 0.12f * std::tanh(l.x / 70.0f);
  const float left = ellipsoid(l / glm::vec3(1, taper, taper), {90.0f, 47.0f, 41.0f}) * taper;
  float d = blendedUnion(right, left, 46.0f);
  const float spine = glm::length(glm::vec2(p.x - 12.0f, p.y - 34.0f)) - 55.0f;
  d = blendedDifference(d, spine, 22.0f);
  const float heart = glm::length(p - glm::vec3(22, -48, 196)) - 100.0f;
  return blendedDifference(d, heart, 24.0f);
}

/// Returns how far the left lobe's surface lies below the right one's: along the falciform
/// ligament, from the notch of the round ligament over the dome, by a step that fades to the left.
float leftLobeStep(const glm::vec3& p) {
  const float ligament = -3.0f + 6.0f * std::sin((p.z - 20.0f) / 42.0f);
  const float beyond = p.x - ligament;
  const float step = 6.5f * ramp(-4.5f, 4.5f, beyond) * std::exp(-std::max(beyond, 0.0f) / 60.0f);
  return step * ramp(20.0f, -40.0f, p.y) * (1.0f - 0.75f * ramp(70.0f, 100.0f, p.z));
}

/// Returns the height of the visceral surface above (x, y).
float visceralHeight(const glm::vec2& p) {
  // The inferior margin climbs from the right flank to the left; from there the surface rises to
  // the porta and stays high behind.
  const float flank = std::max(-104.0f - p.x, 0.0f);
  const float margin = -58.0f + 0.54f * (p.x + 120.0f) + 0.016f * flank * flank;
  float z = margin + (24.0f + 26.0f * ramp(-120.0f, -30.0f, p.x)) * ramp(-95.0f, -18.0f, p.y);
  z += 34.0f * hill(p, {-48, 46}, {26, 28});          // right kidney
  z += 12.0f * hill(p, {-104, -34}, {24, 26}, 0.5f);  // colic flexure
  z += 12.0f * hill(p, {46, -34}, {34, 20}, 0.3f);    // stomach
  // The fissures form an H: gallbladder and vena cava on the right, the ligaments on the left, the
  // porta across; quadrate lobe in front of the porta, caudate lobe behind it.
  z -= 14.0f * hill(p, {-33, -61}, {12, 17}, -0.15f);   // quadrate lobe
  z -= 22.0f * hill(p, {-21, -9}, {12, 9}, 0.2f);       // caudate lobe
  z += 21.0f * hill(p, {-33, -32}, {23, 5.0f}, 0.12f);  // porta
  z += 9.0f * hill(p, {-69, -60}, {10, 20}, -0.48f);    // fossa of the gallbladder
  z += 32.0f * hill(p, {-5, -66}, {4.2f, 28}, -0.12f);  // fissure of the round ligament
  z += 22.0f * hill(p, {-2, -17}, {4.2f, 13}, -0.45f);  // fissure of the venous ligament
  return z;
}

float visceralField(const glm::vec3& p) {
  const glm::vec2 q(p.x, p.y);
  const float z = visceralHeight(q);
  constexpr float h = 0.5f;
  const float dx = (visceralHeight(q + glm::vec2(h, 0)) - z) / h;
  const float dy = (visceralHeight(q + glm::vec2(0, h)) - z) / h;
  return (z - p.z) / std::sqrt(1.0f + dx * dx + dy * dy);
}
}  // namespace

Field liverField() {
  return [](const glm::vec3& p) {
    const float dome = domeField(p);
    constexpr float farAway = 30.0f;
    if (dome > farAway)
      return dome;
    // The inferior margin is sharp, the border behind it blunt.
    const float edge = 6.5f + 4.5f * ramp(-40.0f, 10.0f, p.y);
    return blendedIntersection(dome + leftLobeStep(p), visceralField(p), edge);
  };
}

}  // namespace sline::model
