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
#include "render/export/order/writer_options.h"
#include "render/lettering/label_style.h"
#include "render/strokes/picture_settings.h"

namespace sline::render {

/// The sheet of paper that a picture fills.
struct ExportPage {
  glm::vec2 sizeMm{160.0f, 90.0f};
  float dpi = 300.0f;  ///< pixels to the inch, for pictures made of pixels
};
inline constexpr Limits<float> dpiLimits{10.0f, 4800.0f};

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
  Environment environment;
  /// For print without tones: each pixel of PNG and TIFF is ink or paper, no grey at all. The scene
  /// should be of ink alone (`model::withInkAlone`).
  bool pureInk = false;
  LabelStyle labels{.mode = LabelMode::off, .language = {}};
  ExportMarks marks;
  ExportCredit credit;
  WriterOptions own;  ///< what single kinds of files have besides

  /// Returns the options of a writer, as in `order.of<FilmOptions>()`.
  template <class T>
  const T& of() const {
    return own.of<T>();
  }
  template <class T>
  T& of() {
    return own.of<T>();
  }
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
