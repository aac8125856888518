// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <QTemporaryDir>
#include <QtTest>
#include <cstring>
#include <fstream>

#include "model/disk/cache_folder.h"
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
  const fs::path left =
      folder.parent_path() / (".frames." + std::to_string(static_cast<long>(getpid())));
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

SLINE_TEST(FoldersTest)
#include "folders_test.moc"
