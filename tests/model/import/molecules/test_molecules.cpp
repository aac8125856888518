// SPDX-License-Identifier: Apache-2.0
// Tests entries as they come into a scene: names, tree, colours, units, handedness, overlay.
#include <QFile>
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <set>

#include "model/import/molecules/molecule_surfaces.h"
#include "model/import/plan/import.h"
#include "tests/model/import/molecules/entry_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

std::filesystem::path written(const QTemporaryDir& folder, const char* name,
                              const QByteArray& bytes) {
  QFile file(folder.filePath(name));
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
    qFatal("cannot write %s", name);
  return file.fileName().toStdString();
}

Imported imported(const std::vector<std::filesystem::path>& files, ImportOptions options = {}) {
  Result<Imported> result = importInputs(files, options);
  if (!result.ok())
    qFatal("%s", result.error().text().c_str());
  return std::move(result.value());
}

const Node* nodeNamed(const Scene& scene, const std::string& name) {
  const std::vector<NodeId> found = scene.named(name);
  return found.size() == 1 ? scene.find(found.front()) : nullptr;
}

glm::dvec3 middleOf(const Node& node) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3& p : node.mesh->positions())
    sum += glm::dvec3(p);
  return sum / double(node.mesh->positions().size());
}

/// Returns an L-amino acid with an atom of another element at each corner of its Cα: seen from the
/// hydrogen these run clockwise in the order of COOH, R, NH2 ("CORN").
QByteArray handed() {
  const auto atom = [](const char* name, const char* element, glm::dvec3 place) {
    return Written{.name = name,
                   .residue = "LIG",
                   .place = place + glm::dvec3(12, -7, 30),
                   .element = element,
                   .hetero = true};
  };
  const std::vector<Written> atoms = {atom(" C  ", "C", {0, 0, 0}), atom(" H  ", "H", {0, 0, 1.09}),
                                      atom(" O  ", "O", {1.4, 0, -0.5}),
                                      atom(" S  ", "S", {-0.8, -1.5, -0.6}),
                                      atom(" N  ", "N", {-0.7, 1.2, -0.5})};
  return pdbFile(atoms);
}

/// Returns the sign of the corners' turn around the hydrogen's direction.
double handedness(const Scene& scene) {
  const glm::dvec3 o = middleOf(*nodeNamed(scene, "LIG oxygen"));
  const glm::dvec3 s = middleOf(*nodeNamed(scene, "LIG sulphur"));
  const glm::dvec3 n = middleOf(*nodeNamed(scene, "LIG nitrogen"));
  const glm::dvec3 h = middleOf(*nodeNamed(scene, "LIG hydrogen"));
  return glm::dot(h - o, glm::cross(s - o, n - o));
}

}  // namespace

class TestMolecules : public QObject {
  Q_OBJECT

 private slots:
  void treeAndNames() {
    const QTemporaryDir folder;
    std::vector<Written> atoms = helix("ACDEFGHIKL");
    for (int i = 0; i < 2; ++i)
      atoms.push_back({.name = i == 0 ? " C1 " : " O1 ",
                       .residue = "EOH",
                       .number = 50,
                       .place = {20.0 + 1.4 * i, 0, 0},
                       .element = i == 0 ? "C" : "O",
                       .hetero = true});
    const QByteArray head =
        "HEADER    LIPID BINDING                           01-JAN-00   1HFB\n"
        "TITLE     LEFT HEART AND LIVER\n"
        "COMPND    MOL_ID: 1;\nCOMPND   2 MOLECULE: HEART FATTY ACID-BINDING PROTEIN;\n"
        "COMPND   3 CHAIN: A;\nHETNAM     EOH ETHANOL\n";
    const Imported read = imported({written(folder, "1hfb.pdb", head + pdbFile(atoms))});
    const Scene& scene = read.scene;
    const Node* chain = nodeNamed(scene, "Chain A – Heart fatty acid-binding protein");
    QVERIFY(chain && !chain->isGroup());
    QCOMPARE(scene.groupPath(chain->id), std::string("1HFB – Left heart and liver"));
    QCOMPARE(*chain->style.colour, chainColour(0));  // not the heart's
    const Node* bonds = nodeNamed(scene, "EOH carbon and bonds");
    QVERIFY(bonds);
    QCOMPARE(scene.groupPath(bonds->id),
             std::string("1HFB – Left heart and liver / Ligands / Ethanol (EOH)"));
    const Node* surface = nodeNamed(scene, "EOH surface");
    QVERIFY(surface && !scene.resolve(surface->id).visible);
    QVERIFY(scene.resolve(bonds->id).visible);
    QCOMPARE(chain->provenance.frame, std::string("file"));
    QCOMPARE(chain->provenance.unitReason, std::string("1 Å is drawn as 1 mm"));
    QCOMPARE(chain->provenance.mmPerUnit, 1.0f);
    QCOMPARE(chain->provenance.smoothingSteps + chain->provenance.refinementSteps, 0);
    QVERIFY(read.report.warnings.empty());
  }

