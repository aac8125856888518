// SPDX-License-Identifier: Apache-2.0
#include <QFile>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

class ProofTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void listsPairsAndProposals();
  void jsonHoldsThem();
  void appliedSceneIsClean();
  void writesWhatEyesSee();
  void wrongUse_data();
  void wrongUse();

 private:
  QStringList proof(const QStringList& flags) const;
  QTemporaryDir m_folder;
};

void ProofTest::initTestCase() {
  writeObj(m_folder.filePath("left.obj"), *moved(*sphere(24.0f, 4), 1.0f, {-21.0f, 0, 0}), "left");
  writeObj(m_folder.filePath("right.obj"), *moved(*sphere(20.0f, 4), 1.0f, {17.0f, 0, 0}), "right");
}

QStringList ProofTest::proof(const QStringList& flags) const {
  return QStringList{"proof",
                     m_folder.filePath("left.obj"),
                     m_folder.filePath("right.obj"),
                     "--gamma",
                     "5",
                     "--color",
                     "left=#be463c",
                     "right=#488830"} +
         flags;
}

void ProofTest::listsPairsAndProposals() {
  const Finished finished = runSline(proof({}));
  QVERIFY2(finished.code == 0, finished.err.constData());
  QVERIFY2(finished.out.contains("deuteranopia"), finished.out.constData());
  QVERIFY(finished.out.contains("What would help"));
  QVERIFY(!finished.out.contains("No change was found"));
  QVERIFY2(finished.out.contains("As a plate of 2 structures"), finished.out.constData());
  const Finished plain = runSline(proof({"--color", "left=#000000", "right=#ffffff"}));
  QCOMPARE(plain.code, 0);
  QVERIFY2(plain.out.contains("none"), plain.out.constData());
}

void ProofTest::jsonHoldsThem() {
  const Finished finished = runSline(proof({"--json"}));
  QCOMPARE(finished.code, 0);
  const QJsonObject root = QJsonDocument::fromJson(finished.out).object();
  const QJsonArray pairs = root["neighbours"].toArray();
  QCOMPARE(pairs.size(), 1);
  const QJsonArray alike = pairs[0].toObject()["alike"].toArray();
  QVERIFY(alike.contains("deuteranopia") && !alike.contains("normal"));
  QVERIFY(pairs[0].toObject()["difference"].toObject()["normal"].toDouble() > 20.0);
  QCOMPARE(root["proposals"].toArray().size(), 1);
  QVERIFY(root["afterwards"].toArray()[0].toObject()["alike"].toArray().isEmpty());
  const QJsonObject plate = root["plate"].toObject();
  QCOMPARE(plate["subject"].toArray().size(), 2);
  QCOMPARE(plate["subject_seen"].toDouble(), 1.0);
  QVERIFY(plate["ink"].toDouble() < 0.1 && plate["coloured"].toDouble() > 0.1);
  QVERIFY(plate["holds"].toBool());
}

void ProofTest::appliedSceneIsClean() {
  const QString file = m_folder.filePath("mended.sline");
  // The input is a scene file, so the colours are the scene's own.
  const QString scene = m_folder.filePath("scene.sline");
  QCOMPARE(runSline({"import", m_folder.filePath("left.obj"), m_folder.filePath("right.obj"), "-o",
                     scene})
               .code,
           0);
  QCOMPARE(runSline({"view", scene, "--add", "Front", "--gamma", "5", "--color", "left=#be463c",
                     "right=#488830"})
               .code,
           0);
  const Finished finished = runSline({"proof", scene, "--view", "Front", "--apply", "-o", file});
  QVERIFY2(finished.code == 0, finished.err.constData());
  QVERIFY(finished.out.contains("What would help"));
  const Finished again = runSline({"proof", file, "--view", "Front"});
  QCOMPARE(again.code, 0);
  QVERIFY2(again.out.contains("by all eyes:\n  none"), again.out.constData());
}

void ProofTest::writesWhatEyesSee() {
  const QString folder = m_folder.filePath("eyes/of others");
  const Finished finished = runSline(proof({"--out", folder, "--size", "320x180"}));
  QVERIFY2(finished.code == 0, finished.err.constData());
  for (const char* vision : {"normal", "grey", "protanopia", "deuteranopia", "tritanopia"}) {
    const QImage image(folder + "/proof_" + vision + ".png");
    QCOMPARE(image.size(), QSize(320, 180));
    const QColor left = image.pixelColor(110, 90);
    const bool grey = left.red() == left.green() && left.green() == left.blue();
    QCOMPARE(grey, QByteArray(vision) == "grey");
  }
}

void ProofTest::wrongUse_data() {
  QTest::addColumn<QStringList>("flags");
  QTest::addColumn<QByteArray>("says");
  QTest::newRow("nowhere to") << QStringList{"--apply"} << QByteArray("-o");
  QTest::newRow("nothing to write") << QStringList{"-o", "a.sline"} << QByteArray("--apply");
  QTest::newRow("no scene file") << QStringList{"--apply", "-o", "a.png"} << QByteArray("sline");
  QTest::newRow("no bar") << QStringList{"--threshold", "0"} << QByteArray("--threshold");
  QTest::newRow("unknown view") << QStringList{"--view", "askance"} << QByteArray("anterior");
}

void ProofTest::wrongUse() {
  QFETCH(QStringList, flags);
  QFETCH(QByteArray, says);
  const Finished finished = runSline(proof(flags));
  QCOMPARE(finished.code, 2);
  QVERIFY2(finished.err.contains(says), finished.err.constData());
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ProofTest)
#include "proof_test.moc"
