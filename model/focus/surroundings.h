// SPDX-License-Identifier: Apache-2.0
// Distances and lines of sight between the structures in focus and all others.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "model/focus/form.h"
#include "model/geometry/plane.h"
#include "model/scene/camera.h"
#include "model/scene/node_id.h"

namespace sline::model {

/// A structure of the scene as it is asked about.
struct Party {
  NodeId id;
  MeshPtr mesh;
  std::vector<Plane> planes;  ///< what they keep counts
  bool target = false;
  FormPtr form;
};

/// What is measured of a structure; lengths in millimetres.
struct Facts {
  float gap = 0.0f;      ///< nearest distance between the surfaces
  float contact = 0.0f;  ///< share of the targets' surface that it lies against
  float hides = 0.0f;    ///< share of the targets it hides, from where it hides most
  float outside = 0.0f;  ///< 0 amid the targets … 1 where the scene ends
};

class Surroundings {
 public:
  /// The parties must outlive it. Without a camera the targets are looked at from all round.
  Surroundings(std::span<const Party> parties, const std::optional<Camera>& camera);

  /// False where sections leave nothing of the targets, or there are none.
  bool answerable() const { return !m_samples.empty(); }
  /// Of the sphere with as much surface as the targets, mm.
  float radius() const { return m_radius; }
  /// Median way through the targets, mm.
  float thickness() const { return m_thickness; }
  Facts factsOf(const Party& party) const;
  /// From the place to the nearest target, mm; infinite where that is farther than `farthest`.
  float distanceTo(const glm::vec3& place,
                   float farthest = std::numeric_limits<float>::infinity()) const;
  /// How far the scene goes on beyond the structure where it is no farther than `within` from the
  /// targets, in units of their radius; the median over those places.
  float roomBeyond(const Party& party, float within) const;

 private:
  /// From a place on a target to the outside with nothing of the targets between.
  struct Sight {
    Ray ray;
    float weight = 0.0f;  ///< how large the surface there looks from that side
    std::size_t side = 0;
  };
  void lookAround();
  void lookFrom(const Camera& camera);
  void look(std::size_t side, const SurfaceSample& sample, const glm::vec3& direction,
            float farthest);
  void measureExtents();
  float hiding(const Party& party) const;
  float outsideness(const Party& party) const;

  std::span<const Party> m_parties;
  std::vector<const Party*> m_targets;
  std::vector<SurfaceSample> m_samples;  ///< of the targets
  Box m_box;                             ///< around them
  glm::vec3 m_centre{0.0f};
  float m_radius = 0.0f;
  float m_thickness = 0.0f;
  std::vector<Sight> m_sights;
  std::vector<double> m_shown;  ///< for each side, what is seen of the targets alone
  /// How far the targets and how far the scene reaches from their middle, by direction.
  struct Extent {
    float targets = 0.0f;
    float scene = 0.0f;
  };
  std::vector<Extent> m_extents;
};

/// Between the surfaces of two structures, at their samples; mm. What lies farther than `enough` is
/// not looked for.
float gapBetween(const Form& a, const Form& b, float enough);

}  // namespace sline::model
