// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QString>
#include <vector>

#include "widgets/session/scene_job.h"

namespace sline::widgets {

/// A scene that the program models itself.
struct DemoScene {
  QString id;     ///< its name in settings and tests
  QString title;  ///< the name that the user reads
  QString key;    ///< another one whenever the program models it otherwise
  SceneMaker make;
};

/// Returns the demo scenes; a new user sees the first one first.
std::vector<DemoScene> demoScenes();

}  // namespace sline::widgets
