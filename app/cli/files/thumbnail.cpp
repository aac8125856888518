// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/thumbnail.h"

#include "app/cli/files/progress.h"
#include "render/export/encoding/png_image.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::cli {

namespace {
constexpr int side = 256;
constexpr int samples = 2;  // across a pixel

Result<std::string> drawThumbnail(const model::Scene& scene) {
  const auto picture = render::HeadlessPicture::create();
  if (!picture.ok())
    return picture.error();
  const model::Camera camera =
      scene.views().empty()
          ? model::anatomicalCamera(model::AnatomicalView::anterior, scene.visibleBounds(), 1.0f)
          : scene.views().front().camera;
  const Result<render::Image> image =
      (*picture)->render(scene, camera, {.width = side, .height = side}, samples);
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
