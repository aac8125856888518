// SPDX-License-Identifier: Apache-2.0
// What is exported, and how: said once, for each kind of file and whoever orders it.
#pragma once

#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "model/base/result.h"
#include "model/base/units.h"
#include "model/scene/scene.h"
#include "render/export/order/export_notes.h"
#include "render/export/order/label_style.h"
#include "render/picture/picture.h"

namespace sline::render {

/// The sheet of paper that a picture fills.
struct ExportPage {
  glm::vec2 sizeMm{160.0f, 90.0f};
  float dpi = 300.0f;  ///< pixels to the inch, for pictures made of pixels
};
inline constexpr Limits<float> dpiLimits{10.0f, 4800.0f};

/// How the scene is drawn, besides what it says itself.
struct ExportLook {
  Background background = Background::white;
  std::optional<glm::vec3> light;  ///< as in PictureSettings
  std::optional<bool> keyLight;    ///< likewise
};

/// Pictures made of pixels.
struct ExportPixels {
  /// Of a channel in PNG and TIFF: 8 or 16; 1 means black and white alone.
  int bits = 8;
  bool grey = false;
  /// For print: each pixel of PNG and TIFF is ink or paper, no grey at all. The scene should be of
  /// ink alone (`model::withInkAlone`).
  bool pureInk = false;
  int samples = 0;  ///< across a pixel; 0: as many as its size allows
};
/// Of either side of a picture.
inline constexpr Limits<int> pixelSideLimits{16, 20'000};

/// What stands at the edge of a picture, so that it can be read without the program.
struct ExportMarks {
  bool sides = true;         ///< R and L, and the other directions of an anatomical view
  bool viewName = true;      ///< "Anterior view", or the saved view's name
  bool scaleBar = true;      ///< where the projection has one scale
  bool sectionState = true;  ///< what sections have taken away

  static constexpr ExportMarks none() { return {false, false, false, false}; }
  bool operator==(const ExportMarks&) const = default;
};

/// What a PDF is: the figure alone, on a page of its size, or a sheet of paper around it. `figure`:
/// with title and legend; `teaching`: besides, numbered labels, a page to test oneself and its key;
/// `patient`: large labels and a text of one's own.
enum class SheetKind { none, figure, teaching, patient };
enum class Paper { a4, letter };

/// Of the kind `pdf` alone.
struct ExportSheet {
  SheetKind kind = SheetKind::none;
  Paper paper = Paper::a4;
  bool landscape = false;
  std::string title;  ///< plain text, as is the next
  std::string text;   ///< of `patient`; lines are paragraphs
  bool operator==(const ExportSheet&) const = default;
};

/// What moves in a film: the camera once around the scene; from saved view to saved view; Γ from 0
/// to 5.
enum class Motion { turntable, tour, gammaSweep };

/// For kinds of files whose pictures move.
struct FilmOptions {
  Motion motion = Motion::turntable;
  double seconds = 8.0;  ///< of the whole film
  int framesPerSecond = 25;
  int height = 720;  ///< pixels; the page's shape gives the width
  /// Seconds of rest at each view, or at either end of Γ; absent: 2/5 or 1/6 of the film together.
  std::optional<double> hold;
  std::vector<model::NodeId> swept;  ///< whose Γ changes; none: everything's
};
inline constexpr Limits<double> filmSecondsLimits{0.1, 600.0};
inline constexpr Limits<int> framesPerSecondLimits{1, 60};
/// Of its height, and of its width.
inline constexpr Limits<int> filmHeightLimits{16, 4320};

/// For decks of cards that ask for labels.
struct AnkiOptions {
  std::string deck;          ///< its name; empty: the view's, or "Anatomy"
  bool othersShown = false;  ///< a card shows the other labels, too
};

/// Who made the picture, and what others may do with it: in the place that the kind of file has for
/// that, and only where somebody said it. It comes from nowhere else: not from the scene, its
/// sources or the account. One line each, UTF-8 (`plainLine`); empty: not said.
///
/// PNG has it as text and XMP, TIFF in its tags, JPEG as Exif, EXR in its header, JPEG 2000 as XMP,
/// SVG and PDF as Dublin Core, GLB in its asset, MP4 in its tags, WebP as XMP, GIF in a comment,
/// frames and Anki's pictures as PNG, Anki's package in the deck's description besides.
struct ExportCredit {
  std::string author;
  std::string copyright;  ///< or a licence: "CC BY 4.0"
  bool empty() const { return author.empty() && copyright.empty(); }
  /// Both as one sentence shows them: "Jane Doe, CC BY 4.0".
  std::string line() const;
};

/// All that a file of any kind is made from. The scene is as it is to be drawn: a saved view, a
/// focus or sections that were asked for are in it already.
struct ExportOrder {
  model::Scene scene;
  model::Camera camera;
  std::string viewName;  ///< of the camera, as a person reads it; empty: none
  ExportPage page;
  ExportLook look;
  LabelStyle labels{.mode = LabelMode::off, .language = {}};
  ExportMarks marks;
  ExportSheet sheet;
  ExportPixels pixels;
  FilmOptions film;
  AnkiOptions anki;
  ExportCredit credit;
};

/// Who waits for a file, and is told of it while it is made.
class ExportProgress {
 public:
  /// Nobody: all is written, and nothing said.
  ExportProgress() = default;
  /// `tell(share, what)` gets what part of the whole is behind and what is being done; false:
  /// nobody wants the file any more, and the writer stops with `givenUp`. The notes, where there is
  /// a list for them, get what the file lacks; it must outlive this.
  template <class Tell>
  requires std::is_invocable_r_v<bool, const Tell&, double, std::string_view>
  // NOLINTNEXTLINE(google-explicit-constructor): any function will do, as for std::function
  ExportProgress(Tell tell, ExportNotes* notes = nullptr)
      : m_tell(std::move(tell)), m_notes(notes) {}

  explicit operator bool() const { return bool(m_tell); }
  bool operator()(double share, std::string_view what) const { return m_tell(share, what); }
  void note(ExportNote note) const {
    if (m_notes)
      addNote(*m_notes, std::move(note));
  }
  void note(const ExportNotes& notes) const {
    for (const ExportNote& each : notes)
      note(each);
  }

 private:
  std::function<bool(double, std::string_view)> m_tell;
  ExportNotes* m_notes = nullptr;
};

/// What a writer returns that was stopped; it leaves no file.
Error givenUp(const std::filesystem::path& target);

/// Width and height of the page in pixels, each at least 1.
glm::ivec2 pixelsOf(const ExportPage& page);

/// Across a pixel of a picture that is drawn at once, where nobody says: two, but one where it is
/// so large that its pixels are fine enough.
int samplesAtOnce(const glm::ivec2& size);

}  // namespace sline::render
