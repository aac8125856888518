// SPDX-License-Identifier: Apache-2.0
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <map>

#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {
namespace {

QJsonObject objectIn(const QByteArray& text) {
  return QJsonDocument::fromJson(text).object();
}

/// Returns group and counts of each structure by name.
std::map<QString, QJsonObject> structuresIn(const QJsonObject& root) {
  std::map<QString, QJsonObject> all;
  for (const QJsonValue& value : root["structures"].toArray())
    all[value["name"].toString()] = value.toObject();
  return all;
}

QByteArray contentOf(const QString& file) {
  QFile opened(file);
  return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray();
}

}  // namespace

/// Tests all with the kidney, which is modelled in no time, and with a cache folder of the test's
/// own.
class DemoTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void cleanupTestCase();
  void listsItsStructures();
  void folderGivesNamesAndGroupsBack();
  void ownFolderIsReplaced();
  void foreignFilesStay_data();
  void foreignFilesStay();
  void wrongUse_data();
  void wrongUse();
  void picture();
  void cacheIsMadeAndMended();

 private:
  QString at(const char* name) const { return m_folder.filePath(name); }
  QString cacheFile() const {
    const QDir cache(at("cache/sline"));
    const QStringList files = cache.entryList({"kidney*.sline"}, QDir::Files);
    return files.size() == 1 ? cache.filePath(files.front()) : QString();
  }
  QTemporaryDir m_folder;
  QByteArray m_userCache;
};

void DemoTest::initTestCase() {
  m_userCache = qgetenv("XDG_CACHE_HOME");
  qputenv("XDG_CACHE_HOME", at("cache").toUtf8());
}

void DemoTest::cleanupTestCase() {
  qputenv("XDG_CACHE_HOME", m_userCache);
}

void DemoTest::listsItsStructures() {
  const Finished table = runSline({"demo", "kidney"});
  QCOMPARE(table.code, 0);
  QVERIFY(table.out.contains("left renal vein"));
  QVERIFY(table.out.contains("4 structures"));
  const QJsonObject root = objectIn(runSline({"demo", "kidney", "--json"}).out);
  QCOMPARE(root["structures"].toArray().size(), 4);
  QCOMPARE(root["frame"].toString(), QString("LPS"));
}

void DemoTest::folderGivesNamesAndGroupsBack() {
  const QString folder = at("meshes");
  QCOMPARE(runSline({"demo", "kidney", "-o", folder}).code, 0);
  const auto listed = structuresIn(objectIn(runSline({"demo", "kidney", "--json"}).out));
  const Finished info = runSline({"info", "--json", folder});
  QCOMPARE(info.code, 0);
  QCOMPARE(objectIn(info.out)["frame"].toString(), QString("LPS"));
  QVERIFY(objectIn(info.out)["warnings"].toArray().isEmpty());
  QVERIFY(structuresIn(objectIn(info.out)) == listed);
}

void DemoTest::ownFolderIsReplaced() {
  const QString folder = at("again");
  QCOMPARE(runSline({"demo", "kidney", "-o", folder}).code, 0);
  const QString mesh = folder + "/Vessels/left renal vein.ply";
  const QByteArray before = contentOf(mesh);
  QVERIFY(before.size() > 1000);
  writeFile(mesh, "changed");
  writeFile(folder + "/notes.txt", "mine");
  // A file that an earlier run listed and this one does not write is removed.
  writeFile(folder + "/old.ply", "old");
  writeFile(folder + "/sline-files.txt", contentOf(folder + "/sline-files.txt") + "old.ply\n");
  QCOMPARE(runSline({"demo", "kidney", "-o", folder}).code, 0);
  QCOMPARE(contentOf(mesh), before);
  QCOMPARE(contentOf(folder + "/notes.txt"), QByteArray("mine"));
  QVERIFY(!QFile::exists(folder + "/old.ply"));
}

