// SPDX-License-Identifier: Apache-2.0
#include "app/cli/draw_scene.h"

namespace sline::cli {

Exit drawScene(const model::Scene& scene, const PictureOrder& given, Progress& progress) {
  const model::Scene saved = asSaved(scene, given);
  PictureOrder order = given;
  if (const Status ready = prepareLabels(order.labels, saved, order.size.aspect()); !ready.ok())
    return complain(ready.error(), Exit::failed);
  const Result<model::Scene> focus = inFocus(saved, order);
  if (!focus.ok())
    return complain(focus.error(), Exit::wrongUse);
  const Result<model::Scene> dressed = styled(*focus, order);
  if (!dressed.ok())
    return complain(dressed.error(), Exit::wrongUse);
  const Result<model::Scene> cut = cutOpen(*dressed, order);
  if (!cut.ok())
    return complain(cut.error(), Exit::wrongUse);
  const Result<model::Camera> camera = cameraFor(*cut, order);
  if (!camera.ok())
    return complain(camera.error(), Exit::wrongUse);
  const Status drawn = drawToFile(*cut, *camera, order, progress);
  if (!drawn.ok()) {
    progress.wipe();
    return complain(drawn.error(), Exit::failed);
  }
  return Exit::done;
}

}  // namespace sline::cli
