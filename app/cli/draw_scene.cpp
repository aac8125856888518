// SPDX-License-Identifier: Apache-2.0
#include "app/cli/draw_scene.h"

#include "app/cli/flags/drawing_flags.h"
#include "model/edit/look.h"
#include "render/lettering/looks_in_colour.h"

namespace sline::cli {

namespace {
/// Does the same as `arrangedFor` for a scene that `asSaved` returned.
Result<ArrangedScene> arrangeShownScene(const model::Scene& shown, const PictureSpec& spec) {
  const model::Scene focus = TRY(inFocus(shown, spec));
  const model::Scene drawn = TRY(inDrawingStyle(focus, spec));
  PictureSpec colours = spec;
  colours.blackAndWhite = false;
  const model::Scene dressed = TRY(styled(drawn, colours));
  const model::Scene cut = TRY(cutOpen(dressed, spec));
  const model::Camera camera = TRY(cameraFor(cut, spec));
  if (!spec.blackAndWhite)
    return ArrangedScene{cut, camera, {}};
  return ArrangedScene{model::withInkAlone(cut).scene, camera, render::looksInColour(cut)};
}
}  // namespace

Result<ArrangedScene> arrangeScene(const model::Scene& scene, const PictureSpec& given) {
  PictureSpec spec = given;
  const Result<model::Scene> shown = withOpeningLook(withSavedView(scene, spec), spec);
  return shown.ok() ? arrangeShownScene(*shown, spec) : Result<ArrangedScene>(shown.error());
}

Result<ArrangedScene> arrangeOnPage(const glm::vec2& pageMm, const model::Scene& scene,
                                    PictureSpec& spec) {
  const model::Scene shown = TRY(withOpeningLook(withSavedView(scene, spec), spec));
  spec.labels.viewName = shownViewName(scene, spec);
  spec.labels.words = shownViewWords(scene, spec);
  TRY(prepareLabels(spec.labels, shown, pageMm));
  Result<ArrangedScene> arranged = arrangeShownScene(shown, spec);
  if (arranged.ok())
    spec.labels.style.inColour = arranged->inColour;
  return arranged;
}

Exit drawScene(const model::Scene& scene, const PictureSpec& given, Progress& progress) {
  PictureSpec spec = given;
  const float height = render::usualHeightMm;
  const Result<ArrangedScene> arranged =
      arrangeOnPage({height * spec.size.aspect(), height}, scene, spec);
  if (!arranged.ok())
    return complain(arranged.error(), Exit::wrongUse);
  const Status drawn = drawToFile(arranged->scene, arranged->camera, spec, progress);
  if (!drawn.ok()) {
    progress.wipe();
    return complain(drawn.error(), Exit::failed);
  }
  return Exit::done;
}

}  // namespace sline::cli
