// SPDX-License-Identifier: Apache-2.0
// Measures distances and lines of sight between the structures in focus and all others.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "model/camera/camera.h"
#include "model/focus/form.h"
#include "model/geometry/plane.h"
#include "model/scene/node_id.h"

namespace sline::model {

/// Describes a structure of the scene for the measurements.
struct Party {
  NodeId id;
  MeshPtr mesh;
  std::vector<Plane> planes;  ///< only the parts that they keep count
  bool target = false;
  FormPtr form;
  bool mayFeed = true;  ///< false where its name says that it is no vessel, nerve or duct
};

/// Holds the measurements of a structure; lengths in millimetres.
struct Facts {
  float gap = 0.0f;      ///< nearest distance between the surfaces
  float contact = 0.0f;  ///< share of the targets' surface that it lies against
  float hides = 0.0f;    ///< share of the targets it hides, from the side where it hides most
  float outside = 0.0f;  ///< 0 amid the targets … 1 where the scene ends
};

class Surroundings {
 public:
  /// Samples the targets and their lines of sight. The parties must outlive the object. Without a
  /// camera the targets are looked at from all round.
  Surroundings(std::span<const Party> parties, std::span<const Camera> cameras);

  /// Returns false where sections leave nothing of the targets, or there are none.
  bool answerable() const { return !m_samples.empty(); }
  /// Returns the radius of the sphere with as much surface as the targets, mm.
  float radius() const { return m_radius; }
  /// Returns the median width through the targets, mm.
  float thickness() const { return m_thickness; }
  Facts factsOf(const Party& party) const;
  /// Tells whether the place is nearer to a target than that many mm.
  bool isWithin(const glm::vec3& place, float distance) const;
  /// Returns how far the scene continues beyond the structure, in units of the targets' radius: the
  /// median over those of its places that are no farther than `within` from the targets.
  float roomBeyond(const Party& party, float within) const;

 private:
  /// A line of sight from a place on a target to the outside, not blocked by any target.
  struct Sight {
    Ray ray;
    float weight = 0.0f;  ///< how large the surface there appears from that side
    std::size_t side = 0;
  };
  /// Returns the distance from the place to the nearest target, mm; infinite where that is farther
  /// than `farthest`.
  float distanceTo(const glm::vec3& place, float farthest) const;
  void castFromAllSides();
  void castFromCameras(std::span<const Camera> cameras);
  void castSight(std::size_t side, const SurfaceSample& sample, const glm::vec3& direction,
                 float farthest);
  void measureExtents();
  float hiding(const Party& party) const;
  float outsideness(const Party& party) const;

  std::span<const Party> m_parties;
  std::vector<const Party*> m_targets;
  std::vector<SurfaceSample> m_samples;  ///< samples of the targets
  Box m_box;                             ///< box around the targets
  glm::vec3 m_centre{0.0f};
  float m_radius = 0.0f;
  float m_thickness = 0.0f;
  std::vector<Sight> m_sights;
  std::vector<double> m_shown;  ///< for each side, how much of the targets shows alone
  /// Holds how far the targets and the scene reach from the middle of the targets, by direction.
  struct Extent {
    float targets = 0.0f;
    float scene = 0.0f;
  };
  std::vector<Extent> m_extents;
};

/// Returns the distance between the surfaces of two structures, at their samples, in mm; infinite
/// where it is more than `enough`.
float gapBetween(const Form& a, const Form& b, float enough);

}  // namespace sline::model
