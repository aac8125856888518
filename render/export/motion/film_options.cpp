// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film_options.h"

#include <QtGlobal>
#include <array>

namespace sline::render {

namespace {

constexpr std::array motions{
    OptionChoice{.id = "turntable",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Once around"),
                 .value = int(Motion::turntable)},
    OptionChoice{.id = "tour",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "From view to view"),
                 .value = int(Motion::tour)},
    OptionChoice{.id = "gamma-sweep",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Γ from 0 to 5"),
                 .value = int(Motion::gammaSweep)}};

constexpr ExportOption seconds{
    .id = "seconds",
    .flag = "--seconds",
    .value = "S",
    .help = "How long a film is",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Len&gth"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Of the whole film"),
    .kind = numberWithin(filmSecondsLimits, 1, 1.0,
                         QT_TRANSLATE_NOOP("sline::render::ExportOption", "s")),
    .field = boundTo([](auto& o) -> auto& { return o.template of<FilmOptions>().seconds; })};

constexpr ExportOption framesPerSecond{
    .id = "framesPerSecond",
    .flag = "--fps",
    .value = "N",
    .help = "Frames per second; GIF: at most 50",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Pictures a secon&d"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "More are smoother, and more to draw"),
    .kind = numberWithin(framesPerSecondLimits, 0, 5.0, ""),
    .field =
        boundTo([](auto& o) -> auto& { return o.template of<FilmOptions>().framesPerSecond; })};

constexpr ExportOption filmHeight{
    .id = "filmHeight",
    .flag = "--film-height",
    .value = "PIXELS",
    .help = "Of a film, in pixels; the page's shape gives the width",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Height of the film"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "The page's shape gives the width"),
    .kind = numberWithin(filmHeightLimits, 0, 90.0,
                         QT_TRANSLATE_NOOP("sline::render::ExportOption", "px")),
    .field = boundTo([](auto& o) -> auto& { return o.template of<FilmOptions>().height; })};

/// A value below 0 means that the film decides.
constexpr OptionField holdField{
    [](const ExportOrder& o) { return optionValue(o.of<FilmOptions>().hold.value_or(-1.0)); },
    [](ExportOrder& o, const OptionValue& value) {
      const auto rest = fromOptionValue<double>(value);
      o.of<FilmOptions>().hold = rest < 0.0 ? std::nullopt : std::optional(rest);
    }};

constexpr ExportOption hold{
    .id = "hold",
    .flag = "--hold",
    .value = "S",
    .help =
        "Seconds of rest at each view of a tour, or at either end of a gamma-sweep; else 2/5 or "
        "1/6 of the film together",
    .kind = numberWithin(holdLimits, 1, 1.0, ""),
    .field = holdField};

}  // namespace

constinit const ExportOption motionOption{
    .id = "motion",
    .flag = "--motion",
    .help =
        "What moves in a film: turntable takes the camera once around, from the front to the "
        "patient's left; tour goes through the saved views; gamma-sweep takes Γ from 0 to 5",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "&Motion"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "What moves in the film"),
    .kind = ChoiceOption{motions},
    .field = boundTo([](auto& o) -> auto& { return o.template of<FilmOptions>().motion; })};

OptionList filmOptions() {
  static constexpr std::array all{&motionOption, &seconds, &framesPerSecond, &filmHeight, &hold};
  return all;
}

}  // namespace sline::render
