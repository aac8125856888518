// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/package_options.h"

#include <QtGlobal>
#include <array>

#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"

namespace sline::render {

namespace {

constexpr ExportOption find{
    .id = "questionsFind",
    .flag = "--find-questions,!--no-find-questions",
    .help = "Questions name something and ask where it is in the picture",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Where is it?"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Questions that name something and ask where it is in the picture"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<PackageOptions>().find; })};

constexpr ExportOption name{
    .id = "questionsName",
    .flag = "--name-questions,!--no-name-questions",
    .help = "Questions mark a place and ask for its name, in any language that is known",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "What is it called?"),
    .tip = QT_TRANSLATE_NOOP(
        "sline::render::ExportOption",
        "Questions that mark a place and ask for its name: in any language that is known"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<PackageOptions>().name; })};

constexpr ExportOption choose{
    .id = "questionsChoose",
    .flag = "--choose-questions,!--no-choose-questions",
    .help = "Questions mark a place and give names to choose from",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Which of these is it?"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Questions that mark a place and give names to choose from"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<PackageOptions>().choose; })};

}  // namespace

OptionList questionOptions() {
  static constexpr std::array all{&viewsOption, &find,        &name,
                                  &choose,      &askedOption, &askedNamesOption};
  return all;
}

bool hasQuestions(const PackageOptions& options) {
  return options.find || options.name || options.choose;
}

}  // namespace sline::render
