// SPDX-License-Identifier: Apache-2.0
// Measures those properties of a structure's form that matter when another structure is in focus.
// They depend on its mesh alone, so they are computed once.
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
  float radius = 0.0f;     ///< radius of its bounding sphere, mm
  float thickness = 0.0f;  ///< median width straight in from the surface, mm
  /// The shares of the surface that belong to tubes (as thick one way as the other, and long) and
  /// to sheets (far wider than thick both ways); the rest belongs to lumps.
  float tube = 0.0f;
  float sheet = 0.0f;
};
using FormPtr = std::shared_ptr<const Form>;

FormPtr formOf(const MeshPtr& mesh);

/// Keeps forms that were computed before, by mesh. May be used from any thread.
class FormIndex {
 public:
  FormPtr of(const MeshPtr& mesh);
  /// Forgets meshes that are not in use anywhere else.
  void trim();

 private:
  std::mutex m_mutex;
  std::map<MeshPtr, FormPtr> m_forms;
};

}  // namespace sline::model
