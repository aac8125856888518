// SPDX-License-Identifier: Apache-2.0
#include "widgets/start/scene_thumbnails.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QFileInfo>

#include "model/disk/whole_file.h"
#include "model/scene_file/scene_file.h"

namespace sline::widgets {

namespace {

constexpr std::size_t largestSceneFile = std::size_t(4) << 30;

QImage pictureIn(const QString& file) {
  const Result<std::string> bytes = model::readText(file.toStdString(), largestSceneFile);
  if (!bytes.ok())
    return {};
  const Result<model::ZipReader> zip = model::ZipReader::open(*bytes);
  const model::ZipReader::Entry* entry = zip.ok() ? zip->find("thumbnail.png") : nullptr;
  const Result<std::string> png = entry ? zip->read(*entry) : Result<std::string>(Error());
  return png.ok() ? smallPicture(QByteArray::fromStdString(*png)) : QImage();
}

/// Returns a key that changes when the file is written again.
QString keyOf(const QFileInfo& file) {
  const QString text = file.absoluteFilePath() + QLatin1Char('\n') + QString::number(file.size()) +
                       QLatin1Char('\n') + QString::number(file.lastModified().toMSecsSinceEpoch());
  return QStringLiteral("scene-") +
         QString::fromLatin1(
             QCryptographicHash::hash(text.toUtf8(), QCryptographicHash::Sha1).toHex());
}

}  // namespace

SceneThumbnails::SceneThumbnails(PictureCache cache, QObject* parent)
    : QObject(parent), m_cache(std::move(cache)) {}

void SceneThumbnails::ask(const QString& file) {
  m_queue.add([this, cache = m_cache, file](const std::stop_token&) -> BackgroundQueue::Sequel {
    const QFileInfo info(file);
    if (!info.exists())
      return [this, file] { emit missing(file); };
    QImage picture;
    if (info.isFile() && model::isSceneFile(file.toStdString())) {
      picture = cache.find(keyOf(info));
      if (picture.isNull()) {
        picture = pictureIn(file);
        cache.keep(keyOf(info), picture);
      }
    }
    return [this, file, picture] { emit found(file, picture); };
  });
}

}  // namespace sline::widgets

#include "moc_scene_thumbnails.cpp"
