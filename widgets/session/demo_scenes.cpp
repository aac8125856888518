// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/demo_scenes.h"

#include "model/demo/demo.h"
#include "model/disk/cache_folder.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace {

DemoScene demoScene(const QString& title, model::DemoName name, model::Sex sex) {
  const std::string_view id = model::demoNames[std::size_t(name)];
  const std::string_view sexId = model::sexName(sex);
  const auto make = [title, name, sex](const model::ImportProgress&,
                                       const std::stop_token& stop) -> Result<LoadedDocument> {
    std::optional<model::Scene> scene = model::demo(name, sex, model::userCacheFolder(), stop);
    if (!scene)
      return Error{.reason = "modelling was cancelled"};
    return LoadedDocument{.scene = std::move(*scene), .title = title, .remarks = {}};
  };
  return {.id = QStringLiteral("%1-%2").arg(QLatin1String(id.data(), qsizetype(id.size())),
                                            QLatin1String(sexId.data(), qsizetype(sexId.size()))),
          .title = title,
          .key = QString::fromStdString(model::demoKey(name, sex)),
          .make = make};
}

}  // namespace

std::vector<DemoScene> demoScenes() {
  using model::DemoName;
  using model::Sex;
  return {demoScene(tr("Pelvis of a Woman"), DemoName::pelvis, Sex::female),
          demoScene(tr("Pelvis of a Man"), DemoName::pelvis, Sex::male),
          demoScene(tr("Abdomen of a Woman"), DemoName::abdomen, Sex::female),
          demoScene(tr("Abdomen of a Man"), DemoName::abdomen, Sex::male),
          demoScene(tr("Kidney"), DemoName::kidney, Sex::female)};
}

}  // namespace sline::widgets
