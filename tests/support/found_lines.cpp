// SPDX-License-Identifier: Apache-2.0
#include "tests/support/found_lines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <vector>

#include "render/lines/techniques/confis.h"
#include "render/lines/techniques/line_technique.h"
#include "render/lines/techniques/ridges.h"

namespace sline::test {

namespace {

using render::LineKind;
using render::Segment;

/// Returns pieces of a quarter of a cell with their ink.
std::vector<LineSample> sampled(const std::vector<Segment>& segments, double cell) {
  std::vector<LineSample> samples;
  for (const Segment& s : segments) {
    const glm::dvec3 a(s.a);
    const glm::dvec3 way = glm::dvec3(s.b) - a;
    const int count = 1 + int(4.0 * glm::length(way) / cell);
    for (int i = 0; i < count; ++i) {
      const double t = (double(i) + 0.5) / double(count);
      samples.push_back({.at = a + t * way,
                         .length = glm::length(way) / double(count) *
                                   ((1.0 - t) * double(s.opacityA) + t * double(s.opacityB))});
    }
  }
  return samples;
}

std::vector<Segment> segmentsOf(const KnownSheet& sheet, const model::Surface& surface,
                                LineKind kind) {
  return render::extractLines(surface, sheetCamera(sheet), {.kinds = {kind}})[kind];
}

AgreementRule ruleOf(const KnownSheet& sheet, double cell) {
  return {.halfSize = sheet.halfSize, .rim = 4.0 * cell, .tolerance = 1.5 * cell};
}

double cellOf(const KnownSheet& sheet, int cells) {
  return 2.0 * sheet.halfSize / double(cells);
}

/// Tells whether a stroke runs across the wave that it lies on.
bool runsAcross(const KnownSheet& sheet, const Segment& s) {
  const glm::dvec3 middle = 0.5 * glm::dvec3(s.a + s.b);
  const glm::dvec3 way = glm::dvec3(s.b - s.a);
  for (const Wave& wave : sheet.waves) {
    const Across across = acrossOf(wave, {middle.x, middle.y});
    if (std::abs(across.t) > 5.0 * wave.sigma)
      continue;
    const double slope = glm::dot(sheet.slopeAt({middle.x, middle.y}), across.direction);
    const glm::dvec3 direction =
        glm::normalize(glm::dvec3(across.direction.x, across.direction.y, slope));
    constexpr double cosine15 = 0.9659258262890683;
    return std::abs(glm::dot(way, direction)) >= cosine15 * glm::length(way);
  }
  return false;
}

}  // namespace

model::Camera sheetCamera(const KnownSheet& sheet) {
  const float angle = 25.0f * 3.14159265f / 180.0f;
  const glm::vec3 view(0.6f * std::sin(angle), -0.8f * std::sin(angle), std::cos(angle));
  return {.projection = model::Projection::orthographic,
          .eye = 10.0f * float(sheet.halfSize) * view,
          .target = {0, 0, 0},
          .up = {0, 1, 0},
          .heightMm = 2.2f * float(sheet.halfSize)};
}

std::optional<KnownKind> knownKindOf(LineKind kind) {
  switch (kind) {
    case LineKind::ridge:
      return KnownKind::ridge;
    case LineKind::valley:
      return KnownKind::valley;
    case LineKind::demarcating:
      return KnownKind::demarcating;
    case LineKind::suggestive:
      return KnownKind::suggestive;
    case LineKind::apparentRidge:
      return KnownKind::apparentRidge;
    case LineKind::photic:
      return KnownKind::photic;
    case LineKind::laplacian:
      return KnownKind::laplacian;
    case LineKind::suggestiveHighlight:
      return KnownKind::suggestiveHighlight;
    case LineKind::principalHighlight:
      return KnownKind::principalHighlight;
    default:
      return std::nullopt;
  }
}

Agreement agreementOn(const KnownSheet& sheet, int cells, const model::Surface& surface,
                      LineKind kind) {
  const double cell = cellOf(sheet, cells);
  const bool crest = kind == LineKind::ridge || kind == LineKind::valley;
  const auto thresholds = render::techniqueOf(kind).thresholds;
  const auto known = knownLines(
      sheet, {.kind = *knownKindOf(kind),
              .threshold = double(thresholds[0].usual),
              .sharpness = crest ? double(thresholds[render::leastRidgeSharpness].usual) : 0.0,
              .featureSize = double(surface.featureSize),
              .view = glm::dvec3(glm::normalize(sheetCamera(sheet).eye))});
  return agreementOf(known, sampled(segmentsOf(sheet, surface, kind), cell), ruleOf(sheet, cell));
}

Agreement confisAgreementOn(const KnownSheet& sheet, int cells, const model::Surface& surface) {
  const double cell = cellOf(sheet, cells);
  std::vector<LineSample> known;
  for (const KnownKind kind : {KnownKind::ridge, KnownKind::valley}) {
    // Along a crest H is half the curvature across it, as the other one is next to nothing.
    const auto some = knownLines(
        sheet, {.kind = kind,
                .threshold = 2.0 * double(render::confisThresholds[render::leastFeature].usual),
                .featureSize = double(surface.filigreeSize)});
    known.insert(known.end(), some.begin(), some.end());
  }
  const std::vector<Segment> segments = segmentsOf(sheet, surface, LineKind::confis);
  std::vector<Segment> right;
  std::copy_if(segments.begin(), segments.end(), std::back_inserter(right),
               [&sheet](const Segment& s) { return runsAcross(sheet, s); });
  const AgreementRule rule = ruleOf(sheet, cell);
  Agreement agreement = agreementOf(known, sampled(segments, cell), rule);
  const double rightMm = agreementOf({}, sampled(right, cell), rule).drawnMm;
  agreement.precision = rightMm / std::max(agreement.drawnMm, 1e-9);
  return agreement;
}

}  // namespace sline::test
