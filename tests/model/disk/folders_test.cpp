// SPDX-License-Identifier: Apache-2.0
#include <sys/wait.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QtTest>
#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <set>

#include "model/disk/cache_folder.h"
#include "model/disk/left_overs.h"
#include "model/disk/temporary_folder.h"
#include "model/disk/whole_file.h"
#include "model/disk/whole_folder.h"
#include "model/scene_file/ply_writer.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;

class FoldersTest : public QObject {
  Q_OBJECT
 private slots:
  void plyIsExact();
  void userFolders_data();
  void userFolders();
  void whatWasLeftIsNotTaken();
  void leftOversOfKilledWritersAreSwept();

 private:
  static pid_t killedChild(const std::function<void()>& work);
};

void FoldersTest::plyIsExact() {
  const auto mesh = test::sphere(3.1f, 1);
  const std::string text = model::plyText(*mesh, "SPACE=LPS");
  QVERIFY(text.starts_with("ply\nformat binary_little_endian 1.0\ncomment SPACE=LPS\n"));
  const std::size_t body = text.find("end_header\n") + 11;
  QCOMPARE(text.size(), body + 12 * mesh->vertexCount() + 13 * mesh->triangleCount());
  QVERIFY(std::memcmp(text.data() + body, mesh->positions().data(), 12 * mesh->vertexCount()) == 0);
  const char* faces = text.data() + body + 12 * mesh->vertexCount();
  for (std::size_t i = 0; i < mesh->triangleCount(); ++i) {
    QCOMPARE(int(faces[13 * i]), 3);
    QVERIFY(std::memcmp(faces + 13 * i + 1, &mesh->triangles()[i], 12) == 0);
  }
}

void FoldersTest::userFolders_data() {
  QTest::addColumn<QByteArray>("variable");
  QTest::addColumn<QString>("inHome");
  QTest::newRow("cache") << QByteArray("XDG_CACHE_HOME") << "/home/someone/.cache/sline";
  QTest::newRow("state") << QByteArray("XDG_STATE_HOME") << "/home/someone/.local/state/sline";
}

void FoldersTest::userFolders() {
  QFETCH(QByteArray, variable);
  QFETCH(QString, inHome);
  const auto folder = [&] {
    return variable == "XDG_CACHE_HOME" ? model::userCacheFolder() : model::userStateFolder();
  };
  const QByteArray before = qgetenv(variable.constData());
  const QByteArray home = qgetenv("HOME");
  qputenv("HOME", "/home/someone");
  qputenv(variable.constData(), "/somewhere");
  QCOMPARE(folder().string(), std::string("/somewhere/sline"));
  qputenv(variable.constData(), "relative");
  QCOMPARE(folder().string(), inHome.toStdString());
  qunsetenv(variable.constData());
  QCOMPARE(folder().string(), inHome.toStdString());
  qunsetenv("HOME");
  QVERIFY(folder().empty());
  qputenv(variable.constData(), before);
  qputenv("HOME", home);
}

/// A program that was killed left a folder, and its number has been given out again.
void FoldersTest::whatWasLeftIsNotTaken() {
  namespace fs = std::filesystem;
  const QTemporaryDir place;
  const fs::path folder = fs::path(place.path().toStdString()) / "frames";
  const fs::path left = model::partBeside(folder);
  fs::create_directory(left);
  std::ofstream(left / "old.png") << "old";
  const Status written = model::writeFolder(folder, [](const fs::path& temporary) -> Status {
    std::ofstream(temporary / "new.png") << "new";
    return Unit{};
  });
  QVERIFY(written.ok());
  QVERIFY(fs::exists(folder / "new.png"));
  QVERIFY(!fs::exists(folder / "old.png"));
  QVERIFY(fs::exists(left / "old.png"));
  QCOMPARE(std::distance(fs::directory_iterator(folder.parent_path()), fs::directory_iterator()),
           std::ptrdiff_t(2));
}

/// Lets a process of its own do the work, and kills it in the midst of it.
pid_t FoldersTest::killedChild(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  return child;
}

/// What a killed program left of a file, a folder or a temporary folder goes when the next one
/// writes there; what others are writing, and files of other names, stay.
void FoldersTest::leftOversOfKilledWritersAreSwept() {
  namespace fs = std::filesystem;
  const QTemporaryDir place;
  const fs::path top = place.path().toStdString();
  qputenv("TMPDIR", place.path().toUtf8());
  const auto names = [&top] {
    std::set<std::string> all;
    for (const fs::directory_entry& entry : fs::directory_iterator(top))
      all.insert(entry.path().filename().string());
    return all;
  };
  const pid_t child = killedChild([&top] {
    static_cast<void>(model::writeBeside(top / "a.png", [&top](const fs::path& part) -> Status {
      std::ofstream(part) << "half";
      static_cast<void>(model::writeFolder(top / "frames", [](const fs::path& folder) -> Status {
        std::ofstream(folder / "1.png") << "half";
        const auto temporary = model::TemporaryFolder::create();
        std::ofstream(temporary->path() / "x") << "half";
        kill(getpid(), SIGKILL);
        return Unit{};
      }));
      return Unit{};
    }));
  });
  const std::string number = std::to_string(child);
  const std::set<std::string> left = names();
  QCOMPARE(left.size(), std::size_t(3));
  QVERIFY(left.contains(".a.png." + number + ".part"));
  QVERIFY(left.contains(".frames." + number + ".part"));
  // Those of a running process – its parent – and of other files, and a person's own.
  const std::string parent = std::to_string(getppid());
  const std::set<std::string> others{".a.png." + parent + ".part", ".b.png." + number + ".part",
                                     ".a.png." + number, ".a.png.part", ".a.png.x.part"};
  for (const std::string& name : others)
    std::ofstream(top / name) << "x";
  QVERIFY(model::writeText(top / "a.png", "whole").ok());
  QVERIFY(model::writeFolder(top / "frames", [](const fs::path&) { return Unit{}; }).ok());
  {
    const auto mine = model::TemporaryFolder::create();
    QVERIFY(mine.ok());
    const auto second = model::TemporaryFolder::create();
    QVERIFY(second.ok() && fs::exists(mine->path()));
  }
  std::set<std::string> expected = others;
  expected.insert({"a.png", "frames"});
  QVERIFY(names() == expected);
  qunsetenv("TMPDIR");
}

SLINE_TEST(FoldersTest)
#include "folders_test.moc"
