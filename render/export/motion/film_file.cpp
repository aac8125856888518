// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film_file.h"
#include "render/export/motion/film_options.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <system_error>

#include "model/disk/whole_file.h"
#include "model/disk/whole_folder.h"
#include "model/edit/views.h"
#include "render/export/description/alt_text.h"
#include "render/export/motion/film_painter.h"
#include "render/export/motion/film_sink.h"
#include "render/export/motion/subtitles.h"
#include "render/export/order/view_orders.h"

namespace sline::render {

namespace fs = std::filesystem;

Error filmNotWritten(const fs::path& file, int code) {
  const bool full = code == ENOSPC || code == EDQUOT || code == EFBIG;
  return {.file = file.string(),
          .reason = "it cannot be written: " + std::generic_category().message(code),
          .remedy = full ? "Free some space on the disk, or choose another one"
                         : "Choose a folder that exists and that you may write to"};
}

namespace {

/// Returns the credit, with what the film shows at its beginning; of a sweep through Γ nothing is
/// named, as what one sees of a structure changes.
ExportCredit filmCredit(const ExportOrder& order) {
  ExportOrder first = order;
  const Motion motion = order.of<FilmOptions>().motion;
  if (motion == Motion::gammaSweep)
    first.labels.mode = LabelMode::off;
  if (motion == Motion::tour && !order.scene.views().empty()) {
    const model::View& view = order.scene.views().front();
    first.scene = model::withViewApplied(order.scene, view).scene;
    const glm::vec2 size(filmSize(order));
    first.camera = fittedToPage(first.scene, view.camera, size.x / size.y);
    first.words = view.words;
  }
  return fileCredit(first, altTextOfFilm(first));
}

/// Writes one film into its file.
class Filming {
 public:
  Filming(const ExportOrder& order, const fs::path& target, const ExportProgress& progress,
          bool transparency = true)
      : m_order(order), m_target(target), m_progress(progress), m_transparency(transparency) {
    m_order.page.sizeMm = filmPageMm(order);
  }

  /// Prepares what is needed before a file is begun.
  Status prepare() {
    if (!tell(0.0, "preparing surfaces"))
      return givenUp(m_target);
    m_painter = TRY(FilmPainter::create(m_order));
    Result<Film> film = Film::create(m_order, m_painter->anatomyShare());
    if (!film.ok())
      return at(film.error());
    m_progress.note(filmNotes(m_order, m_transparency));
    m_film.emplace(std::move(*film));
    return Unit{};
  }

  FilmShape shape() const {
    return {.size = m_film->size(),
            .frames = m_film->frames(),
            .framesPerSecond = m_film->framesPerSecond(),
            .transparent = m_order.environment.background == Background::transparent,
            .credit = filmCredit(m_order)};
  }

  /// Returns the palette of a few frames, spread evenly over the film.
  Result<GifPalette> palette() {
    constexpr int most = 5;
    std::vector<Image> looks;
    const int count = std::min(most, m_film->frames());
    for (int i = 0; i < count; ++i) {
      if (!tell(0.0, "choosing colours"))
        return givenUp(m_target);
      const int frame = count > 1 ? i * (m_film->frames() - 1) / (count - 1) : 0;
      Image look = TRY(m_painter->drawAlone(*m_film, frame));
      looks.push_back(std::move(look));
    }
    return GifPalette::of(looks);
  }

  Status run(FilmSink& sink) {
    if (!m_painter->settle(*m_film,
                           [this](double share) { return tell(0.1 * share, "placing labels"); }))
      return givenUp(m_target);
    const int count = m_film->frames();
    for (int i = 0; i < count; ++i) {
      const std::string what =
          "drawing frame " + std::to_string(i + 1) + " of " + std::to_string(count);
      if (!tell(0.1 + 0.89 * double(i) / double(count), what))
        return givenUp(m_target);
      const Result<Image> image = m_painter->draw(*m_film, i);
      if (!image.ok())
        return at(image.error());
      TRY(sink.add(*image));
    }
    m_progress.note(m_painter->notes());
    if (!tell(0.99, "finishing the film"))
      return givenUp(m_target);
    return sink.finish();
  }

