// SPDX-License-Identifier: Apache-2.0
#include "widgets/start/picture_cache.h"

#include <QBuffer>
#include <QImageReader>
#include <system_error>

#include "model/disk/whole_file.h"

namespace sline::widgets {

namespace {
constexpr std::size_t largestPictureFile = std::size_t(16) << 20;
constexpr int largestSide = 4096;

std::filesystem::path fileOf(const std::filesystem::path& folder, const QString& name) {
  return folder / (name.toStdString() + ".png");
}
}  // namespace

QImage smallPicture(const QByteArray& bytes) {
  QByteArray copy = bytes;
  QBuffer buffer(&copy);
  QImageReader reader(&buffer, "PNG");
  const QSize size = reader.size();
  if (!size.isValid() || size.width() > largestSide || size.height() > largestSide)
    return {};
  return reader.read();
}

QImage PictureCache::find(const QString& name) const {
  std::error_code fault;
  const std::filesystem::path file = fileOf(m_folder, name);
  if (m_folder.empty() || !std::filesystem::exists(file, fault))
    return {};
  const Result<std::string> bytes = model::readText(file, largestPictureFile);
  return bytes.ok() ? smallPicture(QByteArray::fromStdString(*bytes)) : QImage();
}

void PictureCache::keep(const QString& name, const QImage& picture) const {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (m_folder.empty() || picture.isNull() || !buffer.open(QIODevice::WriteOnly) ||
      !picture.save(&buffer, "PNG"))
    return;
  std::error_code ignored;
  std::filesystem::create_directories(m_folder, ignored);
  static_cast<void>(model::writeText(fileOf(m_folder, name), bytes.toStdString()));
}

}  // namespace sline::widgets
