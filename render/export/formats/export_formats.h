// SPDX-License-Identifier: Apache-2.0
// Lists the kinds of files that a scene can be exported to, in one table for the command line and
// the window.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "render/export/order/export_option.h"
#include "render/raster/image.h"

namespace sline::render {

/// Tells what the page means to files of a kind: nothing; the shape of its pictures; a sheet of
/// lines and shapes; so many pixels. Slides have a page of their own.
enum class PageUse { none, shape, drawing, pixels, slides };

/// Describes everything that distinguishes a kind. Its texts are English; the window translates
/// them in the context "sline::render::ExportFormat".
struct ExportFormat {
  const char* id = "";         ///< its flag without the dashes, in most kinds also its extension
  const char* title = "";      ///< "SVG drawing"
  const char* help = "";       ///< one sentence: its purpose and what it contains
  const char* extension = "";  ///< added to names that have none; empty: the file is a folder
  const char* otherExtension = "";  ///< also accepted when typed; empty: there is none
  PageUse page = PageUse::pixels;
  bool oneView = true;  ///< shows the scene from one place; others hold it whole, or all its views
  bool names = false;   ///< holds names of structures in addition to what is seen
  bool forLearning = false;           ///< is for learning systems: `--package` has it, too
  OptionList (*options)() = nullptr;  ///< its own, besides those that all pictures have
  /// Writes the whole file or, with an error, nothing. It runs on any thread and makes the OpenGL
  /// context that it needs.
  Status (*write)(const ExportOrder& order, const std::filesystem::path& target,
                  const ExportProgress& progress) = nullptr;
  /// Returns the notes that `write` will make as far as the order alone decides them. It is quick
  /// and draws nothing.
  ExportNotes (*foreseen)(const ExportOrder& order) = nullptr;
  /// Returns about how many bytes the file will have, given a small picture of its page: found by
  /// making the file or a part of it in memory. 0: unknown, or stopped by the progress. Null: it is
  /// not to be known beforehand. It runs on any thread, for as long as `write` does at most.
  double (*weigh)(const ExportOrder& order, const Image& page,
                  const ExportProgress& progress) = nullptr;

  /// Returns whether the option means something to files of this kind.
  bool has(const ExportOption& option) const;
  /// Tells whether one file can hold all saved views.
  bool holdsViews() const;
};

/// Returns the kinds in the order in which the user should meet them.
std::span<const ExportFormat> exportFormats();
/// Returns the kind of this id; null where there is none.
const ExportFormat* exportFormat(std::string_view id);

/// Tells whether files of the kind say whose work the surfaces are unless `off` is chosen; others
/// do on request alone.
bool namesSources(const ExportFormat& format);

/// Returns the options of all kinds, each once, in the order in which the user should meet them.
std::vector<const ExportOption*> exportOptions();
/// Resets the options of other kinds to those of an order in which nothing was chosen.
void dropForeignOptions(ExportOrder& order, const ExportFormat& format);

}  // namespace sline::render
