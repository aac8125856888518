// SPDX-License-Identifier: Apache-2.0
#include "render/export/students/students_options.h"

#include <QtGlobal>
#include <array>

#include "render/export/order/test_options.h"

namespace sline::render {

namespace {

constexpr std::array quizModes{
    OptionChoice{
        .id = "beside",
        .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Beside names and labels"),
        .value = int(QuizMode::beside)},
    OptionChoice{.id = "only",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Nothing else, no names"),
                 .value = int(QuizMode::only)},
    OptionChoice{.id = "off",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "None"),
                 .value = int(QuizMode::off)}};

bool hasQuiz(const ExportOrder& order) {
  return order.of<StudentsOptions>().quiz != QuizMode::off;
}

/// Tells whether questions may have names in them.
bool namesAreShown(const ExportOrder& order) {
  return order.of<StudentsOptions>().quiz == QuizMode::beside;
}

constexpr ExportOption quiz{
    .id = "pageQuiz",
    .flag = "--quiz",
    .help =
        "The page's quiz: beside names and labels; only the quiz, with no name of a structure in "
        "the file in clear and only questions whose answers are typed; or off",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "&Quiz"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "What the page asks; alone, no name of a structure is in its file"),
    .kind = ChoiceOption{quizModes},
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().quiz; })};

constexpr ExportOption order{
    .id = "pageOrder",
    .flag = "--quiz-order,!--no-quiz-order",
    .help = "The page's quiz asks for the order of a group's vessels along their path",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Order along a path"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Where a group is a chain of vessels, the quiz asks for their order"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().order; }),
    .applies = namesAreShown};

constexpr ExportOption drag{
    .id = "pageDrag",
    .flag = "--quiz-drag,!--no-quiz-drag",
    .help = "The page's quiz asks to drag labels to what they name",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Labels to their places"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Labels are dragged to what they name"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().drag; }),
    .applies = namesAreShown};

constexpr ExportOption counts{
    .id = "pageCounts",
    .flag = "--quiz-counts,!--no-quiz-counts",
    .help = "Answers to the page's quiz count towards a score",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Answers count"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "The page tells how many were right"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().counts; }),
    .applies = hasQuiz};

constexpr ExportOption lockCamera{
    .id = "pageLockCamera",
    .flag = "--lock-camera,!--no-lock-camera",
    .help = "While the page asks something, the anatomy cannot be turned",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "No turning meanwhile"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "While something is asked, the anatomy cannot be turned"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().lockCamera; }),
    .applies = hasQuiz};

constexpr ExportOption lockLook{
    .id = "pageLockLook",
    .flag = "--lock-look,!--no-lock-look",
    .help = "While the page asks something, nothing can be hidden and no Γ changed",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "No hiding meanwhile"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "While something is asked, nothing can be hidden and no Γ changed"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().lockLook; }),
    .applies = hasQuiz};

constexpr ExportOption title{
    .id = "pageTitle",
    .flag = "--page-title",
    .value = "TEXT",
    .help = "The page's title; else what the group that holds all is called, or the file",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Title of the page"),
    .tip = QT_TRANSLATE_NOOP(
        "sline::render::ExportOption",
        "Else what the group that holds all is called, or where there is none the file"),
    .kind = TextOption{.longest = 200},
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().title; }),
    .kept = false};

constexpr ExportOption languages{
    .id = "pageLanguages",
    .flag = "--page-languages",
    .value = "TAGS",
    .help =
        "Languages in which the page names structures, as in de,la; all in which there are names "
        "or texts if not given. --language is the one in which it opens",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Languages"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "As in “de, la”; empty: all in which there are names"),
    .kind = TextOption{.longest = 100},
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().languages; })};

constexpr ExportOption triangles{
    .id = "pageTriangles",
    .flag = "--page-triangles",
    .value = "N",
    .help =
        "Surfaces of the page have at most so many triangles together; how far they are off is "
        "said in the page. 0: as many as there are",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Triangles at most"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Fewer make a smaller file and a quicker page; 0: all there are"),
    .kind = NumberOption{.low = 0.0, .high = 100'000'000.0, .decimals = 0, .step = 100'000.0},
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().triangles; }),
    .kept = false};

constexpr ExportOption error{
    .id = "pageError",
    .flag = "--page-error",
    .value = "MM",
    .help =
        "Surfaces of the page may be off by so many millimetres, so that they need fewer "
        "triangles. 0: not at all",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Surfaces off by"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "Surfaces that may be a little off need fewer triangles; 0: exact"),
    .kind = NumberOption{.low = 0.0,
                         .high = 20.0,
                         .decimals = 2,
                         .step = 0.1,
                         .unit = QT_TRANSLATE_NOOP("sline::render::ExportOption", "mm")},
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().errorMm; }),
    .kept = false};

}  // namespace

constinit const ExportOption quizFindOption{
    .id = "pageFind",
    .flag = "--quiz-find,!--no-quiz-find",
    .help = "The page's quiz names something, and it is clicked",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Where is it?"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "The quiz names something, and it is clicked"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().find; }),
    .applies = namesAreShown};

constinit const ExportOption quizNameOption{
    .id = "pageName",
    .flag = "--quiz-name,!--no-quiz-name",
    .help = "The page's quiz lights something up, and its name is typed, in any of the languages",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "What is it? Typed"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "The quiz lights something up, and its name is typed"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().name; }),
    .applies = hasQuiz};

constinit const ExportOption quizChooseOption{
    .id = "pageChoose",
    .flag = "--quiz-choose,!--no-quiz-choose",
    .help =
        "The page's quiz lights something up, and its name is chosen among four: others are "
        "neighbours and of the same kind",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "What is it? One of four"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "The other three names are of neighbours and of the same kind"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<StudentsOptions>().choose; }),
    .applies = namesAreShown};

OptionList studentsOptions() {
  static constexpr std::array all{&title,
                                  &languages,
                                  &quiz,
                                  &quizFindOption,
                                  &quizNameOption,
                                  &quizChooseOption,
                                  &order,
                                  &drag,
                                  &askedOption,
                                  &askedNamesOption,
                                  &askCalloutsOption,
                                  &counts,
                                  &lockCamera,
                                  &lockLook,
                                  &triangles,
                                  &error};
  return all;
}

}  // namespace sline::render
