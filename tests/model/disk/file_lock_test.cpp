// SPDX-License-Identifier: Apache-2.0
#include "model/disk/file_lock.h"

#include <sys/resource.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>
#include <atomic>
#include <csignal>
#include <fstream>
#include <thread>

#include "model/disk/whole_file.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
namespace fs = std::filesystem;

namespace {
/// While a FullDisk lives, no file may grow beyond its limit, as if the disk were full. (The
/// system's own signal is ignored, so that writing fails as on a disk.)
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &m_before);
    m_handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, m_before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &m_before);
    std::signal(SIGXFSZ, m_handler);
  }

 private:
  rlimit m_before{};
  void (*m_handler)(int) = SIG_DFL;
};

QStringList filesIn(const QTemporaryDir& folder) {
  return QDir(folder.path()).entryList(QDir::Files | QDir::Hidden);
}
}  // namespace

class FileLockTest : public QObject {
  Q_OBJECT
 private slots:
  void oneWriter();
  void lockGoesWithItsProcess();
  void lookingDoesNotHold();
  void linksLeadToOneLock();
  void savingLeavesNothingBeside();
  void fullDiskLeavesTheOldFile();
  void folderThatCannotBeWritten();
  void rightsAndLinksStay();
};

void FileLockTest::oneWriter() {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  QVERIFY(!FileLock::held(file));
  {
    const auto first = FileLock::acquire(file);
    QVERIFY(first.ok());
    QVERIFY(FileLock::held(file));
    const auto second = FileLock::acquire(file);
    QVERIFY(!second.ok());
    const std::string me = "process " + std::to_string(getpid());
    QVERIFY2(second.error().reason.find(me) != std::string::npos, second.error().text().c_str());
    QVERIFY(!writeSceneFile(file, {}).ok());
    QVERIFY(!fs::exists(file));
    QVERIFY(writeSceneFile(*first, {}).ok());
  }
  QVERIFY(!FileLock::held(file));
  QVERIFY(writeSceneFile(file, {}).ok());
}

void FileLockTest::lockGoesWithItsProcess() {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  // A crash has left a lock file, as if written by a process with the mark of another number in it.
  QVERIFY(writeText(FileLock::besides(file), "process 1 on elsewhere\n").ok());
  QVERIFY(!FileLock::held(file));
  QVERIFY(FileLock::acquire(file).ok());
  QCOMPARE(filesIn(folder), QStringList());
}

void FileLockTest::lookingDoesNotHold() {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  // A lock file stays, so that there is something to look at between two holders.
  QVERIFY(writeText(FileLock::besides(file), "").ok());
  std::atomic<bool> done = false;
  std::thread looking([&] {
    while (!done)
      static_cast<void>(FileLock::held(file));
  });
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    refused += FileLock::acquire(file).ok() ? 0 : 1;
    static_cast<void>(writeText(FileLock::besides(file), ""));
  }
  done = true;
  looking.join();
  QCOMPARE(refused, 0);
}

void FileLockTest::linksLeadToOneLock() {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  const fs::path link = folder.filePath("link.sline").toStdString();
  QVERIFY(writeSceneFile(file, {}).ok());
  fs::create_symlink(file, link);
  const auto lock = FileLock::acquire(link);
  QVERIFY(lock.ok());
  QVERIFY(!FileLock::acquire(file).ok());
}

void FileLockTest::savingLeavesNothingBeside() {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  // Files left by writers that were killed are taken over; files named otherwise stay.
  for (const char* name : {".a.sline.1.part", ".a.sline.backup", ".b.sline.1.part"})
    std::ofstream(folder.filePath(name).toStdString()) << "x";
  QVERIFY(writeSceneFile(file, {.scene = test::sampleScene()}).ok());
  QCOMPARE(filesIn(folder), QStringList({".a.sline.backup", ".b.sline.1.part", "a.sline"}));
}

void FileLockTest::fullDiskLeavesTheOldFile() {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  QVERIFY(writeSceneFile(file, {}).ok());
  const std::string before = *readText(file, 1 << 20);
  const Status full = [&] {
    const FullDisk disk(1000);
    return writeSceneFile(file, {.scene = test::sampleScene()});
  }();
  QVERIFY(!full.ok());
  QCOMPARE(full.error().file, file.string());
  QVERIFY2(full.error().reason.find("cannot be written") != std::string::npos &&
               full.error().reason.find("is whole") != std::string::npos &&
               full.error().remedy.find("space") != std::string::npos,
           full.error().text().c_str());
  QCOMPARE(*readText(file, 1 << 20), before);
  QCOMPARE(filesIn(folder), QStringList({"a.sline"}));
}

void FileLockTest::folderThatCannotBeWritten() {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  QVERIFY(writeSceneFile(file, {}).ok());
  fs::path place = file;
  if (geteuid() == 0)
    place = "/sys/a.sline";  // no user may make files there, not even the superuser
  else
    fs::permissions(folder.path().toStdString(), fs::perms::owner_read | fs::perms::owner_exec);
  const Status written = writeSceneFile(place, {.scene = test::sampleScene()});
  fs::permissions(folder.path().toStdString(), fs::perms::owner_all);
  QVERIFY(!written.ok());
  QVERIFY2(written.error().reason.find("cannot be written to") != std::string::npos,
           written.error().text().c_str());
  QVERIFY(readSceneFile(file).ok());
  QCOMPARE(filesIn(folder), QStringList({"a.sline"}));
  const Status nowhere =
      writeSceneFile(folder.filePath("no/such/folder/a.sline").toStdString(), {});
  QVERIFY(!nowhere.ok() && !nowhere.error().remedy.empty());
}

void FileLockTest::rightsAndLinksStay() {
  const QTemporaryDir folder;
  const fs::path file = folder.filePath("a.sline").toStdString();
  const fs::path link = folder.filePath("link.sline").toStdString();
  QVERIFY(writeSceneFile(file, {}).ok());
  const fs::perms mine = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(file, mine);
  fs::create_symlink("a.sline", link);
  QVERIFY(writeSceneFile(link, {.scene = test::sampleScene()}).ok());
  QVERIFY(fs::is_symlink(link));
  QCOMPARE(fs::status(file).permissions(), mine);
  QCOMPARE(readSceneFile(file)->scene.nodes().size(), test::sampleScene().nodes().size());
}

SLINE_TEST(FileLockTest)
#include "file_lock_test.moc"
