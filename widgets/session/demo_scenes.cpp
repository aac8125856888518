// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/demo_scenes.h"

#include <QCoreApplication>

#include "model/demo/kidney.h"

namespace sline::widgets {

namespace {

SceneMaker modelled(const QString& title, model::Scene (*make)()) {
  return [title, make](const model::ImportProgress&) -> Result<Loaded> {
    return Loaded{.scene = make(), .title = title, .remarks = {}};
  };
}

}  // namespace

std::vector<DemoScene> demoScenes() {
  const QString kidney = QCoreApplication::translate("DemoScenes", "Kidney");
  return {{QStringLiteral("kidney"), kidney, modelled(kidney, model::kidneyDemo)}};
}

}  // namespace sline::widgets
