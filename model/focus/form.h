// SPDX-License-Identifier: Apache-2.0
// What of a structure's form matters when another is in focus: read off its mesh alone, so it is
// worked out once.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "model/focus/surface_samples.h"
#include "model/geometry/mesh_trees.h"

namespace sline::model {

struct Form {
  explicit Form(MeshPtr surface);

  MeshPtr mesh;
  BvhPtr tree;
  std::vector<SurfaceSample> samples;
  double area = 0.0;       ///< mm²
  float radius = 0.0f;     ///< of the sphere around it, mm
  float thickness = 0.0f;  ///< median way through it, straight in from the surface, mm
  /// The shares of the surface that belong to tubes (as thick one way as the other, and long) and
  /// to sheets (far wider than thick both ways); the rest is of lumps.
  float tube = 0.0f;
  float sheet = 0.0f;
};
using FormPtr = std::shared_ptr<const Form>;

FormPtr formOf(const MeshPtr& mesh);

/// Forms that were worked out before, by mesh. May be asked from any thread.
class FormIndex {
 public:
  FormPtr of(const MeshPtr& mesh);
  /// Forgets meshes that nobody else holds.
  void trim();

 private:
  std::mutex m_mutex;
  std::map<MeshPtr, FormPtr> m_forms;
};

}  // namespace sline::model
