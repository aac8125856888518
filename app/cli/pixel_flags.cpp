// SPDX-License-Identifier: Apache-2.0
#include "app/cli/pixel_flags.h"

#include "app/cli/values.h"

namespace sline::cli {

Result<render::ExportPixels> understood(const PixelFlags& flags, bool blackAndWhite) {
  const Result<std::optional<int>> samples = parseSamples(flags.samples);
  if (!samples.ok())
    return samples.error();
  if (flags.bits != 1 && flags.bits != 8 && flags.bits != 16)
    return Error{.reason = "--bits " + std::to_string(flags.bits) + " is no depth of a picture",
                 .remedy = "Give 8 or 16, or 1 with --bw"};
  if (flags.bits == 1 && !blackAndWhite)
    return Error{.reason = "--bits 1 leaves black and white alone",
                 .remedy = "Give --bw, too, which draws the scene for that"};
  return render::ExportPixels{.bits = flags.bits,
                              .grey = flags.grey,
                              .pureInk = blackAndWhite,
                              .samples = samples->value_or(0)};
}

Result<std::optional<render::ExportPage>> pageOf(const PixelFlags& flags) {
  if (flags.sizePx.empty())
    return std::optional<render::ExportPage>();
  const Result<Size> size = parseSize(flags.sizePx);
  if (!size.ok())
    return size.error();
  const float pixel = render::millimetresPerInch / float(flags.dpi);
  return std::optional(
      render::ExportPage{.sizeMm = pixel * glm::vec2(float(size->width), float(size->height)),
                         .dpi = float(flags.dpi)});
}

}  // namespace sline::cli
