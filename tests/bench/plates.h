// SPDX-License-Identifier: Apache-2.0
// Counts what is wrong with what is written in the products of a scene.
#pragma once

#include <iosfwd>
#include <string>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/picture/picture.h"

namespace sline::bench {

struct PlateCourse {
  int products = 0;      ///< how many are made
  int judged = 0;        ///< of every so many it is judged whether leaders end on what they name
  bool near = false;     ///< those alone whose camera is near
  bool unruled = false;  ///< tells also what the rules for ink and for the foot are good for
  std::string folder;    ///< where pictures with faults go; empty: nowhere
};

/// Writes a line for each fault, and the sums of each kind of product in columns.
Status countPlates(render::Picture& picture, const model::Scene& scene, const PlateCourse& course,
                   std::ostream& out);

}  // namespace sline::bench
