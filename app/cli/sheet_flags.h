// SPDX-License-Identifier: Apache-2.0
// The flags of PDF sheets.
#pragma once

#include <string>

#include "model/base/result.h"
#include "render/export/order/export_order.h"

namespace sline::cli {

/// As typed.
struct SheetFlags {
  std::string kind;
  std::string paper = "a4";
  bool landscape = false;
  std::string title;
  std::string text;  ///< itself, or the name of a file with it
};

/// An error is a wrong use, or a file that cannot be read.
Result<render::ExportSheet> understood(const SheetFlags& flags);

}  // namespace sline::cli
