// SPDX-License-Identifier: Apache-2.0
// Tests `sline pockets` on a molecule made for the test: a shell of atoms around a hollow.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {
namespace {

/// Writes carbons around a hollow of 4 Å, which a ligand of six atoms lies in.
void writeHollow(const QString& file) {
  QByteArray text;
  int serial = 0;
  const auto atom = [&](const char* kind, const char* residue, int number, double x, double y,
                        double z) {
    text += QString::asprintf("%-6s%5d  C   %3s A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C\n",
                              kind, ++serial, residue, number, x, y, z)
                .toLatin1();
  };
  // Carbon's radius is 1.7 Å.
  const double reach = 5.7;
  const int count = 700;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - 2.0 * (i + 0.5) / count;
    const double turn = 2.39996323 * i;
    const double across = reach * std::sqrt(1.0 - z * z);
    atom("ATOM", "ALA", 1 + i / 10, across * std::cos(turn), across * std::sin(turn), reach * z);
  }
  text += "TER\n";
  for (int i = 0; i < 6; ++i)
    atom("HETATM", "BNZ", 900, 1.4 * std::cos(i * M_PI / 3.0), 1.4 * std::sin(i * M_PI / 3.0), 0.0);
  writeFile(file, text + "END\n");
}

}  // namespace

class PocketsCommandTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    m_file = m_folder.filePath("hollow.pdb");
    writeHollow(m_file);
  }

  void jsonHasItsShape() {
    const Finished finished = runSline({"pockets", m_file, "--json"});
    QVERIFY2(finished.code == 0, finished.err.constData());
    const QJsonObject root = QJsonDocument::fromJson(finished.out).object();
    QVERIFY(std::abs(root["small_probe_angstrom"].toDouble() - 1.4) < 1e-6);
    const QJsonArray pockets = root["pockets"].toArray();
    QCOMPARE(pockets.size(), 1);
    const QJsonObject pocket = pockets[0].toObject();
    QCOMPARE(pocket["number"].toInt(), 1);
    QVERIFY(std::abs(pocket["volume_angstrom3"].toDouble() / 268.1 - 1.0) < 0.08);
    QCOMPARE(pocket["mouth_angstrom2"].toDouble(), 0.0);
    QVERIFY(pocket["lining"].toArray().size() > 60);
    QVERIFY(pocket["lining"].toArray().contains("ALA A 1"));
    QCOMPARE(pocket["holds"].toArray().size(), 1);
  }

  void tableAndOptions() {
    const Finished table = runSline({"pockets", m_file});
    QCOMPARE(table.code, 0);
    QVERIFY(table.out.contains("volume Å³"));
    QVERIFY(table.out.contains("BNZ"));
    const Finished none = runSline({"pockets", m_file, "--least-volume", "400"});
    QCOMPARE(none.code, 0);
    QVERIFY(none.out.contains("no pocket"));
    QCOMPARE(runSline({"pockets", m_file, "--probe", "9"}).code, 2);
    QCOMPARE(runSline({"pockets", m_file, "--focus", "1"}).code, 2);
    const Finished mesh = runSline({"pockets", writeSample(m_folder.path())});
    QCOMPARE(mesh.code, 1);
    QVERIFY(mesh.err.contains("PDB"));
  }

  /// The scene with a pocket in focus has its room and a view into it, and the same pockets.
  void focusIsWritten() {
    const QString scene = m_folder.filePath("focus.sline");
    const Finished written = runSline({"pockets", m_file, "--focus", "1", "-o", scene});
    QVERIFY2(written.code == 0, written.err.constData());
    const Finished info = runSline({"info", scene});
    QVERIFY(info.out.contains("Pocket 1"));
    const Finished again = runSline({"pockets", scene});
    QCOMPARE(again.code, 0);
    QCOMPARE(again.out, runSline({"pockets", m_file}).out);
    QCOMPARE(runSline({"pockets", m_file, "--focus", "7", "-o", scene}).code, 2);
  }

 private:
  QTemporaryDir m_folder;
  QString m_file;
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::PocketsCommandTest)
#include "pockets_command_test.moc"
