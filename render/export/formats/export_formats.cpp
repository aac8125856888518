// SPDX-License-Identifier: Apache-2.0
#include "render/export/formats/export_formats.h"

#include <array>

#include "render/export/pdf/pdf_file.h"
#include "render/export/svg/svg_file.h"

namespace sline::render {

std::span<const ExportFormat> exportFormats() {
  static constexpr std::array formats{
      ExportFormat{"svg", "Scalable Vector Graphics",
                   "Vectors for Inkscape, Illustrator and print: lines and hatching as smooth "
                   "paths, hidden ones removed, a named group for each structure",
                   "svg", writeSvg},
      ExportFormat{"pdf", "Portable Document Format",
                   "The same vectors on a page of their own, or a sheet with title, legend and "
                   "numbered labels, a page to test oneself and its key (--sheet)",
                   "pdf", writePdf},
  };
  return formats;
}

}  // namespace sline::render
