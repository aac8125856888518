// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QImage>
#include <QString>
#include <filesystem>

namespace sline::widgets {

/// Keeps small pictures that can be made again, as PNG files in a folder. Usable from any thread; a
/// folder that cannot be read or written acts as an empty one.
class PictureCache {
 public:
  /// Uses the folder, which need not exist; an empty path means no folder.
  explicit PictureCache(std::filesystem::path folder) : m_folder(std::move(folder)) {}

  /// Returns the picture; null where there is none of that name.
  QImage find(const QString& name) const;
  void keep(const QString& name, const QImage& picture) const;

 private:
  std::filesystem::path m_folder;
};

/// Returns a picture from untrusted bytes; null where they are not a picture, or a large one.
QImage smallPicture(const QByteArray& bytes);

}  // namespace sline::widgets
