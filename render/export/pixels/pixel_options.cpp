// SPDX-License-Identifier: Apache-2.0
#include "render/export/pixels/pixel_options.h"

#include <QtGlobal>
#include <array>

namespace sline::render {

namespace {

constexpr std::array depths{
    OptionChoice{
        .id = "8", .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "8 bits"), .value = 8},
    OptionChoice{.id = "16",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "16 bits"),
                 .value = 16},
    OptionChoice{.id = "1", .value = 1}};

constexpr std::array sampleCounts{
    OptionChoice{.id = "auto", .value = 0}, OptionChoice{.id = "1", .value = 1},
    OptionChoice{.id = "2", .value = 2}, OptionChoice{.id = "3", .value = 3},
    OptionChoice{.id = "4", .value = mostSamples}};

}  // namespace

constinit const ExportOption depthOption{
    .id = "bits",
    .flag = "--bits",
    .help = "Of a channel; 1 needs --bw",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "&Depth"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Of each colour; 16 bits for work that follows"),
    .kind = ChoiceOption{depths},
    .field = boundTo([](auto& o) -> auto& { return o.template of<PixelOptions>().bits; })};

constinit const ExportOption greyOption{
    .id = "grey",
    .flag = "--grey,--gray",
    .help = "Without colours",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "&Grey"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Without colours, with a grey profile"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<PixelOptions>().grey; })};

constinit const ExportOption samplesOption{
    .id = "samples",
    .flag = "--samples",
    .help =
        "Draws this many times as large both ways and averages, for smooth edges; auto decides by "
        "the size",
    .kind = ChoiceOption{sampleCounts},
    .field = boundTo([](auto& o) -> auto& { return o.template of<PixelOptions>().samples; })};

}  // namespace sline::render
