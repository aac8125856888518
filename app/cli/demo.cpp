// SPDX-License-Identifier: Apache-2.0
// `sline demo`: a scene that the program models itself.
#include "app/cli/command.h"
#include "app/cli/draw_scene.h"
#include "app/cli/picture_options.h"
#include "model/demo/kidney.h"
#include "model/demo/pelvis.h"

namespace sline::cli {

namespace {

struct DemoFlags {
  std::string scene = "kidney";
  PictureFlags picture;
};

Exit runDemo(const DemoFlags& flags) {
  const Result<PictureOrder> order = understood(flags.picture);
  if (!order.ok())
    return complain(order.error(), Exit::wrongUse);
  Progress progress;
  return drawScene(flags.scene == "kidney" ? model::kidneyDemo() : model::pelvisDemo(flags.scene == "pelvis" ? model::Sex::male : model::Sex::female), *order, progress);
}

void declareDemo(CLI::App& command, DemoFlags& flags) {
  command
      .add_option(
          "SCENE", flags.scene,
          "kidney: a left kidney with its artery, vein and ureter, no patient's but modelled")
      ->check(CLI::IsMember({"kidney", "pelvis", "pelvis-female"}))
      ->capture_default_str();
  addPictureOptions(command, flags.picture);
}

}  // namespace

void addDemo(CLI::App& program, Exit& exit) {
  addCommand<DemoFlags>(program, exit,
                        {"demo", "Draw a picture of a scene modelled by the program"}, declareDemo,
                        runDemo);
}

}  // namespace sline::cli
