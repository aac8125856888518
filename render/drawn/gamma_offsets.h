// SPDX-License-Identifier: Apache-2.0
// Finds how Γ varies over a structure (METHOD §7): by how much it differs, at each vertex, from the
// structure's own.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "model/geometry/surface.h"
#include "model/scene/scene.h"

namespace sline::render {

struct DrawnStructure;

/// One per vertex, −5 … 5.
using GammaOffsets = std::vector<float>;
using GammaOffsetsPtr = std::shared_ptr<const GammaOffsets>;

/// Γ is nowhere on a structure less or more than this.
struct GammaSpan {
  Gamma least;
  Gamma most;
};
GammaSpan gammaSpan(const model::ResolvedStyle& style);

/// Tells whether Γ may differ from place to place.
inline bool gammaVaries(const model::ResolvedStyle& style) {
  return style.gammaMap.scalar != model::GammaScalar::none && !style.gammaMap.curve.empty();
}

/// Returns Γ at a point of that triangle, from 0 to 5.
float gammaAt(const model::Mesh& mesh, const GammaOffsets& offsets, Gamma own,
              std::uint32_t triangle, const glm::vec3& point);

/// Keeps the fields of a surface that pictures have asked for last. May be used from threads.
class GammaFields {
 public:
  /// Returns the offsets by that map; the same as before where nothing has changed. Of a map by
  /// distance, `targets` are the surfaces from which it is.
  GammaOffsetsPtr at(const model::Surface& surface, const model::GammaMap& map,
                     const std::vector<model::MeshPtr>& targets);
  /// Does the same for a map by what is painted.
  GammaOffsetsPtr at(const model::PaintPtr& paint, const model::GammaMap& map);

 private:
  /// The scalar at each vertex.
  struct Field {
    model::GammaScalar scalar = model::GammaScalar::none;
    std::vector<model::MeshPtr> targets;
    std::shared_ptr<const std::vector<float>> values;
  };
  struct Curve {
    std::shared_ptr<const std::vector<float>> values;
    std::vector<model::GammaPoint> points;
    GammaOffsetsPtr offsets;
  };
  std::shared_ptr<const std::vector<float>> field(const model::Surface& surface,
                                                  model::GammaScalar scalar,
                                                  const std::vector<model::MeshPtr>& targets);

  /// The distances from a place: it is dragged, so only the last one is kept.
  struct FromPlace {
    glm::vec3 place{0.0f};
    std::shared_ptr<const std::vector<float>> targets;  ///< null: from the place alone
    std::shared_ptr<const std::vector<float>> values;
  };
  struct Painted {
    model::PaintPtr paint;
    std::vector<model::GammaPoint> points;
    GammaOffsetsPtr offsets;
  };

  std::shared_ptr<const std::vector<float>> fromPlace(const model::Surface& surface,
                                                      const model::GammaMap& map,
                                                      const std::vector<model::MeshPtr>& targets);

  std::mutex m_mutex;
  std::vector<Field> m_fields;
  std::vector<Curve> m_curves;
  std::vector<Painted> m_painted;
  FromPlace m_fromPlace;
};

/// Finds the structure's offsets in its scene. Where its map measures distances to nothing that is
/// there, it has none, and Γ is the same everywhere. Where nothing is painted, all has the value 0.
void findGammaOffsets(const model::Scene& scene, DrawnStructure& shown);

}  // namespace sline::render
