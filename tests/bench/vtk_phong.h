// SPDX-License-Identifier: Apache-2.0
// Has the yardsticks from outside: VTK's own mapper draws the same scene, from the same camera, in
// a context of the same kind, and its silhouette filter finds the contours of the same surface.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "model/scene/scene.h"

namespace sline::bench {

class VtkPhong {
 public:
  /// Needs a current OpenGL context for its whole lifetime.
  VtkPhong(const model::Scene& scene, int width, int height);
  ~VtkPhong();
  VtkPhong(const VtkPhong&) = delete;
  VtkPhong& operator=(const VtkPhong&) = delete;

  /// Draws one frame and waits for the GPU.
  void draw(const model::Camera& camera);
  /// Returns how much of the last frame is not background, 0 … 1: proof that something was drawn.
  double covered() const;

 private:
  struct Data;
  std::unique_ptr<Data> m_data;
};

/// Finds the edges of a surface between triangles that face the camera and others that do not.
class VtkSilhouette {
 public:
  explicit VtkSilhouette(const model::MeshPtr& mesh);
  ~VtkSilhouette();
  VtkSilhouette(VtkSilhouette&&) noexcept;
  VtkSilhouette& operator=(VtkSilhouette&&) noexcept;

  /// Finds them anew; what VTK computes once of a surface is kept.
  void update(const model::Camera& camera);

 private:
  struct Data;
  std::unique_ptr<Data> m_data;
};

}  // namespace sline::bench
