// SPDX-License-Identifier: Apache-2.0
// The flags of the page that an export fills.
#pragma once

#include <string>

#include "model/base/result.h"
#include "render/export/order/export_order.h"

namespace CLI {
class App;
}  // namespace CLI

namespace sline::cli {

/// As typed.
struct PageFlags {
  std::string sizeMm = "160x90";
  std::string sizePx;  ///< instead
  double dpi = 300.0;
};

void declarePage(CLI::App& command, PageFlags& flags);
/// An error is a wrong use.
Result<render::ExportPage> understood(const PageFlags& flags);

}  // namespace sline::cli
