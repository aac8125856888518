// SPDX-License-Identifier: Apache-2.0
#include "render/export/formats/export_formats.h"

#include <array>

#include "render/export/pixels/pixel_files.h"
#include "render/export/svg/svg_file.h"

namespace sline::render {

std::span<const ExportFormat> exportFormats() {
  static constexpr std::array formats{
      ExportFormat{"png", "Portable Network Graphics",
                   "A picture made of pixels for screens, documents and print: sRGB, grey or pure "
                   "ink, 8 or 16 bits, transparent where asked for",
                   "png", writePng},
      ExportFormat{"tiff", "Tagged Image File Format",
                   "The same for printers and journals, with its colour profile", "tiff",
                   writeTiff},
      ExportFormat{"jpeg", "JPEG", "A picture made of pixels where files must be small; on white",
                   "jpg", writeJpeg},
      ExportFormat{"exr", "OpenEXR",
                   "A picture in linear light, as halves with alpha multiplied in, for compositing",
                   "exr", writeExr},
      ExportFormat{"svg", "Scalable Vector Graphics",
                   "Vectors for Inkscape, Illustrator and print: lines and hatching as smooth "
                   "paths, hidden ones removed, a named group for each structure",
                   "svg", writeSvg},
  };
  return formats;
}

}  // namespace sline::render
