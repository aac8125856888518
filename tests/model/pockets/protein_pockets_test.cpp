// SPDX-License-Identifier: Apache-2.0
// Finds the known pocket of a real protein: that of c-Src kinase for ATP, with AMP-PNP in it (Xu,
// Doshi, Lei, Eck, Harrison, Mol. Cell 3, 1999).
#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <set>
#include <span>

#include "model/import/plan/import.h"
#include "model/pockets/scene_pockets.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

class ProteinPocketsTest : public QObject {
  Q_OBJECT
 private slots:
  void kinase() {
    const QString file = QStringLiteral(SLINE_TEST_DATA "/protein/2src.pdb");
    if (!QFile::exists(file))
      QSKIP("the data are not here");
    const std::filesystem::path path = file.toStdString();
    const Result<Imported> imported = importInputs(std::span(&path, 1), {});
    QVERIFY(imported.ok());
    const auto found = pocketsIn(imported->scene, {}, [] { return true; });
    QVERIFY(found.ok());
    QVERIFY(found->pockets.size() > 5);
    const auto holds = [&](const ScenePocket& pocket) {
      return std::any_of(pocket.guests.begin(), pocket.guests.end(), [&](NodeId id) {
        return imported->scene.find(id)->name.find("ANP") != std::string::npos;
      });
    };
    const auto atp = std::find_if(found->pockets.begin(), found->pockets.end(), holds);
    QVERIFY(atp != found->pockets.end());
    QVERIFY(atp->number <= 2);
    QCOMPARE(atp->guests.size(), std::size_t(1));
    QVERIFY(atp->pocket.volume > 800.0 && atp->pocket.volume < 2500.0);
    const std::vector<std::string> names = found->lining(*atp);
    const std::set<std::string> lining(names.begin(), names.end());
    // What touches the ligand: hinge, glycine-rich loop, catalytic lysine, DFG.
    for (const char* residue :
         {"LEU A 273", "VAL A 281", "ALA A 293", "LYS A 295", "THR A 338", "GLU A 339", "MET A 341",
          "SER A 345", "LEU A 393", "ALA A 403", "ASP A 404"})
      QVERIFY2(lining.contains(residue), residue);
    QVERIFY(!lining.contains("TRP A 118"));
  }

  /// The same entry, turned and moved, is laid over itself: its atoms come along, and each pocket
  /// has the number and, on another place of the lattice, nearly the volume of its twin.
  void turnedEntry() {
    const QString file = QStringLiteral(SLINE_TEST_DATA "/protein/2src.pdb");
    if (!QFile::exists(file))
      QSKIP("the data are not here");
    const QTemporaryDir folder;
    const std::array<std::filesystem::path, 2> paths{file.toStdString(),
                                                     folder.filePath("turned.pdb").toStdString()};
    writeTurned(file, folder.filePath("turned.pdb"));
    const Result<Imported> imported = importInputs(paths, {});
    QVERIFY(imported.ok());
    const auto found = pocketsIn(imported->scene, {}, [] { return true; });
    QVERIFY(found.ok());
    QCOMPARE(found->molecules.size(), std::size_t(2));
    for (int number = 1; number <= 4; ++number) {
      std::vector<const ScenePocket*> same;
      for (const ScenePocket& pocket : found->pockets)
        if (pocket.number == number)
          same.push_back(&pocket);
      QCOMPARE(same.size(), std::size_t(2));
      QVERIFY(glm::distance(same[0]->pocket.centre, same[1]->pocket.centre) < 2.0);
      QVERIFY2(std::abs(same[1]->pocket.volume / same[0]->pocket.volume - 1.0) < 0.15,
               qPrintable(QString("%1: %2 %3")
                              .arg(number)
                              .arg(same[0]->pocket.volume)
                              .arg(same[1]->pocket.volume)));
    }
  }

 private:
  /// Writes the entry after a quarter turn about z and a shift.
  static void writeTurned(const QString& from, const QString& to) {
    QFile in(from);
    QFile out(to);
    QVERIFY(in.open(QIODevice::ReadOnly) && out.open(QIODevice::WriteOnly));
    while (!in.atEnd()) {
      QByteArray line = in.readLine();
      if (line.startsWith("ATOM") || line.startsWith("HETATM")) {
        const double x = line.mid(30, 8).toDouble();
        const double y = line.mid(38, 8).toDouble();
        const double z = line.mid(46, 8).toDouble();
        line.replace(
            30, 24, QString::asprintf("%8.3f%8.3f%8.3f", 31.13 - y, x - 7.29, z + 5.41).toLatin1());
      }
      out.write(line);
    }
  }
};

SLINE_TEST(ProteinPocketsTest)
#include "protein_pockets_test.moc"
