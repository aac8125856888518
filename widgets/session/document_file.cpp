// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/document_file.h"

#include <system_error>

#include "model/disk/whole_file.h"
#include "widgets/text/told.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace fs = std::filesystem;

namespace {

std::shared_ptr<const std::string> textOrNone(std::string text) {
  return text.empty() ? nullptr : std::make_shared<const std::string>(std::move(text));
}

void deny(DocumentFile& file, Writable why, const QString& reason) {
  file.writable = why;
  file.reason = reason;
  file.lock.reset();
}

void lock(DocumentFile& file, std::shared_ptr<const model::FileLock> held) {
  if (!model::mayBeWritten(file.path))
    return deny(file, Writable::notPermitted, tr("Its rights do not let it be written to"));
  if (held && isLockOf(*held, file.path)) {
    file.lock = std::move(held);
    return;
  }
  const bool taken = model::FileLock::held(file.path);
  Result<model::FileLock> lock = model::FileLock::acquire(file.path);
  if (lock.ok()) {
    file.writable = Writable::yes;
    file.reason.clear();
    file.lock = std::make_shared<const model::FileLock>(std::move(*lock));
    return;
  }
  QString reason = QString::fromStdString(lock.error().reason);
  reason[0] = reason[0].toUpper();
  deny(file, taken ? Writable::lockedElsewhere : Writable::notPermitted, reason);
}

/// Says what of a file is at fault and therefore not in the scene.
QString reasonOf(const std::vector<std::string>& leftOut) {
  const QString first = told(leftOut.front());
  const auto more = int(leftOut.size()) - 1;
  return more == 0
             ? tr("Something in it is at fault and was left out: %1").arg(first)
             : tr("Something in it is at fault and was left out: %1; and %n more", nullptr, more)
                   .arg(first);
}

}  // namespace

std::optional<FileStamp> stampOf(const fs::path& file) {
  std::error_code fault;
  const std::uintmax_t bytes = fs::file_size(file, fault);
  if (fault)
    return std::nullopt;
  const fs::file_time_type when = fs::last_write_time(file, fault);
  return fault ? std::nullopt : std::optional(FileStamp{bytes, when});
}

bool isLockOf(const model::FileLock& lock, const fs::path& file) {
  std::error_code fault;
  const fs::path real = fs::weakly_canonical(file, fault);
  return lock.file() == (fault ? file : real);
}

Result<ReadDocument> readDocument(const fs::path& path,
                                  std::shared_ptr<const model::FileLock> held) {
  ReadDocument read;
  read.file.path = path;
  // The lock comes first, so that what is read then stays what is on the disk.
  lock(read.file, std::move(held));
  read.file.stamp = stampOf(path);
  Result<model::SceneDocument> document = model::readSceneFile(path);
  if (!document.ok())
    return document.error();
  if (document->isNewer())
    deny(read.file, Writable::newerProgram,
         tr("A newer version of the program has written it; what is unknown here is not shown, and "
            "a copy is saved in the form of this version"));
  else if (document->isForReading())
    deny(read.file, Writable::newerProgram, reasonOf(document->leftOut));
  read.file.thumbnail = textOrNone(std::move(document->thumbnail));
  if (!document->others.empty())
    read.file.others =
        std::make_shared<const std::vector<model::ZipMember>>(std::move(document->others));
  read.scene = std::move(document->scene);
  return read;
}

Result<ReadDocument> readRecovered(const model::Recoverable& found,
                                   std::shared_ptr<const model::FileLock> held) {
  Result<model::Recovered> recovered = model::recovered(found);
  if (!recovered.ok())
    return recovered.error();
  ReadDocument read{.scene = recovered->states.front().scene, .file = {.left = found}};
  read.file.thumbnail = textOrNone(std::move(recovered->rest.thumbnail));
  if (!recovered->rest.others.empty())
    read.file.others =
        std::make_shared<const std::vector<model::ZipMember>>(std::move(recovered->rest.others));
  read.recovered = std::move(*recovered);
  if (found.source.file.empty())
    return read;
  read.file.path = found.source.file;
  lock(read.file, std::move(held));
  read.file.stamp = stampOf(read.file.path);
  if (read.file.writable == Writable::yes && read.file.stamp && read.file.stamp->when > found.when)
    deny(read.file, Writable::changedOnDisk,
         tr("It was saved after the last of these changes was made"));
  return read;
}

void relock(DocumentFile& file) {
  if (file.path.empty() || file.lock || file.writable == Writable::newerProgram)
    return;
  if (stampOf(file.path) != file.stamp)
    deny(file, Writable::changedOnDisk, tr("Another program has changed it since"));
  else
    lock(file, nullptr);
}

}  // namespace sline::widgets
