// SPDX-License-Identifier: Apache-2.0
// The kinds of files that a scene can be exported to: one table for the command line and the
// window.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "render/export/order/export_option.h"

namespace sline::render {

/// What the page is to files of a kind: nothing; the shape of its pictures; a sheet of lines and
/// shapes; so many pixels.
enum class PageUse { none, shape, drawing, pixels };

/// All that distinguishes a kind. Its texts are English; the window translates them in the context
/// "sline::render::ExportFormat".
struct ExportFormat {
  const char* id = "";         ///< its flag without the dashes, its extension unless there are more
  const char* title = "";      ///< "SVG drawing"
  const char* help = "";       ///< one sentence: what it is for, what it contains
  const char* extension = "";  ///< of a file whose name has none; empty: it is a folder
  const char* otherExtension = "";  ///< that a person may type as well; empty: there is none
  PageUse page = PageUse::pixels;
  bool oneView = true;  ///< shows the scene from one place; others hold it whole, or all its views
  bool names = false;   ///< holds names of structures besides what is seen
  OptionList (*options)() = nullptr;  ///< of its own, besides those that all pictures have
  // How large files are, about: drawings are mostly empty, which packs well. Zeros: nobody knows.
  double bytesPerPixel = 0.0;
  double bytesPerTriangle = 0.0;
  /// Writes the whole file or, with an error, none. Runs on any thread; makes the OpenGL context
  /// that it needs.
  Status (*write)(const ExportOrder& order, const std::filesystem::path& target,
                  const ExportProgress& progress) = nullptr;
  /// Returns those of the notes that `write` will make which the order alone tells: quick, draws
  /// nothing.
  ExportNotes (*foreseen)(const ExportOrder& order) = nullptr;

  /// Returns whether the option means something to files of this kind.
  bool has(const ExportOption& option) const;
};

/// In the order in which a person should meet them.
std::span<const ExportFormat> exportFormats();
/// Returns null where there is no such kind.
const ExportFormat* exportFormat(std::string_view id);

/// Returns the options of all kinds, each once, in the order in which a person should meet them.
std::vector<const ExportOption*> exportOptions();
/// Sets the options of other kinds as they are in an order where nothing was chosen.
void dropForeignOptions(ExportOrder& order, const ExportFormat& format);

}  // namespace sline::render
