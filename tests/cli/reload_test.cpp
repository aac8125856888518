// SPDX-License-Identifier: Apache-2.0
// Tests `sline reload`, and saved views in `sline render`.
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {
namespace {

QByteArray contentOf(const QString& name) {
  QFile file(name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class ReloadTest : public QObject {
  Q_OBJECT

 private slots:
  void init();
  void nothingHasChanged();
  void changedMeshIsReplaced();
  void dryRunWritesNothing();
  void anotherFileIsWritten();
  void whatCannotBeReadStays();
  void besideTheSceneByDefault();
  void wrongUse_data();
  void wrongUse();
  void savedViews();

 private:
  QString at(const QString& name) const { return m_folder->filePath(name); }
  Finished reload(const QStringList& more = {}) const {
    return runSline(QStringList{"reload", m_scene, "--from", m_meshes} + more);
  }
  double kidneyWidth(const QString& scene) const;
  void changeKidney(float radius) const {
    writeObj(m_meshes + "/Organs/kidney.obj", *sphere(radius, 3));
  }

  std::unique_ptr<QTemporaryDir> m_folder;
  QString m_meshes;
  QString m_scene;
};

void ReloadTest::init() {
  m_folder = std::make_unique<QTemporaryDir>();
  m_meshes = writeSample(at("meshes"));
  m_scene = at("sample.sline");
  const Finished finished = runSline({"import", m_meshes, "-o", m_scene, "--smooth", "off"});
  QVERIFY2(finished.code == 0, finished.err.constData());
}

double ReloadTest::kidneyWidth(const QString& scene) const {
  const Finished finished = runSline({"info", "--json", scene});
  for (const QJsonValue& structure :
       QJsonDocument::fromJson(finished.out).object()["structures"].toArray())
    if (structure["name"].toString() == "kidney")
      return structure["bounds_mm"][1][0].toDouble() - structure["bounds_mm"][0][0].toDouble();
  return -1.0;
}

void ReloadTest::nothingHasChanged() {
  const QByteArray before = contentOf(m_scene);
  const Finished finished = reload();
  QCOMPARE(finished.code, 0);
  QVERIFY2(finished.out.contains("kidney.obj: unchanged: kidney\n"), finished.out.constData());
  QCOMPARE(contentOf(m_scene), before);
}

void ReloadTest::changedMeshIsReplaced() {
  changeKidney(20.0f);
  QFile::remove(m_meshes + "/Vessels/renal vein.obj");
  const Finished finished = reload();
  // One is missing, which a script is to notice.
  QVERIFY2(finished.code == 1, finished.err.constData());
  QVERIFY2(finished.out.contains("kidney.obj: replaced: kidney\n"), finished.out.constData());
  QVERIFY(finished.out.contains("renal artery.obj: unchanged"));
  QVERIFY(finished.out.contains("renal vein.obj: not found"));
  QCOMPARE(kidneyWidth(m_scene), 40.0);
}

void ReloadTest::dryRunWritesNothing() {
  const QByteArray before = contentOf(m_scene);
  changeKidney(20.0f);
  const Finished finished = reload({"--dry-run"});
  QCOMPARE(finished.code, 0);
  QVERIFY(finished.out.contains("kidney.obj: would be replaced: kidney"));
  QCOMPARE(contentOf(m_scene), before);
}

void ReloadTest::anotherFileIsWritten() {
  const QByteArray before = contentOf(m_scene);
  changeKidney(20.0f);
  QCOMPARE(reload({"-o", at("new.sline")}).code, 0);
  QCOMPARE(contentOf(m_scene), before);
  QCOMPARE(kidneyWidth(at("new.sline")), 40.0);
}

void ReloadTest::whatCannotBeReadStays() {
  writeFile(m_meshes + "/Organs/kidney.obj", "v 1 2\n");
  const Finished finished = reload();
  QCOMPARE(finished.code, 1);
  QVERIFY2(finished.out.contains("kidney.obj: stays as it is ("), finished.out.constData());
  QCOMPARE(kidneyWidth(m_scene), 60.0);
}

void ReloadTest::besideTheSceneByDefault() {
  changeKidney(20.0f);
  QVERIFY(QFile::rename(m_scene, m_meshes + "/sample.sline"));
  QCOMPARE(runSline({"reload", m_meshes + "/sample.sline"}).code, 0);
  QCOMPARE(kidneyWidth(m_meshes + "/sample.sline"), 40.0);
}

void ReloadTest::wrongUse_data() {
  QTest::addColumn<QStringList>("arguments");
  QTest::addColumn<int>("code");
  QTest::newRow("no scene") << QStringList{} << 2;
  QTest::newRow("a mesh") << QStringList{"liver.ply"} << 2;
  QTest::newRow("into a mesh") << QStringList{"a.sline", "-o", "b.ply"} << 2;
  QTest::newRow("dry into a file") << QStringList{"a.sline", "--dry-run", "-o", "b.sline"} << 2;
  QTest::newRow("absent") << QStringList{"/nowhere/a.sline"} << 1;
}

void ReloadTest::wrongUse() {
  QFETCH(QStringList, arguments);
  QFETCH(int, code);
  QCOMPARE(runSline(QStringList{"reload"} + arguments).code, code);
}

void ReloadTest::savedViews() {
  writeFile(m_meshes + "/s.mrml",
            "<MRML version=\"Slicer5.2\">"
            "<Model id=\"K\" name=\"kidney\" storageNodeRef=\"S\" displayNodeRef=\"D\"/>"
            "<ModelStorage id=\"S\" fileName=\"Organs/kidney.obj\"/>"
            "<ModelDisplay id=\"D\" color=\"1 0 0\" visibility=\"true\"/>"
            "<SceneView name=\"Blue_kidney\"><Camera position=\"0 400 0\" focalPoint=\"0 0 0\" "
            "viewUp=\"0 0 1\"/><Model id=\"K\" displayNodeRef=\"D\"/>"
            "<ModelDisplay id=\"D\" color=\"0 0 1\" visibility=\"true\"/></SceneView></MRML>");
  const auto drawn = [&](const QStringList& more) {
    const QString file = at("x.png");
    const Finished finished = runSline(QStringList{"render", m_meshes + "/s.mrml", "-o", file,
                                                   "--size", "160x120", "--gamma", "5"} +
                                       more);
    return finished.code == 0 ? readPicture(file) : Pixels();
  };
  QVERIFY(tinted(drawn({"--view", "anterior"}), 0).count > 500);
  const Pixels blue = drawn({"--view", "kidney"});
  QVERIFY(tinted(blue, 2).count > 500);
  QCOMPARE(tinted(blue, 0).count, 0);
  // Flags override the view.
  QVERIFY(tinted(drawn({"--view", "kidney", "--color", "kidney=#ff0000"}), 0).count > 500);
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ReloadTest)
#include "reload_test.moc"
