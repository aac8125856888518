// SPDX-License-Identifier: Apache-2.0
#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <QtTest>
#include <array>
#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>
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
  void whatIsHeldIsNotTaken();
  void fullFoldersAreNotListed();
  void leftOversOfKilledWritersAreSwept();

 private:
  static void killedChild(const std::function<void()>& work);
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

/// What another writer of the same name is at work on is not taken, in this program or another.
void FoldersTest::whatIsHeldIsNotTaken() {
  namespace fs = std::filesystem;
  const QTemporaryDir place;
  const fs::path top = place.path().toStdString();
  const Status first = model::writeBeside(top / "a.png", [&](const fs::path& one) -> Status {
    std::ofstream(one) << "one";
    const Status second = model::writeBeside(top / "a.png", [&](const fs::path& two) -> Status {
      std::ofstream(two) << "two";
      return one != two ? Status(Unit{}) : Status(Error{.reason = "the same place"});
    });
    std::ifstream text(top / "a.png");
    std::string whole;
    text >> whole;
    return second.ok() && whole == "two" ? second : Status(Error{.reason = "second: " + whole});
  });
  QVERIFY2(first.ok(), first.ok() ? "" : first.error().text().c_str());
  QCOMPARE(std::distance(fs::directory_iterator(top), fs::directory_iterator()), std::ptrdiff_t(1));
}

/// Writing a file takes no longer in a folder of many: nothing is looked for in it.
void FoldersTest::fullFoldersAreNotListed() {
  namespace fs = std::filesystem;
  const QTemporaryDir place;
  const fs::path top = place.path().toStdString();
  std::ofstream(top / "frame");
  // The system tells when a folder is read.
  const int watch = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  QVERIFY(watch >= 0 && inotify_add_watch(watch, top.c_str(), IN_ACCESS) >= 0);
  const auto isListed = [watch](const auto& work) {
    work();
    std::array<char, 4096> events{};
    bool listed = false;
    while (read(watch, events.data(), events.size()) > 0)
      listed = true;
    return listed;
  };
  QVERIFY(isListed([&top] { static_cast<void>(fs::directory_iterator(top)); }));
  QVERIFY(!isListed([&top] {
    std::error_code fault;
    const auto part = model::PartBeside::take(top / "b.png", model::PartBeside::Kind::file, fault);
    fs::remove(part->path());
  }));
  close(watch);
}

/// Lets a process of its own do the work, and kills it in the midst of it.
void FoldersTest::killedChild(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
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
  killedChild([&top] {
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
  const std::set<std::string> left = names();
  QCOMPARE(left.size(), std::size_t(3));
  QVERIFY(left.contains(".a.png.1.part"));
  QVERIFY(left.contains(".frames.1.part"));
  // Those of other files, and a person's own.
  const std::set<std::string> others{".b.png.1.part", ".a.png.1", ".a.png.part", ".a.png.x.part"};
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
