// SPDX-License-Identifier: Apache-2.0
// Judges by pictures whether leaders end on what their labels name, for many views, looks and
// sections of one scene.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/scene/scene.h"
#include "render/picture/picture.h"

namespace sline::bench {

struct LeaderCourse {
  std::vector<std::string> foci;  ///< names of structures and groups between commas; each is one
  int labels = 32;                ///< at most, in one picture
  int height = 720;               ///< of a picture, pixels
  int every = 1;                  ///< looks at every so many of the pictures
  bool selfTest = false;          ///< judges the numbers of a self-test sheet instead
  std::string folder;             ///< where pictures with faults go; empty: nowhere
};

/// Writes a line for each fault and the sums; returns how many faults there were.
Result<int> judgeScene(render::Picture& picture, const model::Scene& scene,
                       const LeaderCourse& course, std::ostream& out);

}  // namespace sline::bench
