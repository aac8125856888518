// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/students_page.h"

#include <cmath>
#include <utility>
#include <vector>

#include "model/packed_scene/packed_scene.h"
#include "render/export/students/found_labels.h"
#include "render/export/students/page_assembly.h"
#include "render/export/students/page_facts.h"
#include "render/export/students/page_order.h"
#include "render/export/students/page_stills.h"
#include "render/export/students/web_program.h"
#include "render/lettering/typesetting.h"

namespace sline::render {

namespace {

/// Returns "0.21", rounded up.
std::string hundredths(float millimetres) {
  const int whole = int(std::ceil(100.0f * millimetres));
  const std::string text = std::to_string(100 + whole % 100);
  return std::to_string(whole / 100) + '.' + text.substr(1);
}

}  // namespace

Result<StudentsPage> studentsPage(const ExportOrder& order, const StudentsOptions& own,
                                  const ExportProgress& progress) {
  const PageTemplate page = TRY(pageTemplate());
  const auto typesetting = TRY(Typesetting::create());  // as long as text is set
  const auto goesOn = [&progress](double share, const char* what) {
    return !progress || progress(share, what);
  };
  if (!goesOn(0.0, "simplifying surfaces"))
    return givenUp({});
  ExportOrder shown = pageOrder(order);
  SimplifiedScene simple = simplifiedScene(shown.scene, own, progress);
  shown.scene = std::move(simple.scene);
  if (simple.errorMm > 0.0f)
    progress.note({.kind = ExportNote::Kind::pageSimplified,
                   .names = {},
                   .detail = hundredths(simple.errorMm)});
  if (!goesOn(0.1, "packing the scene"))
    return givenUp({});
  const bool found = shown.of<StudentsOptions>().foundLabels;
  const model::PackedScene packed = model::packedScene(
      found ? withAllLabels(shown.scene) : shown.scene,
      {.later = laterStructures(shown.scene), .names = own.quiz != QuizMode::only});
  const PageWords words(shown, own);
  if (!goesOn(0.2, "describing pictures"))
    return givenUp({});
  const std::vector<WordsByLanguage> seen = descriptionsOfViews(shown, words);
  const std::string stills = TRY(pageStills(shown, words, seen, progress));
  std::vector<PageQuestion> questions = pageQuestions(shown, own, words);
  if (own.quiz != QuizMode::off && questions.empty())
    progress.note({.kind = ExportNote::Kind::quizEmpty, .names = {}, .detail = {}});
  if (!goesOn(0.85, "writing the page"))
    return givenUp({});
  AssembledPage made = assembledPage(
      page,
      {.language = words.language(),
       .title = words.title(),
       .stills = stills,
       .facts = pageFacts(
           shown, own,
           {.simplifiedMm = simple.errorMm, .views = seen, .questions = std::move(questions)}),
       .scene = packed.first,
       .context = packed.rest},
      {.folder = own.folder, .report = own.report});
  return StudentsPage{.html = std::move(made.html),
                      .files = std::move(made.files),
                      .title = words.title(),
                      .language = words.language()};
}

}  // namespace sline::render
