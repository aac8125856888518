// SPDX-License-Identifier: Apache-2.0
// Describes what is exported, and how, in one way for every kind of file and for every caller.
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
#include "render/drawn/picture_settings.h"
#include "render/export/order/export_notes.h"
#include "render/export/order/writer_options.h"
#include "render/lettering/label_style.h"

namespace sline::render {

/// The sheet of paper that a picture fills.
struct ExportPage {
  glm::vec2 sizeMm{160.0f, 90.0f};
  float dpi = 300.0f;  ///< pixels per inch, for pictures made of pixels
};
inline constexpr Limits<float> dpiLimits{10.0f, 4800.0f};

/// The limits of either side of a picture.
inline constexpr Limits<int> pixelSideLimits{16, 20'000};

/// Selects what is written at the edge of a picture, so that it can be read without the program.
struct ExportMarks {
  bool sides = true;         ///< R and L, and the other directions of an anatomical view
  bool viewName = true;      ///< "Anterior view", or the saved view's name
  bool scaleBar = true;      ///< shown where the projection has one scale
  bool sectionState = true;  ///< what sections have taken away
  bool gammaKey = true;      ///< by what Γ varies, where it varies over surfaces
  bool words = true;         ///< title and text of the saved view, where it says any

  static constexpr ExportMarks none() { return {false, false, false, false, false, false}; }
  bool operator==(const ExportMarks&) const = default;
};

/// Tells which structures a legend lists. `onSheets`: all, on sheets of paper alone.
enum class LegendList { onSheets, none, all, labelled, focus };

/// Tells who made the picture, what others may do with it, and what it shows. It is written in the
/// place that the kind of file has for it. Author and rights are written only where the user said
/// so and come from nowhere else: not from the scene, its sources or the account. Each field is one
/// line of UTF-8 (`plainLine`); empty: not said.
///
/// PNG has it as text and XMP, TIFF in its tags, JPEG as Exif, EXR in its header, JPEG 2000 as XMP,
/// SVG and PDF as Dublin Core, GLB in its asset, MP4 in its tags, WebP as XMP, GIF in a comment,
/// frames and Anki's pictures as PNG, Anki's package also in the deck's description, and slides in
/// the file's properties.
struct ExportCredit {
  std::string author;
  std::string copyright;  ///< or a licence: "CC BY 4.0"
  /// What the file shows, in words, for who does not see it, and the language of that (BCP 47).
  /// Writers set it (`altTextOf`); what a person says is in `ExportOrder::altText`.
  std::string description = {};
  std::string descriptionLanguage = {};
  bool empty() const { return author.empty() && copyright.empty() && description.empty(); }
  /// Returns both as one sentence shows them: "Jane Doe, CC BY 4.0".
  std::string line() const;
};

/// Tells where it is said whose work the surfaces are (`model::SourceCredit`). `withSurfaces`: in
/// files that hold the surfaces themselves, beside these. `line`: also in a line at the foot of
/// each picture. `page`: also on a page or slide of its own, where there are such, else in a line.
enum class SourceCredits { withSurfaces, off, line, page };

/// Holds everything that a file of any kind is made from. The scene is as it is to be drawn: a
/// saved view, a focus or sections that were asked for are already applied.
struct ExportOrder {
  model::Scene scene;
  model::Camera camera;
  std::string viewName;    ///< of the camera, for the reader; empty: none
  model::ViewWords words;  ///< of the saved view that is shown; empty for others
  ExportPage page;
  Environment environment;
  /// For print without tones: each pixel of PNG and TIFF is ink or paper, no grey at all. The scene
  /// should be of ink alone (`model::withInkAlone`).
  bool pureInk = false;
  LabelStyle labels{.mode = LabelMode::off, .language = {}};
  ExportMarks marks;
  LegendList legend = LegendList::onSheets;
  ExportCredit credit;
  SourceCredits sources = SourceCredits::withSurfaces;
  /// What the picture shows, in words, for who does not see it; empty: what the view says, else
  /// what is seen in it; "off": nothing.
  std::string altText;
  WriterOptions own;  ///< further options, of single kinds of files

  /// Tells whether a picture of it has a legend in it.
  bool legendInPicture() const {
    return legend != LegendList::onSheets && legend != LegendList::none;
  }
  /// Tells whether a picture of it says whose work the surfaces are.
  bool sourcesInPicture() const {
    return sources == SourceCredits::line || sources == SourceCredits::page;
  }
  /// Tells whether nothing is written over a picture of it.
  bool bare() const {
    return labels.mode == LabelMode::off && marks == ExportMarks::none() && !legendInPicture() &&
           !sourcesInPicture();
  }
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

/// Reports to the caller that waits for a file while it is made.
class ExportProgress {
 public:
  /// Reports to no one: everything is written.
  ExportProgress() = default;
  /// `tell(share, what)` receives the share that is complete and what is being done. If it returns
  /// false, the file is no longer wanted, and the writer stops with `givenUp`. If there is a list
  /// of notes, it receives what the file lacks; it must outlive this object.
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

/// Returns the error of a writer that was stopped; such a writer leaves no file.
Error givenUp(const std::filesystem::path& target);

/// Returns the width and height of the page in pixels, each at least 1.
glm::ivec2 pixelsOf(const ExportPage& page);

/// Returns the default number of samples across a pixel for a picture that is drawn at once: two,
/// but one where the picture is so large that its pixels are fine enough.
int samplesAtOnce(const glm::ivec2& size);

}  // namespace sline::render
