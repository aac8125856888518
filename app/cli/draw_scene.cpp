// SPDX-License-Identifier: Apache-2.0
#include "app/cli/draw_scene.h"

namespace sline::cli {

Result<ArrangedScene> arrangedFor(const model::Scene& scene, const PictureOrder& order) {
  const Result<model::Scene> focus = inFocus(asSaved(scene, order), order);
  if (!focus.ok())
    return focus.error();
  const Result<model::Scene> dressed = styled(*focus, order);
  if (!dressed.ok())
    return dressed.error();
  const Result<model::Scene> cut = cutOpen(*dressed, order);
  if (!cut.ok())
    return cut.error();
  const Result<model::Camera> camera = cameraFor(*cut, order);
  if (!camera.ok())
    return camera.error();
  return ArrangedScene{*cut, *camera};
}

Exit drawScene(const model::Scene& scene, const PictureOrder& given, Progress& progress) {
  PictureOrder order = given;
  if (const Status ready = prepareLabels(order.labels, asSaved(scene, given), order.size.aspect());
      !ready.ok())
    return complain(ready.error(), Exit::failed);
  const Result<ArrangedScene> arranged = arrangedFor(scene, order);
  if (!arranged.ok())
    return complain(arranged.error(), Exit::wrongUse);
  const Status drawn = drawToFile(arranged->scene, arranged->camera, order, progress);
  if (!drawn.ok()) {
    progress.wipe();
    return complain(drawn.error(), Exit::failed);
  }
  return Exit::done;
}

}  // namespace sline::cli
