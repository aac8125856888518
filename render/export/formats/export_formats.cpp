// SPDX-License-Identifier: Apache-2.0
#include "render/export/formats/export_formats.h"

#include <array>

#include "render/export/svg/svg_file.h"

namespace sline::render {

std::span<const ExportFormat> exportFormats() {
  static constexpr std::array formats{
      ExportFormat{"svg", "Scalable Vector Graphics",
                   "Vectors for Inkscape, Illustrator and print: lines and hatching as smooth "
                   "paths, hidden ones removed, a named group for each structure",
                   "svg", writeSvg},
  };
  return formats;
}

}  // namespace sline::render
