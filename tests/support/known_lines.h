// SPDX-License-Identifier: Apache-2.0
// Makes a sheet with ridges and valleys of which all lines are known, and says how well lines that
// were found agree with them. Its lines come from the sheet's formula: those that no view moves in
// closed form, the others from derivatives on a fine grid, in coordinates of the sheet. So they
// share nothing with what finds lines on meshes.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "model/geometry/mesh.h"

namespace sline::test {

/// A ridge, or a valley where its height is negative, with a Gaussian profile z = h·exp(−t²/2σ²)
/// over the distance t from a straight line or from a circle.
struct Wave {
  glm::dvec2 middle{0.0};       ///< of the circle, or a point of the line, mm
  double radius = 0.0;          ///< mm; 0: a straight line
  glm::dvec2 across{1.0, 0.0};  ///< unit, perpendicular to the straight line
  double height = 0.0;          ///< mm
  double sigma = 1.0;           ///< mm
};

/// Returns the distance t of a place from a wave's line, and the direction in which it grows.
struct Across {
  double t;
  glm::dvec2 direction;
};
Across acrossOf(const Wave& wave, const glm::dvec2& p);

/// The graph of the sum of waves over a square around the origin; waves are so far apart that each
/// is alone where it has lines.
struct KnownSheet {
  std::vector<Wave> waves;
  double halfSize = 100.0;  ///< mm

  double heightAt(const glm::dvec2& p) const;
  glm::dvec2 slopeAt(const glm::dvec2& p) const;
  /// Returns 2·cells² triangles, normals to +z; vertices lie on the sheet, in no regular pattern.
  model::MeshPtr mesh(int cells) const;
};

/// Three straight waves and two round ones.
KnownSheet scannedSheet();

/// Describes a piece of a line by its middle.
struct LineSample {
  glm::dvec3 at{0.0};
  double length = 0.0;  ///< mm, or times its ink
  bool certain = true;  ///< above the technique's threshold, not just near it
};

enum class KnownKind {
  ridge,
  valley,
  demarcating,
  suggestive,
  apparentRidge,
  photic,
  laplacian,
  suggestiveHighlight,
  principalHighlight
};

struct KnownRequest {
  KnownKind kind = KnownKind::ridge;
  double threshold = 0.0;          ///< as the technique's
  double sharpness = 0.0;          ///< ridges and valleys: the least |κ''|/|κ|³
  double featureSize = 1.0;        ///< F, mm
  glm::dvec3 view{0.0, 0.0, 1.0};  ///< unit, towards the eye of a parallel projection
};
/// Returns the lines that have at least half the threshold; those above it are certain.
std::vector<LineSample> knownLines(const KnownSheet& sheet, const KnownRequest& request);

struct Agreement {
  double recall = 0.0;     ///< the share of the certain lines' length that has a drawn line near it
  double precision = 0.0;  ///< the share of drawn ink that has a known line near it
  double knownMm = 0.0;    ///< of certain lines
  double drawnMm = 0.0;
};
struct AgreementRule {
  double halfSize = 100.0;  ///< samples nearer than `rim` to the edge of that square do not count
  double rim = 0.0;
  double tolerance = 1.0;  ///< mm
};
Agreement agreementOf(std::span<const LineSample> known, std::span<const LineSample> drawn,
                      const AgreementRule& rule);

}  // namespace sline::test
