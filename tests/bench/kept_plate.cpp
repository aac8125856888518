// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/kept_plate.h"

#include <cmath>
#include <fstream>

#include "render/export/encoding/png_image.h"
#include "render/export/plate/plate_image.h"

namespace sline::bench {

Status keepPlate(render::Picture& picture, const render::ExportOrder& order,
                 const render::Typesetting& typesetting, const KeptPlate& kept) {
  const glm::vec2 size = order.page.sizeMm;
  auto image = picture.render(order.scene, order.camera,
                              {.width = int(std::lround(float(kept.height) * size.x / size.y)),
                               .height = kept.height,
                               .environment = order.environment},
                              2);
  if (!image)
    return image.error();
  render::drawPlate(*image, order, typesetting);
  const auto png = render::pngOf(*image, {});
  if (!png)
    return png.error();
  std::ofstream(kept.path, std::ios::binary) << *png;
  return Unit{};
}

}  // namespace sline::bench