  /// Writes what the views say into that file, where it is wanted.
  Status subtitle(const fs::path& file) const {
    if (!m_order.of<FilmOptions>().subtitles)
      return Unit{};
    const std::string text = webVtt(*m_film, m_order.labels.language);
    if (text.find("-->") == std::string::npos)
      m_progress.note({.kind = ExportNote::Kind::subtitlesEmpty, .names = {}, .detail = {}});
    return model::writeText(file, text);
  }

  Error at(Error error) const {
    error.file = m_target.string();
    return error;
  }

 private:
  bool tell(double share, std::string_view what) const {
    return !m_progress || m_progress(share, what);
  }

  ExportOrder m_order;  ///< on a page of the film's shape
  const fs::path& m_target;
  const ExportProgress& m_progress;
  bool m_transparency;  ///< whether the kind of file has it
  std::unique_ptr<FilmPainter> m_painter;
  std::optional<Film> m_film;
};

/// Writes the film; `newSink(file)` begins the file.
template <class Begin>
Status writeFilm(Filming& filming, const fs::path& target, const Begin& newSink) {
  TRY(filming.prepare());
  const Status written = model::writeBeside(target, [&](const fs::path& file) -> Status {
    NewSink sink = newSink(file);
    if (!sink.ok())
      return sink.error();
    return filming.run(**sink);
  });
  return written.ok() ? filming.subtitle(fs::path(target).replace_extension(".vtt")) : written;
}

}  // namespace

ExportNotes filmNotes(const ExportOrder& order, bool transparency) {
  const auto& film = order.of<FilmOptions>();
  ExportNotes notes;
  if (order.environment.background == Background::transparent && !transparency)
    addNote(notes, {.kind = ExportNote::Kind::standsOnWhite, .names = {}, .detail = {}});
  const glm::ivec2 size = filmSize(order);
  const bool typed = film.format == FilmFormat::typed;
  if ((typed && size.x != film.width) ||
      ((typed || film.format == FilmFormat::page) && size.y != film.height))
    addNote(notes, {.kind = ExportNote::Kind::filmRounded,
                    .names = {},
                    .detail = std::to_string(size.x) + " × " + std::to_string(size.y)});
  const double seconds = double(filmFrames(film)) / double(std::max(film.framesPerSecond, 1));
  constexpr double told = 0.005;  // half of a hundredth, to which it is told
  if (std::abs(seconds - film.seconds) > told) {
    const auto hundredths = std::to_string(100 + std::lround(100.0 * seconds) % 100);
    addNote(notes, {.kind = ExportNote::Kind::filmStretched,
                    .names = {},
                    .detail = std::to_string(std::lround(100.0 * seconds) / 100) + "." +
                              hundredths.substr(1)});
  }
  return notes;
}

Status writeWebp(const ExportOrder& order, const fs::path& target, const ExportProgress& progress) {
  Filming filming(order, target, progress);
  return writeFilm(filming, target,
                   [&](const fs::path& file) { return webpSink(file, filming.shape()); });
}

Status writeGif(const ExportOrder& order, const fs::path& target, const ExportProgress& progress) {
  Filming filming(order, target, progress);
  return writeFilm(filming, target, [&](const fs::path& file) -> NewSink {
    // The file comes first: if it cannot be written, no colours need to be found.
    if (NewSink trial = gifSink(file, filming.shape(), GifPalette::of({})); !trial.ok())
      return trial;
    GifPalette palette = TRY(filming.palette());
    return gifSink(file, filming.shape(), std::move(palette));
  });
}

Status writeMp4(const ExportOrder& order, const fs::path& target, const ExportProgress& progress) {
  Filming filming(order, target, progress, false);
  return writeFilm(filming, target,
                   [&](const fs::path& file) { return mp4Sink(file, filming.shape()); });
}

Status writeFrames(const ExportOrder& order, const fs::path& target,
                   const ExportProgress& progress) {
  return model::writeFolder(target, [&](const fs::path& folder) -> Status {
    Filming filming(order, target, progress);
    TRY(filming.prepare());
    NewSink sink = frameSink(folder, filming.shape());
    if (!sink.ok())
      return sink.error();
    const Status drawn = filming.run(**sink);
    return drawn.ok() ? filming.subtitle(folder / "subtitles.vtt") : drawn;
  });
}

}  // namespace sline::render
