// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/scene_saver.h"

#include <QBuffer>
#include <algorithm>
#include <exception>
#include <new>

namespace sline::widgets {

struct SceneSaver::SaveTask {
  std::filesystem::path path;
  As as = As::document;
  int opening = 0;
  DocumentFile file;  ///< of the document when the save was requested; `saved` is what to write
  Companions companions;
};

struct SceneSaver::Outcome {
  std::optional<Error> error;
  DocumentFile file;
};

namespace {

constexpr QSize thumbnailSize(320, 240);

std::shared_ptr<const std::string> pngOf(const QImage& picture) {
  const QImage small =
      picture.width() > thumbnailSize.width() || picture.height() > thumbnailSize.height()
          ? picture.scaled(thumbnailSize, Qt::KeepAspectRatio, Qt::SmoothTransformation)
          : picture;
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!buffer.open(QIODevice::WriteOnly) ||
      !small.convertToFormat(QImage::Format_RGB888).save(&buffer, "PNG"))
    return nullptr;
  return std::make_shared<const std::string>(bytes.toStdString());
}

using Members = std::vector<model::ZipMember>;

/// Inserts the member in the order of names, in which members are read again.
std::shared_ptr<const Members> withMember(const std::shared_ptr<const Members>& before,
                                          const model::ZipMember& member) {
  Members members = before ? *before : Members();
  std::erase_if(members, [&](const model::ZipMember& each) { return each.name == member.name; });
  const auto place = std::lower_bound(
      members.begin(), members.end(), member.name,
      [](const model::ZipMember& each, const std::string& name) { return each.name < name; });
  members.insert(place, member);
  return std::make_shared<const Members>(std::move(members));
}

Error notSaved(const std::filesystem::path& file, const std::string& reason) {
  return {.file = file.string(), .reason = reason, .remedy = "Save under another name"};
}

}  // namespace

SceneSaver::SceneSaver(Session& session, QObject* parent) : QObject(parent), m_session(session) {}

void SceneSaver::save(const std::filesystem::path& file, As as, const Companions& companions) {
  std::error_code fault;
  const std::filesystem::path whole = std::filesystem::absolute(file, fault);
  SaveTask task{.path = fault ? file : whole,
                .as = as,
                .opening = m_session.document().opening,
                .file = m_session.file(),
                .companions = companions};
  task.file.saved = m_session.sceneBeforePreview();
  emit started(QString::fromStdString(file.filename().string()));
  m_queue.add([this, task = std::move(task)](const std::stop_token&) -> BackgroundQueue::Sequel {
    Outcome outcome;
    try {
      outcome = carryOut(task);
    } catch (const std::exception& failure) {
      outcome.error =
          notSaved(task.path, std::string("it could not be written: ") + failure.what());
    }
    return [this, task, outcome] { finish(task, outcome); };
  });
}

SceneSaver::Outcome SceneSaver::carryOut(const SaveTask& task) {
  Outcome outcome{.error = {}, .file = task.file};
  DocumentFile& file = outcome.file;
  if (!task.companions.picture.isNull())
    file.thumbnail = pngOf(task.companions.picture);
  if (task.companions.member)
    file.others = withMember(file.others, *task.companions.member);
  Written& before = m_written[task.path];
  if (!file.lock || !isLockOf(*file.lock, task.path))
    file.lock = before.lock.lock();
  if (!file.lock) {
    Result<model::FileLock> lock = model::FileLock::acquire(task.path);
    if (!lock.ok()) {
      outcome.error = lock.error();
      return outcome;
    }
    file.lock = std::make_shared<const model::FileLock>(std::move(*lock));
  } else if (const auto now = stampOf(task.path);
             now && now != task.file.stamp && now != before.stamp) {
    outcome.error = notSaved(task.path, "another program has changed it since it was opened");
    return outcome;
  }
  model::SceneDocument document{.scene = *file.saved,
                                .whole = before.stamp ? before.stamp : file.whole};
  if (file.thumbnail)
    document.thumbnail = *file.thumbnail;
  if (file.others)
    document.others = *file.others;
  if (const Status written = model::writeSceneFile(*file.lock, document); !written.ok()) {
    outcome.error = written.error();
    return outcome;
  }
  file.path = task.path;
  file.writable = Writable::yes;
  file.reason.clear();
  takeStamp(file);
  file.whole = file.stamp;
  before = {file.stamp, file.lock};
  return outcome;
}

void SceneSaver::finish(const SaveTask& task, const Outcome& outcome) {
  if (outcome.error) {
    emit failed(*outcome.error);
  } else {
    if (task.as == As::document)
      m_session.noteSaved(task.opening, outcome.file);
    emit saved(task.path, task.as);
  }
  if (!busy())
    emit ended();
}

}  // namespace sline::widgets

#include "moc_scene_saver.cpp"
