// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/thumbnail.h"

#include "app/cli/files/progress.h"
#include "model/edit/look.h"
#include "model/look/opening_look.h"
#include "render/export/encoding/png_image.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::cli {

namespace {
constexpr int side = 256;
constexpr int samples = 2;  // across a pixel

struct Sight {
  model::Scene scene;
  model::Camera camera;
};

/// Returns the scene as it opens.
Sight openingSight(const model::Scene& scene) {
  model::OpeningWishes wishes{.aspect = 1.0f};
  if (!scene.views().empty())
    wishes.camera = scene.views().front().camera;
  model::FormIndex forms;
  if (model::hasNoLook(scene))
    if (auto look = model::openingLook(scene, forms, wishes))
      return {std::move(look->scene), look->camera};
  const model::Camera front =
      model::anatomicalCamera(model::AnatomicalView::anterior, scene.visibleBounds(), 1.0f);
  return {scene, wishes.camera.value_or(front)};
}

Result<std::string> drawThumbnail(const model::Scene& scene) {
  const auto picture = TRY(render::HeadlessPicture::create());
  const Sight sight = openingSight(scene);
  const Result<render::Image> image =
      picture->render(sight.scene, sight.camera, {.width = side, .height = side}, samples);
  return image.ok() ? render::pngOf(*image) : Result<std::string>(image.error());
}
}  // namespace

std::string thumbnailOf(const model::Scene& scene) {
  Result<std::string> png = drawThumbnail(scene);
  if (png.ok())
    return std::move(*png);
  warn("the scene file gets no thumbnail: " + png.error().text());
  return {};
}

}  // namespace sline::cli
