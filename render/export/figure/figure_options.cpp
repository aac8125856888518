// SPDX-License-Identifier: Apache-2.0
#include "render/export/figure/figure_options.h"

#include <QtGlobal>
#include <array>
#include <vector>

#include "render/export/order/common_options.h"
#include "render/export/pixels/pixel_options.h"

namespace sline::render {

namespace {

constexpr ExportOption resolution{
    .id = "dpi",
    .flag = "--dpi",
    .value = "N",
    .help = "Pixels to the inch, for png and tiff",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Resolution"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Pixels to the inch of PNG and TIFF; journals ask for 300 or 600, and "
                             "for up to 1200 where there are lines alone"),
    .kind =
        numberWithin(dpiLimits, 0, 100.0, QT_TRANSLATE_NOOP("sline::render::ExportOption", "dpi")),
    .field = boundTo([](auto& o) -> auto& { return o.page.dpi; })};

constexpr std::array depths{
    OptionChoice{
        .id = "8", .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "8 bits"), .value = 8},
    OptionChoice{.id = "1",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "1 bit, ink or paper"),
                 .value = 1}};

constexpr ExportOption depth{
    .id = "bits",
    .flag = "--bits",
    .help =
        "Of a channel of png and tiff; 1 is for a figure with \"black_and_white\", whose pixels "
        "are black or white in any case",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "&Depth"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "1 bit is for black and white figures, as printers take line art"),
    .kind = ChoiceOption{depths},
    .field = boundTo([](auto& o) -> auto& { return o.template of<PixelOptions>().bits; })};

}  // namespace

OptionList figureOptions() {
  static const std::vector<const ExportOption*> all = [] {
    std::vector<const ExportOption*> options{&resolution, &depth};
    options.insert(options.end(), creditOptions().begin(), creditOptions().end());
    return options;
  }();
  return all;
}

ExportOrder usualFigureOrder() {
  ExportOrder order;
  order.page.dpi = PagePixels().dpi;
  return order;
}

PagePixels pixelsOf(const ExportOrder& order, bool blackAndWhite) {
  return {.dpi = order.page.dpi, .inkAlone = blackAndWhite, .bits = order.of<PixelOptions>().bits};
}

bool samePage(const ExportOrder& one, const ExportOrder& other) {
  return one.sourcesInPicture() == other.sourcesInPicture() &&
         one.of<PixelOptions>().bits == other.of<PixelOptions>().bits;
}

Status checkFigureOptions(const ExportOrder& order, bool blackAndWhite) {
  if (order.of<PixelOptions>().bits != 1 || blackAndWhite)
    return Unit{};
  return Error{.reason = "a depth of 1 bit leaves black and white alone, and the figure has tones",
               .remedy = "Let the figure be black and white, or take 8 bits"};
}

}  // namespace sline::render
