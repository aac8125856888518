// SPDX-License-Identifier: Apache-2.0
#include "app/cli/draw_scene.h"

namespace sline::cli {

namespace {
/// Does the same as `arrangedFor` for a scene that `asSaved` returned.
Result<ArrangedScene> arrangedShown(const model::Scene& shown, const PictureOrder& order) {
  const Result<model::Scene> focus = inFocus(shown, order);
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
}  // namespace

Result<ArrangedScene> arrangedFor(const model::Scene& scene, const PictureOrder& order) {
  return arrangedShown(asSaved(scene, order), order);
}

Result<ArrangedScene> arrangedOn(const glm::vec2& pageMm, const model::Scene& scene,
                                 PictureOrder& order) {
  const model::Scene shown = asSaved(scene, order);
  order.labels.viewName = shownViewName(scene, order);
  if (const Status ready = prepareLabels(order.labels, shown, pageMm); !ready.ok())
    return ready.error();
  return arrangedShown(shown, order);
}

Exit drawScene(const model::Scene& scene, const PictureOrder& given, Progress& progress) {
  PictureOrder order = given;
  const float height = render::usualHeightMm;
  const Result<ArrangedScene> arranged =
      arrangedOn({height * order.size.aspect(), height}, scene, order);
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
