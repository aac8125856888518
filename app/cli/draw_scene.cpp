// SPDX-License-Identifier: Apache-2.0
#include "app/cli/draw_scene.h"

#include "app/cli/flags/drawing_flags.h"

namespace sline::cli {

namespace {
/// Does the same as `arrangedFor` for a scene that `asSaved` returned.
Result<ArrangedScene> arrangeShownScene(const model::Scene& shown, const PictureSpec& spec) {
  const Result<model::Scene> focus = inFocus(shown, spec);
  if (!focus.ok())
    return focus.error();
  const Result<model::Scene> drawn = inDrawingStyle(*focus, spec);
  if (!drawn.ok())
    return drawn.error();
  const Result<model::Scene> dressed = styled(*drawn, spec);
  if (!dressed.ok())
    return dressed.error();
  const Result<model::Scene> cut = cutOpen(*dressed, spec);
  if (!cut.ok())
    return cut.error();
  const Result<model::Camera> camera = cameraFor(*cut, spec);
  if (!camera.ok())
    return camera.error();
  ArrangedScene arranged{*cut, *camera, nullptr};
  if (spec.blackAndWhite) {
    PictureSpec coloured = spec;
    coloured.blackAndWhite = false;
    const Result<model::Scene> colours = styled(*drawn, coloured);
    const Result<model::Scene> open = colours.ok() ? cutOpen(*colours, coloured) : colours;
    if (!open.ok())
      return open.error();
    arranged.inColour = std::make_shared<const model::Scene>(*open);
  }
  return arranged;
}
}  // namespace

Result<ArrangedScene> arrangeScene(const model::Scene& scene, const PictureSpec& given) {
  PictureSpec spec = given;
  const Result<model::Scene> shown = withOpeningLook(withSavedView(scene, spec), spec);
  return shown.ok() ? arrangeShownScene(*shown, spec) : Result<ArrangedScene>(shown.error());
}

Result<ArrangedScene> arrangeOnPage(const glm::vec2& pageMm, const model::Scene& scene,
                                    PictureSpec& spec) {
  const Result<model::Scene> shown = withOpeningLook(withSavedView(scene, spec), spec);
  if (!shown.ok())
    return shown.error();
  spec.labels.viewName = shownViewName(scene, spec);
  spec.labels.words = shownViewWords(scene, spec);
  if (const Status ready = prepareLabels(spec.labels, *shown, pageMm); !ready.ok())
    return ready.error();
  return arrangeShownScene(*shown, spec);
}

Exit drawScene(const model::Scene& scene, const PictureSpec& given, Progress& progress) {
  PictureSpec spec = given;
  const float height = render::usualHeightMm;
  const Result<ArrangedScene> arranged =
      arrangeOnPage({height * spec.size.aspect(), height}, scene, spec);
  if (!arranged.ok())
    return complain(arranged.error(), Exit::wrongUse);
  spec.labels.inColour = arranged->inColour;
  const Status drawn = drawToFile(arranged->scene, arranged->camera, spec, progress);
  if (!drawn.ok()) {
    progress.wipe();
    return complain(drawn.error(), Exit::failed);
  }
  return Exit::done;
}

}  // namespace sline::cli
