// SPDX-License-Identifier: Apache-2.0
// Makes the options of exports into flags of the command line, from the renderer's table.
#pragma once

#include <map>
#include <string>

#include "model/base/result.h"
#include "render/export/order/export_option.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace sline::cli {

/// Holds what was typed behind the flags of options, not yet understood.
class TypedOptions {
 public:
  /// Declares the option's flag on the sub-command, with the help and the default that the table
  /// has, or which `standard` has in its place; the help ends with the kinds of files that have
  /// it. This must outlive the command.
  CLI::Option* declare(CLI::App& command, const render::ExportOption& option,
                       const std::string& kinds = {}, const render::ExportOrder& standard = {});
  /// Takes the text as if it had been typed.
  void set(const render::ExportOption& option, const std::string& text) { m_texts[&option] = text; }
  /// Returns what was typed; an empty text if nothing was.
  std::string typed(const render::ExportOption& option) const;
  /// Writes what was typed into the order. An error counts as wrong use, or means a file that
  /// cannot be read.
  Status applyTo(render::ExportOrder& order) const;

 private:
  std::map<const render::ExportOption*, std::string> m_texts;
};

/// Reads one option's text; the error names its flag.
Result<render::OptionValue> parseTypedOption(const render::ExportOption& option,
                                             const std::string& text);

}  // namespace sline::cli
