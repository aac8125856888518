// SPDX-License-Identifier: Apache-2.0
// Declares the flags of the page that an export fills.
#pragma once

#include <string>

#include "model/base/result.h"
#include "render/export/order/export_order.h"

namespace CLI {
class App;
}  // namespace CLI

namespace sline::cli {

/// Holds the flags as typed.
struct PageFlags {
  std::string sizeMm = "160x90";
  std::string sizePx;  ///< in place of `sizeMm`
  double dpi = 300.0;
};

void declarePage(CLI::App& command, PageFlags& flags);
/// Reads the flags. An error counts as wrong use.
Result<render::ExportPage> parseFlags(const PageFlags& flags);

}  // namespace sline::cli
