// SPDX-License-Identifier: Apache-2.0
// Says which patterns a structure's cut faces show in a view, and how thick their strokes are.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "render/drawn/drawn_structure.h"
#include "render/drawn/picture_view.h"

namespace sline::render {

/// The marks on one cut face.
struct FacePattern {
  std::shared_ptr<const Hatching> marks;
  glm::vec3 depthPlane{0.0f};  ///< like CapPaint's, a hair nearer to the eye
  /// The size of a pixel where marks have their own width; farther away they are thinner.
  float millimetresPerPixel = 1.0f;
  float width = 1.0f;  ///< a factor on the marks' own: thinner where the face is seen aslant
};

/// Knows which of a scene's surfaces lie within another, found once for each that is asked about as
/// long as the scene's surfaces stay the same.
class Hulls {
 public:
  /// Says of which scene is asked next.
  void take(const model::Scene& scene);
  /// Tells whether another structure's surface begins inside this one of the scene.
  bool isAroundOthers(const model::MeshPtr& mesh);

 private:
  std::vector<model::MeshPtr> m_meshes;  ///< of the scene's structures
  std::map<model::MeshPtr, bool> m_known;
};

/// Returns how a structure's cut faces are drawn: by its own name, else by that of a group above
/// it (resources/anatomy/tissue_patterns.tsv), but fat by its own alone. Where none of them says,
/// plain, and blank if another structure lies within; `hulls`, which have taken the scene, remember
/// that.
model::CutPattern cutPattern(const model::Scene& scene, const model::Node& node,
                             Hulls* hulls = nullptr);

/// Returns the patterns of those of the structure's cut faces that show any.
std::vector<FacePattern> facePatterns(const DrawnStructure& shown, const PictureView& view);

}  // namespace sline::render
