// SPDX-License-Identifier: Apache-2.0
// Converts file names between Qt and the standard library, both UTF-8.
#pragma once

#include <QString>
#include <filesystem>

namespace sline::widgets {

inline std::filesystem::path pathOf(const QString& text) {
  return text.toStdString();
}

inline QString textOf(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

}  // namespace sline::widgets
