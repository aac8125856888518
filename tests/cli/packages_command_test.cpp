// SPDX-License-Identifier: Apache-2.0
// Tests `sline export --package` and the flags of its kinds.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "model/disk/zip_archive.h"
#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {

class PackagesCommandTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_scene = m_folder.filePath("scene.sline");

  QString path(const char* name) const { return m_folder.filePath(name); }
  QByteArray bytes(const char* name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  Finished exported(const QStringList& flags) const {
    return runSline(QStringList{"export", m_scene, "--size-mm", "80x60"} + flags);
  }
  QStringList membersOf(const char* name) const {
    const std::string zip = bytes(name).toStdString();
    const auto reader = model::ZipReader::open(zip);
    QStringList names;
    if (reader.ok())
      for (const auto& entry : reader->entries())
        names << QString::fromStdString(entry.name);
    return names;
  }

 private slots:
  void initTestCase() {
    const QString sample = writeSample(m_folder.path());
    QCOMPARE(runSline({"import", sample, "-o", m_scene}).code, 0);
    QCOMPARE(runSline({"annotate", m_scene, "--on", "kidney"}).code, 0);
  }

  void kindsHaveFlagsOfTheirOwn() {
    QCOMPARE(exported({"--package", "moodle", "-o", path("a.xml")}).code, 0);
    QCOMPARE(exported({"--moodle", path("b.xml")}).code, 0);
    QVERIFY(bytes("a.xml").contains("<quiz>"));
    QCOMPARE(bytes("a.xml"), bytes("b.xml"));
    QCOMPARE(exported({"--package", "qti", "--output", path("a.zip")}).code, 0);
    QVERIFY(membersOf("a.zip").contains("imsmanifest.xml"));
    QCOMPARE(exported({"--package", "h5p", "-o", path("a.h5p")}).code, 0);
    QVERIFY(membersOf("a.h5p").contains("h5p.json"));
  }

  void wrongUse_data() {
    QTest::addColumn<QStringList>("flags");
    QTest::addColumn<QByteArray>("says");
    QTest::newRow("no file") << QStringList{"--package", "qti"}
                             << QByteArray("--package qti names no file");
    QTest::newRow("no kind") << QStringList{"-o", "a.xml"} << QByteArray("nothing says what kind");
    QTest::newRow("another kind") << QStringList{"--package", "png", "-o", "a.png"}
                                  << QByteArray("moodle");
    QTest::newRow("another's ending") << QStringList{"--package", "moodle", "-o", "a.h5p"}
                                      << QByteArray(".h5p is the ending of another kind");
    QTest::newRow("twice") << QStringList{"--package", "qti", "-o", "a.zip", "--qti", "b.zip"}
                           << QByteArray("two files of one kind");
  }
  void wrongUse() {
    QFETCH(QStringList, flags);
    QFETCH(QByteArray, says);
    const Finished finished = exported(flags);
    QCOMPARE(finished.code, 2);
    QVERIFY2(finished.err.contains(says), finished.err.constData());
  }

  void nothingToAsk() {
    const QString bare = path("bare.sline");
    QCOMPARE(runSline({"import", writeSample(m_folder.path()), "-o", bare}).code, 0);
    const Finished finished =
        runSline({"export", bare, "--package", "moodle", "-o", path("none.xml")});
    QCOMPARE(finished.code, 1);
    QVERIFY2(finished.err.contains("no labels to ask for"), finished.err.constData());
    QVERIFY(!QFile::exists(path("none.xml")));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::PackagesCommandTest)
#include "packages_command_test.moc"
