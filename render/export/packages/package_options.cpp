// SPDX-License-Identifier: Apache-2.0
#include "render/export/packages/package_options.h"

#include <QtGlobal>
#include <array>
#include <vector>

#include "render/export/order/test_options.h"
#include "render/export/order/view_orders.h"
#include "render/export/students/students_options.h"

namespace sline::render {

namespace {

constexpr ExportOption passing{
    .id = "passing",
    .flag = "--pass",
    .value = "PERCENT",
    .help = "How many of the answers must be right to pass",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Passed from"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "The share of right answers that the learning system takes as passed"),
    .kind = NumberOption{.low = 0.0, .high = 100.0, .decimals = 0, .step = 5.0, .unit = "%"},
    .field = boundTo([](auto& o) -> auto& { return o.template of<PackageOptions>().passing; })};

}  // namespace

QuestionKinds questionKinds(const ExportOrder& order) {
  const auto& options = order.of<StudentsOptions>();
  return {options.find, options.name, options.choose};
}

OptionList questionOptions() {
  static constexpr std::array all{&viewsOption,      &quizFindOption, &quizNameOption,
                                  &quizChooseOption, &askedOption,    &askedNamesOption};
  return all;
}

OptionList questionSetOptions() {
  static constexpr std::array all{&viewsOption,      &quizFindOption, &quizNameOption,
                                  &quizChooseOption, &askedOption,    &askedNamesOption,
                                  &passing};
  return all;
}

OptionList pagePackageOptions() {
  static const std::vector<const ExportOption*> all = [] {
    const OptionList page = studentsOptions();
    std::vector<const ExportOption*> options(page.begin(), page.end());
    options.push_back(&passing);
    return options;
  }();
  return all;
}

}  // namespace sline::render
