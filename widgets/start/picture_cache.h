// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <filesystem>

namespace sline::widgets {

/// Small pictures that can be made again, as PNG files in a folder. Usable from any thread; a
/// folder that cannot be read or written holds nothing.
class PictureCache {
 public:
  /// Empty: there is none. It need not exist.
  explicit PictureCache(std::filesystem::path folder) : m_folder(std::move(folder)) {}

  /// Null where there is none of that name.
  QImage find(const QString& name) const;
  void keep(const QString& name, const QImage& picture) const;

 private:
  std::filesystem::path m_folder;
};

/// A picture from bytes that are not trusted; null where they are none, or a large one.
QImage smallPicture(const QByteArray& bytes);

}  // namespace sline::widgets
