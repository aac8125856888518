// SPDX-License-Identifier: Apache-2.0
#include "app/cli/thumbnail.h"

#include "app/cli/progress.h"
#include "render/export/pixels/image_file.h"
#include "render/gpu/headless/context.h"
#include "render/picture/picture.h"

namespace sline::cli {

namespace {
constexpr int side = 256;
constexpr int samples = 2;  // across a pixel

Result<std::string> drawn(const model::Scene& scene) {
  const auto context = render::gpu::HeadlessContext::create();
  if (!context.ok())
    return context.error();
  const auto picture = render::Picture::create();
  if (!picture.ok())
    return picture.error();
  const model::Camera camera =
      scene.views().empty()
          ? model::anatomicalCamera(model::AnatomicalView::anterior, scene.visibleBounds(), 1.0f)
          : scene.views().front().camera;
  const Result<render::Image> image =
      (*picture)->render(scene, camera, {.width = samples * side, .height = samples * side});
  return image.ok() ? render::pngBytes(render::averaged(*image, samples))
                    : Result<std::string>(image.error());
}
}  // namespace

std::string thumbnailOf(const model::Scene& scene) {
  Result<std::string> png = drawn(scene);
  if (png.ok())
    return std::move(*png);
  warn("the scene file gets no thumbnail: " + png.error().text());
  return {};
}

}  // namespace sline::cli
