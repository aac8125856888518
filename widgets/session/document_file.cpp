// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/document_file.h"

#include <limits>
#include <system_error>

#include "model/disk/whole_file.h"
#include "model/scene_file/fingerprint.h"
#include "widgets/text/told.h"
#include "widgets/text/tr.h"

namespace sline::widgets {

namespace fs = std::filesystem;

namespace {

std::shared_ptr<const std::string> textOrNone(std::string text) {
  return text.empty() ? nullptr : std::make_shared<const std::string>(std::move(text));
}

/// Returns the path as it is from everywhere.
fs::path wholePath(const fs::path& path) {
  std::error_code fault;
  fs::path all = fs::absolute(path, fault);
  return fault ? path : all;
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

/// Keeps a scene that lost something from being saved where it may still be.
void tellLeftOut(ReadDocument& read) {
  if (!read.recovered->leftOut.empty())
    deny(read.file, Writable::newerProgram, reasonOf(read.recovered->leftOut));
}

}  // namespace

std::optional<model::Fingerprint> stampOf(const fs::path& file) {
  constexpr model::Fingerprint ofNoFile{.bytes = std::numeric_limits<std::uint64_t>::max()};
  std::error_code fault;
  const fs::file_status status = fs::status(file, fault);
  if (status.type() == fs::file_type::not_found)
    return std::nullopt;
  // Reading from a pipe or a device may never end.
  if (fault || !fs::is_regular_file(status))
    return ofNoFile;
  const Result<model::Fingerprint> found = model::fingerprintOfFile(file);
  return found.ok() ? *found : ofNoFile;
}

bool isLockOf(const model::FileLock& lock, const fs::path& file) {
  std::error_code fault;
  const fs::path real = fs::weakly_canonical(file, fault);
  return lock.file() == (fault ? file : real);
}

Result<ReadDocument> readDocument(const fs::path& path,
                                  std::shared_ptr<const model::FileLock> held) {
  ReadDocument read;
  read.file.path = wholePath(path);
  // The lock comes first, so that what is read then stays what is on the disk.
  lock(read.file, std::move(held));
  read.file.state = model::fileState(read.file.path);
  model::SceneDocument document = TRY(model::readSceneFile(path));
  read.file.whole = document.whole;
  read.file.stamp = document.whole ? document.whole : stampOf(path);
  if (document.isNewer())
    deny(read.file, Writable::newerProgram,
         tr("A newer version of the program has written it; what is unknown here is not shown, and "
            "a copy is saved in the form of this version"));
  else if (document.isForReading())
    deny(read.file, Writable::newerProgram, reasonOf(document.leftOut));
  read.file.thumbnail = textOrNone(std::move(document.thumbnail));
  if (!document.others.empty())
    read.file.others =
        std::make_shared<const std::vector<model::ZipMember>>(std::move(document.others));
  read.scene = std::move(document.scene);
  return read;
}

Result<ReadDocument> readRecovered(const model::Recoverable& found,
                                   std::shared_ptr<const model::FileLock> held) {
  model::Recovered recovered = TRY(model::recovered(found));
  ReadDocument read{.scene = recovered.states.front().scene, .file = {.left = found}};
  read.file.thumbnail = textOrNone(std::move(recovered.rest.thumbnail));
  if (!recovered.rest.others.empty())
    read.file.others =
        std::make_shared<const std::vector<model::ZipMember>>(std::move(recovered.rest.others));
  read.recovered = std::move(recovered);
  // A name without its folder may be that of any file.
  if (!found.source.file.is_absolute()) {
    tellLeftOut(read);
    return read;
  }
  read.file.path = found.source.file;
  read.file.stamp = found.source.saved;
  lock(read.file, std::move(held));
  const std::optional<model::Fingerprint> now = stampOf(read.file.path);
  if (read.file.writable == Writable::yes && now && now != read.file.stamp)
    deny(read.file, Writable::changedOnDisk,
         read.file.stamp ? tr("It has changed since the program ended with these changes unsaved")
                         : tr("Whether it has changed since the program ended is not known"));
  tellLeftOut(read);
  return read;
}

void takeStamp(DocumentFile& file) {
  file.state = model::fileState(file.path);
  file.stamp = stampOf(file.path);
}

void relock(DocumentFile& file) {
  if (file.path.empty() || file.lock || file.writable == Writable::newerProgram)
    return;
  // The window waits for this, and a file may be large. Saving compares its content again.
  if (file.state && file.state == model::fileState(file.path))
    return lock(file, nullptr);
  // Where there is no file any more, nothing is written over.
  const std::optional<model::Fingerprint> now = stampOf(file.path);
  if (!now || now == file.stamp)
    lock(file, nullptr);
  else if (file.writable != Writable::changedOnDisk)
    deny(file, Writable::changedOnDisk, tr("Another program has changed it since"));
}

}  // namespace sline::widgets