  /// A ligand beside a chain has a pocket, hidden at first; a molecule of two atoms has none.
  void pockets() {
    const QTemporaryDir folder;
    std::vector<Written> atoms = helix("ACDEFGHIKL");
    for (int i = 0; i < 9; ++i)
      atoms.push_back({.name = " C  ",
                       .residue = i < 7 ? "LIG" : "EOH",
                       .number = i < 7 ? 50 : 51,
                       .place = {i < 7 ? 7.0 : -9.0, 0.0, 1.4 * i},
                       .element = "C",
                       .hetero = true});
    const Imported read = imported({written(folder, "ten.pdb", pdbFile(atoms))});
    const Node* pocket = nodeNamed(read.scene, "LIG pocket");
    QVERIFY(pocket && !read.scene.resolve(pocket->id).visible);
    QVERIFY(read.scene.groupPath(pocket->id).ends_with("Pockets"));
    const Node* chain = nodeNamed(read.scene, "Chain A");
    QVERIFY(chain && pocket->mesh->triangleCount() < chain->mesh->triangleCount());
    QVERIFY(!nodeNamed(read.scene, "EOH pocket"));
  }

  void unitsStay() {
    // In other files anatomical names and a size below three units would mean metres.
    const QTemporaryDir folder;
    const Imported read =
        imported({written(folder, "liver.pdb", pdbFile(std::vector<Written>{{}}))});
    const Box box = read.scene.visibleBounds();
    QVERIFY(std::abs(box.size().x - 3.4f) < 0.1f);
  }

  void handednessStays_data() {
    QTest::addColumn<int>("frame");
    QTest::newRow("as it is") << -1;
    QTest::newRow("LPS") << int(Frame::lps);
    QTest::newRow("RAS") << int(Frame::ras);
  }
  void handednessStays() {
    QFETCH(int, frame);
    const QTemporaryDir folder;
    ImportOptions options;
    if (frame >= 0)
      options.frame = Frame(frame);
    const Imported read = imported({written(folder, "handed.pdb", handed())}, options);
    const glm::dvec3 o(1.4, 0, -0.5);
    const double before =
        glm::dot(glm::dvec3(0, 0, 1.09) - o,
                 glm::cross(glm::dvec3(-0.8, -1.5, -0.6) - o, glm::dvec3(-0.7, 1.2, -0.5) - o));
    QVERIFY(std::abs(handedness(read.scene) - before) < 0.01);
  }

  void coloursDiffer() {
    std::set<Colour> colours;
    for (std::size_t i = 0; i < 27; ++i)
      colours.insert(chainColour(i));
    QCOMPARE(colours.size(), std::size_t(27));
  }

  void overlaid_data() {
    QTest::addColumn<bool>("off");
    QTest::newRow("auto") << false;
    QTest::newRow("off") << true;
  }
  void overlaid() {
    QFETCH(bool, off);
    const QTemporaryDir folder;
    std::vector<Written> atoms = helix("ACDEFGHIKLMNPQRSTVWY");
    atoms.push_back({.name = "MG  ",
                     .residue = "MG",
                     .number = 90,
                     .place = {9, 4, 2},
                     .element = "MG",
                     .hetero = true});
    const QByteArray first = pdbFile(atoms);
    atoms.back().place += glm::dvec3(0.5, 0, 0);
    const glm::dmat3 turn = glm::mat3_cast(glm::normalize(glm::dquat(0.3, -0.8, 0.4, 0.2)));
    for (Written& atom : atoms)
      atom.place = turn * atom.place + glm::dvec3(40, -3, 11);
    ImportOptions options;
    options.overlay = off ? Overlay::off : Overlay::automatic;
    const Imported read = imported(
        {written(folder, "a.pdb", first), written(folder, "b.pdb", pdbFile(atoms))}, options);
    QCOMPARE(read.report.notes.size(), std::size_t(off ? 0 : 1));
    const Node* one = nodeNamed(read.scene, "magnesium (MG)");
    const Node* two = nodeNamed(read.scene, "magnesium (MG) 2");
    QVERIFY(one && two);
    const glm::dvec3 apart = middleOf(*two) - middleOf(*one);
    if (off)
      QVERIFY(glm::length(apart) > 10.0);
    else
      QVERIFY(glm::length(apart - glm::dvec3(0.5, 0, 0)) < 0.01);
    const Node* second = nodeNamed(read.scene, "Chain A 2");
    QVERIFY(second && second->style.colour == chainColour(1));
    QCOMPARE(second->provenance.frameReason.starts_with("chain A laid over chain A of a"), !off);
  }

