// SPDX-License-Identifier: Apache-2.0
#include "app/cli/flags/page_flags.h"

#include <CLI/CLI.hpp>
#include <charconv>

#include "app/cli/flags/option_kinds.h"
#include "app/cli/flags/values.h"
#include "render/vectors/vector_drawing.h"

namespace sline::cli {

namespace {

/// Reads "160x90", each side within the limits of a page.
Result<glm::vec2> parsePage(std::string_view text) {
  const auto side = [](std::string_view part) -> std::optional<float> {
    float value = 0.0f;
    const auto [end, fault] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (fault != std::errc() || end != part.data() + part.size() ||
        !render::pageLimitsMm.contain(value))
      return std::nullopt;
    return value;
  };
  const std::size_t cross = text.find('x');
  if (cross != std::string_view::npos) {
    const std::optional<float> width = side(text.substr(0, cross));
    const std::optional<float> height = side(text.substr(cross + 1));
    if (width && height)
      return glm::vec2(*width, *height);
  }
  return Error{.reason = "\"" + std::string(text) + "\" is no size of a page",
               .remedy = "Write width and height in millimetres, " +
                         std::to_string(int(render::pageLimitsMm.low)) + " to " +
                         std::to_string(int(render::pageLimitsMm.high)) + " each, as in 160x90"};
}

}  // namespace

void declarePage(CLI::App& command, PageFlags& flags) {
  command.add_option("--size-mm", flags.sizeMm, "Width and height of the page in millimetres")
      ->type_name("WxH")
      ->capture_default_str();
  command
      .add_option("--size-px", flags.sizePx,
                  "Width and height in pixels instead, " +
                      std::to_string(render::pixelSideLimits.low) + " to " +
                      std::to_string(render::pixelSideLimits.high) +
                      " each; the page is as large as they are at --dpi")
      ->type_name("WxH")
      ->excludes("--size-mm");
  command.add_option("--dpi", flags.dpi, "Pixels to the inch, for pictures made of pixels")
      ->type_name("N")
      ->check(within(render::dpiLimits))
      ->capture_default_str();
}

Result<render::ExportPage> parseFlags(const PageFlags& flags) {
  if (flags.sizePx.empty()) {
    const glm::vec2 size = TRY(parsePage(flags.sizeMm));
    return render::ExportPage{.sizeMm = size, .dpi = float(flags.dpi)};
  }
  const Size size = TRY(parseSize(flags.sizePx));
  const float pixel = render::millimetresPerInch / float(flags.dpi);
  return render::ExportPage{.sizeMm = pixel * glm::vec2(float(size.width), float(size.height)),
                            .dpi = float(flags.dpi)};
}

}  // namespace sline::cli
