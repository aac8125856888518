// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film_options.h"

#include <QtGlobal>
#include <algorithm>
#include <array>
#include <cmath>

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

constexpr std::array formats{
    OptionChoice{.id = "1280x720",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "1280 × 720, HD"),
                 .value = int(FilmFormat::hd)},
    OptionChoice{.id = "1920x1080",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "1920 × 1080, Full HD"),
                 .value = int(FilmFormat::fullHd)},
    OptionChoice{.id = "square",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "1080 × 1080, square"),
                 .value = int(FilmFormat::square)},
    OptionChoice{.id = "typed",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Another size"),
                 .value = int(FilmFormat::typed)},
    OptionChoice{.id = "page",
                 .text = QT_TRANSLATE_NOOP("sline::render::ExportOption", "The page's shape"),
                 .value = int(FilmFormat::page)}};

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

constexpr ExportOption subtitles{
    .id = "subtitles",
    .flag = "--subtitles,!--no-subtitles",
    .help =
        "Writes what the views of a tour say into a WebVTT file, too, of the film's name and the "
        "ending .vtt, in the folder of frames subtitles.vtt; --marks says whether the pictures "
        "have it",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Su&btitle file"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption",
                             "What the views say as a WebVTT file beside the film, for players and "
                             "web pages"),
    .field = boundTo([](auto& o) -> auto& { return o.template of<FilmOptions>().subtitles; })};

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

constinit const ExportOption filmFormatOption{
    .id = "filmFormat",
    .flag = "--film-size",
    .help =
        "Pixels of a film; WxH takes any others. page: the page's shape, --film-height high, which "
        "is also what a page's size or --film-height alone asks for",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Size of the film"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Width and height in pixels"),
    .kind = ChoiceOption{formats},
    .field = boundTo([](auto& o) -> auto& { return o.template of<FilmOptions>().format; })};

constinit const ExportOption filmWidthOption{
    .id = "filmWidth",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Width of the film"),
    .tip = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Of another size"),
    .kind = numberWithin(filmHeightLimits, 0, 90.0,
                         QT_TRANSLATE_NOOP("sline::render::ExportOption", "px")),
    .field = boundTo([](auto& o) -> auto& { return o.template of<FilmOptions>().width; }),
    .applies = [](const ExportOrder& o) {
      return o.of<FilmOptions>().format == FilmFormat::typed;
    }};

constinit const ExportOption filmHeightOption{
    .id = "filmHeight",
    .flag = "--film-height",
    .value = "PIXELS",
    .help = "Of a film, in pixels; the page's shape gives the width",
    .title = QT_TRANSLATE_NOOP("sline::render::ExportOption", "Height of the film"),
    .tip =
        QT_TRANSLATE_NOOP("sline::render::ExportOption", "Of another size, or of the page's shape"),
    .kind = numberWithin(filmHeightLimits, 0, 90.0,
                         QT_TRANSLATE_NOOP("sline::render::ExportOption", "px")),
    .field = boundTo([](auto& o) -> auto& { return o.template of<FilmOptions>().height; }),
    .applies = [](const ExportOrder& o) {
      return o.of<FilmOptions>().format == FilmFormat::typed ||
             o.of<FilmOptions>().format == FilmFormat::page;
    }};

OptionList filmOptions() {
  static constexpr std::array all{&motionOption,
                                  &filmFormatOption,
                                  &filmWidthOption,
                                  &filmHeightOption,
                                  &seconds,
                                  &framesPerSecond,
                                  &hold,
                                  &subtitles};
  return all;
}

glm::ivec2 filmSize(const ExportOrder& order) {
  const auto even = [](double pixels) { return std::max(2 * int(std::lround(0.5 * pixels)), 2); };
  const FilmOptions& film = order.of<FilmOptions>();
  switch (film.format) {
    case FilmFormat::hd:
      return {1280, 720};
    case FilmFormat::fullHd:
      return {1920, 1080};
    case FilmFormat::square:
      return {1080, 1080};
    case FilmFormat::typed:
      return {even(film.width), even(film.height)};
    case FilmFormat::page:
      break;
  }
  const double aspect = double(order.page.sizeMm.x) / double(order.page.sizeMm.y);
  return {even(film.height * aspect), even(film.height)};
}

glm::vec2 filmPageMm(const ExportOrder& order) {
  constexpr float shorterSide = 106.0f;
  const bool ofPage = order.of<FilmOptions>().format == FilmFormat::page;
  const glm::vec2 shape = ofPage ? order.page.sizeMm : glm::vec2(filmSize(order));
  return shape * (shorterSide / std::min(shape.x, shape.y));
}

}  // namespace sline::render