  void strangersAreTold() {
    const QTemporaryDir folder;
    const Imported read = imported({written(folder, "a.pdb", pdbFile(helix("ACDEFGHIKLMNPQ"))),
                                    written(folder, "b.pdb", pdbFile(helix("WWWWYYYYWWWWYY")))});
    QCOMPARE(read.report.notes.size(), std::size_t(1));
    QVERIFY(read.report.notes.front().find("no chains match") != std::string::npos);
  }

  void crambinTwice() {
    const QByteArray pdb = bytesOf(SLINE_TEST_DATA "/protein/1crn.pdb");
    const QByteArray cif = bytesOf(SLINE_TEST_DATA "/protein/1CRN.cif");
    if (pdb.isEmpty() || cif.isEmpty())
      SLINE_ABSENT("no protein data");
    const QTemporaryDir folder;
    const auto a = recordsOf(folder, ".pdb", pdb);
    const auto b = recordsOf(folder, ".cif", cif);
    QVERIFY(a.ok() && b.ok());
    QCOMPARE(a->atoms.size(), std::size_t(327));
    QCOMPARE(b->atoms.size(), std::size_t(327));
    for (std::size_t i = 0; i < 327; ++i) {
      const AtomRecord& p = a->atoms[i];
      const AtomRecord& q = b->atoms[i];
      QVERIFY(p.place == q.place && p.name == q.name && p.residue == q.residue &&
              p.chain == q.chain && p.number == q.number && p.element == q.element);
    }
    const Imported read =
        imported({written(folder, "1crn.pdb", pdb), written(folder, "1CRN.cif", cif)});
    const Node* first = nodeNamed(read.scene, "Chain A – Crambin");
    const Node* second = nodeNamed(read.scene, "Chain A – Crambin 2");
    QVERIFY(first && second);
    QCOMPARE(first->mesh->triangleCount(), second->mesh->triangleCount());
    for (std::size_t i = 0; i < first->mesh->vertexCount(); ++i)
      QVERIFY(glm::length(first->mesh->positions()[i] - second->mesh->positions()[i]) < 1e-4f);
    QVERIFY(read.report.notes.front().ends_with(
        "46 of 46 pairs of residues, 100 % identical, RMSD 0.000 Å"));
  }

  void srcOverItself() {
    const QByteArray src = bytesOf(SLINE_TEST_DATA "/protein/2src.pdb");
    if (src.isEmpty())
      SLINE_ABSENT("no protein data");
    const glm::dmat3 turn = glm::mat3_cast(glm::normalize(glm::dquat(0.9, 0.1, -0.3, 0.3)));
    QByteArray moved;
    for (QByteArray line : src.split('\n')) {
      if (line.startsWith("ATOM") || line.startsWith("HETATM")) {
        glm::dvec3 p(line.mid(30, 8).toDouble(), line.mid(38, 8).toDouble(),
                     line.mid(46, 8).toDouble());
        if (line.mid(17, 3) == "ANP")
          p += glm::dvec3(0, 0, 1);
        p = turn * p + glm::dvec3(-20, 35, 60);
        char place[32];
        std::snprintf(place, sizeof place, "%8.3f%8.3f%8.3f", p.x, p.y, p.z);
        line.replace(30, 24, place);
      }
      moved += line + '\n';
    }
    const QTemporaryDir folder;
    const Imported read =
        imported({written(folder, "a.pdb", src), written(folder, "b.pdb", moved)});
    for (const char* element : {"phosphorus", "oxygen", "nitrogen"}) {
      const Node* one = nodeNamed(read.scene, std::string("ANP ") + element);
      const Node* two = nodeNamed(read.scene, std::string("ANP ") + element + " 2");
      QVERIFY(one && two);
      QVERIFY(glm::length(middleOf(*two) - middleOf(*one) - glm::dvec3(0, 0, 1)) < 0.01);
    }
    QVERIFY(QString::fromStdString(read.report.notes.front()).contains("450 of 450 pairs"));
    // The phosphotyrosine is part of its chain.
    const Node* chain = nodeNamed(read.scene, "Chain A – Tyrosine-protein kinase SRC");
    QVERIFY(chain);
    const glm::vec3 phosphorus(24.278f, 46.108f, 82.041f);
    float nearest = 100.0f;
    for (const glm::vec3& p : chain->mesh->positions())
      nearest = std::min(nearest, glm::length(p - phosphorus));
    QVERIFY(nearest < 3.0f);
  }
};

SLINE_TEST_WITH_EVENTS(TestMolecules)
#include "test_molecules.moc"
