// SPDX-License-Identifier: Apache-2.0
#include "render/export/slides/slide_options.h"

#include <QtGlobal>
#include <array>

#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"

namespace sline::render {

namespace {

constexpr std::array shapes{
    OptionChoice{.id = "16:9",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "16 : 9"),
                 .value = int(SlideShape::wide)},
    OptionChoice{.id = "4:3",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "4 : 3"),
                 .value = int(SlideShape::standard)}};

constexpr ExportOption onClick{
    .id = "slideOnClick",
    .flag = "--on-click,!--no-on-click",
    .help = "Labels of slides appear one by one, each with a click, in the scene's order",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Labels by clicks"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Labels appear one by one, each with a click, in the scene's order"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<SlideOptions>().onClick; })};

constexpr ExportOption selfTest{
    .id = "slideSelfTest",
    .flag = "--self-test,!--no-self-test",
    .help = "After each slide with labels one that has numbers in their place, and then its key",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Self-test"),
    .tip = QT_TRANSLATE_NOOP(
        "sline::render::ExportOption",
        "After each slide one with numbers in place of its labels, and then the key"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<SlideOptions>().selfTest; })};

}  // namespace

constinit const ExportOption slideShapeOption{
    .id = "slideShape",
    .flag = "--slide-shape",
    .help = "Width and height of slides",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Shape of slides"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Width and height of a slide"),
    .kind = ChoiceOption{shapes},
    .field = boundTo([](auto& o) -> auto& { return o.template of<SlideOptions>().shape; })};

OptionList slideOptions() {
  static constexpr std::array all{&viewsOption, &slideShapeOption, &onClick,
                                  &selfTest,    &askedOption,      &askedNamesOption};
  return all;
}

}  // namespace sline::render