void DemoTest::foreignFilesStay_data() {
  QTest::addColumn<QString>("file");
  QTest::addColumn<QByteArray>("content");
  QTest::newRow("a folder in use") << "x.txt" << QByteArray("mine");
  QTest::newRow("another list") << "sline-files.txt" << QByteArray("shopping\n");
  QTest::newRow("a list that leads outside")
      << "sline-files.txt"
      << QByteArray("Files written by sline; writing here again replaces them.\n../victim\n");
}

void DemoTest::foreignFilesStay() {
  QFETCH(QString, file);
  QFETCH(QByteArray, content);
  const QTemporaryDir parent;
  const QString folder = parent.filePath("folder");
  QVERIFY(QDir().mkpath(folder));
  writeFile(folder + "/" + file, content);
  writeFile(parent.filePath("victim"), "alive");
  const Finished finished = runSline({"demo", "kidney", "-o", folder});
  QCOMPARE(finished.code, 1);
  QVERIFY(finished.err.contains("Name a new or an empty folder"));
  QCOMPARE(contentOf(folder + "/" + file), content);
  QCOMPARE(contentOf(parent.filePath("victim")), QByteArray("alive"));
  QCOMPARE(QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot).size(), 1);
}

void DemoTest::wrongUse_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<QByteArray>("says");
  QTest::newRow("unknown scene") << QStringList{"brain"} << QByteArray("brain");
  QTest::newRow("unknown sex") << QStringList{"kidney", "--sex", "x"} << QByteArray("--sex");
  QTest::newRow("no such picture") << QStringList{"kidney", "-o", "a.pdf"} << QByteArray(".pdf");
  QTest::newRow("flags without picture")
      << QStringList{"kidney", "--gamma", "3"} << QByteArray("--output");
  QTest::newRow("style for meshes")
      << QStringList{"kidney", "-o", at("styled"), "--gamma", "3"} << QByteArray("no style");
  QTest::newRow("list and picture")
      << QStringList{"kidney", "--json", "-o", at("a.png")} << QByteArray("--json");
}

void DemoTest::wrongUse() {
  QFETCH(QStringList, arguments);
  QFETCH(QByteArray, says);
  const Finished finished = runSline(QStringList{"demo"} + arguments);
  QCOMPARE(finished.code, 2);
  QVERIFY2(finished.err.contains(says), finished.err.constData());
  QVERIFY(!QFile::exists(at("styled")));
}

void DemoTest::picture() {
  const QString file = at("kidney.png");
  QCOMPARE(runSline({"demo", "kidney", "-o", file, "--size", "160x120"}).code, 0);
  const Pixels pixels = readPicture(file);
  QCOMPARE(pixels.width, 160);
  QVERIFY(drawnBox(pixels).bottom - drawnBox(pixels).top > 90);
  const Finished unknown = runSline({"demo", "kidney", "-o", file, "--view", "nowhere"});
  QCOMPARE(unknown.code, 2);
}

void DemoTest::cacheIsMadeAndMended() {
  const QByteArray listed = runSline({"demo", "kidney", "--json"}).out;
  const QString file = cacheFile();
  const QByteArray kept = contentOf(file);
  QVERIFY(kept.size() > 100000);
  for (const QByteArray& bad : {QByteArray(), QByteArray("no scene"), kept.left(kept.size() / 2)}) {
    writeFile(file, bad);
    QCOMPARE(runSline({"demo", "kidney", "--json"}).out, listed);
    QCOMPARE(contentOf(file), kept);
  }
  // A cache that cannot be written gives no message.
  qputenv("XDG_CACHE_HOME", file.toUtf8());
  const Finished finished = runSline({"demo", "kidney", "--json"});
  qputenv("XDG_CACHE_HOME", at("cache").toUtf8());
  QCOMPARE(finished.code, 0);
  QCOMPARE(finished.out, listed);
  QVERIFY(finished.err.isEmpty());
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::DemoTest)
#include "demo_test.moc"
