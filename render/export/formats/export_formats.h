// SPDX-License-Identifier: Apache-2.0
// The kinds of files that a scene can be exported to: one table for the command line and the
// window.
#pragma once

#include <span>

#include "render/export/order/export_order.h"

namespace sline::render {

/// English texts; the window translates them in the context "sline::render::ExportFormat".
struct ExportFormat {
  const char* id;              ///< its flag without the dashes, its extension unless there are more
  const char* title;           ///< "SVG drawing"
  const char* help;            ///< one sentence: what it is for, what it contains
  const char* extension;       ///< of a file whose name has none; empty: it is a folder
  const char* otherExtension;  ///< that a person may type as well; empty: there is none
  /// Writes the whole file or, with an error, none. Runs on any thread; makes the OpenGL context
  /// that it needs.
  Status (*write)(const ExportOrder& order, const std::filesystem::path& target,
                  const ExportProgress& progress);
  /// Of what `write` will note, that which the order alone tells: quick, draws nothing.
  ExportNotes (*foreseen)(const ExportOrder& order);
};

/// In the order in which a person should meet them.
std::span<const ExportFormat> exportFormats();

}  // namespace sline::render
