// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "widgets/session/scene_job.h"

namespace sline::widgets {

/// A scene that the program models itself.
struct DemoScene {
  QString id;     ///< what settings and tests call it
  QString title;  ///< what a person reads
  SceneMaker make;
};

/// The first is what a new user sees first.
std::vector<DemoScene> demoScenes();

}  // namespace sline::widgets
