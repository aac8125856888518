// SPDX-License-Identifier: Apache-2.0
// Tests the way from records to chains, ligands, ions and waters.
#include <QTest>

#include "model/import/molecules/residues.h"
#include "tests/model/import/molecules/entry_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

std::optional<Molecule> read(const QByteArray& bytes, const char* extension = ".pdb") {
  const QTemporaryDir folder;
  Result<EntryRecords> records = recordsOf(folder, extension, bytes);
  if (!records.ok())
    return std::nullopt;
  return moleculeOf(std::move(records.value()));
}

Written hetero(const char* name, const char* residue, const char* element, double x, int number) {
  return {.name = name,
          .residue = residue,
          .number = number,
          .place = {x, 0, 0},
          .element = element,
          .hetero = true};
}

}  // namespace

class TestResidues : public QObject {
  Q_OBJECT

 private slots:
  void chains() {
    std::vector<Written> atoms = helix("ACDEF", "A");
    const std::vector<Written> second = helix("GHIKL", "B");
    for (Written atom : second) {
      atom.place.x += 30.0;
      atoms.push_back(atom);
    }
    for (const bool cif : {false, true}) {
      const auto molecule = read(cif ? cifFile(atoms) : pdbFile(atoms), cif ? ".cif" : ".pdb");
      QVERIFY(molecule && molecule->chains.size() == 2 && molecule->ligands.empty());
      QCOMPARE(molecule->chains[0].id, std::string("A"));
      QCOMPARE(molecule->chains[1].residues.size(), std::size_t(5));
      std::string letters;
      for (const Residue& residue : molecule->chains[1].residues)
        letters += residue.letter;
      QCOMPARE(letters, std::string("GHIKL"));
    }
  }

  void modifiedResidueBelongsToItsChain() {
    std::vector<Written> atoms = helix("AYA");
    for (Written& atom : atoms)
      if (atom.number == 2) {
        atom.residue = "XYZ";
        atom.hetero = true;
      }
    const auto bonded = read(pdbFile(atoms));
    QVERIFY(bonded && bonded->chains.front().residues.size() == 3 && bonded->ligands.empty());
    QCOMPARE(bonded->chains.front().residues[1].letter, 'X');
    const auto told = read("MODRES 2SRC XYZ A  527  TYR  A TYROSINE\n" + pdbFile(atoms));
    QCOMPARE(told->chains.front().residues[1].letter, 'Y');
    // The same residue on its own, away from any chain, is a ligand.
    for (Written& atom : atoms)
      if (atom.number == 2)
        atom.place.y += 20.0;
    const auto apart = read(pdbFile(atoms));
    QCOMPARE(apart->chains.front().residues.size(), std::size_t(2));
    QCOMPARE(apart->ligands.size(), std::size_t(1));
  }

  void letters_data() {
    QTest::addColumn<QString>("residue");
    QTest::addColumn<char>("letter");
    QTest::newRow("amino acid") << "TRP" << 'W';
    QTest::newRow("selenomethionine") << "MSE" << 'M';
    QTest::newRow("phosphotyrosine") << "PTR" << 'Y';
    QTest::newRow("selenocysteine") << "SEC" << 'C';
    QTest::newRow("histidine of a force field") << "HSD" << 'H';
    QTest::newRow("histidine with its proton at ε") << "HSE" << 'H';
    QTest::newRow("histidine with both protons") << "HSP" << 'H';
    QTest::newRow("guanine of a force field") << "GUA" << 'G';
    QTest::newRow("adenine of a force field") << "ADE" << 'A';
    QTest::newRow("cytosine of a force field") << "CYT" << 'C';
    QTest::newRow("thymine of a force field") << "THY" << 'T';
    QTest::newRow("uracil of a force field") << "URA" << 'U';
    QTest::newRow("of DNA") << "DA" << 'A';
    QTest::newRow("of RNA") << "U" << 'U';
    QTest::newRow("pseudouridine") << "PSU" << 'U';
    QTest::newRow("one of two") << "ASX" << 'X';
    QTest::newRow("unknown") << "UNK" << 'X';
    QTest::newRow("GDP, which is none") << "GDP" << 'X';
    QTest::newRow("water") << "HOH" << 'X';
    QTest::newRow("nothing") << "" << 'X';
  }
  void letters() {
    QFETCH(QString, residue);
    QTEST(letterOf(residue.toStdString()), "letter");
  }

  void watersOfSimulations() {
    for (const char* name : {"HOH", "WAT", "DOD", "TIP3", "SOL"}) {
      std::vector<Written> atoms = helix("AA");
      atoms.push_back(hetero(" O  ", name, "O", 30, 9));
      const auto molecule = read(cifFile(atoms), ".cif");
      QVERIFY2(molecule && molecule->waters == 1 && molecule->ligands.empty(), name);
    }
  }

  /// CHARMM writes ions as atoms of three letters, from the first column on, without an element.
  void ionsOfSimulations() {
    std::vector<Written> atoms = helix("AAAA");
    double x = 30.0;
    for (const char* name : {"SOD", "POT", "CLA", "CAL"})
      atoms.push_back({.name = name, .residue = name, .number = int(x), .place = {x += 8.0, 0, 0}});
    QByteArray file;
    for (const Written& atom : atoms)
      file += pdbLine(atom).left(66) + "\n";
    const auto molecule = read(file);
    QVERIFY(molecule);
    QCOMPARE(molecule->chains.size(), std::size_t(1));
    QStringList found;
    for (const Ligand& ligand : molecule->ligands)
      found << QString::fromStdString(ligand.name + " " +
                                      std::string(ligand.atoms.front().element->name) +
                                      (ligand.ion ? " ion" : ""));
    QCOMPARE(found.join(", "),
             QString("SOD sodium ion, POT potassium ion, CLA chlorine ion, CAL calcium ion"));
  }

  void kinds() {
    std::vector<Written> atoms = helix("AAAA");
    atoms.push_back(hetero(" O  ", "HOH", "O", 20, 90));
    atoms.push_back(hetero(" O  ", "HOH", "O", 23, 91));
    atoms.push_back(hetero("MG  ", "MG", "MG", 26, 92));
    atoms.push_back(hetero(" S  ", "SO4", "S", 40, 93));
    atoms.push_back(hetero(" O1 ", "SO4", "O", 41.45, 93));
    atoms.push_back(hetero(" C1 ", "NAG", "C", 50, 94));
    atoms.push_back(hetero(" O4 ", "NAG", "O", 51.43, 94));
    atoms.push_back(hetero(" C1 ", "BMA", "C", 52.86, 95));
    atoms.push_back(hetero(" C2 ", "BMA", "C", 54.38, 95));
    const auto molecule = read("HETNAM      MG MAGNESIUM ION\n" + pdbFile(atoms));
    QVERIFY(molecule);
    QCOMPARE(molecule->waters, std::size_t(2));
    QCOMPARE(molecule->chains.size(), std::size_t(1));
    QStringList names;
    for (const Ligand& ligand : molecule->ligands)
      names << QString::fromStdString(ligand.name);
    QCOMPARE(names.join(", "), QString("Magnesium ion (MG), Sulphate (SO4), NAG-BMA"));
    QVERIFY(molecule->ligands[0].ion && !molecule->ligands[1].ion);
  }

  void alternates() {
    std::vector<Written> atoms = helix("AA");
    const std::size_t plain = atoms.size();
    Written one = atoms[4];
    Written two = one;
    one.alternate = 'A';
    one.occupancy = 0.3;
    two.alternate = 'B';
    two.occupancy = 0.7;
    two.place.x += 1.0;
    atoms[4] = one;
    atoms.insert(atoms.begin() + 5, two);
    const auto molecule = read(pdbFile(atoms));
    QVERIFY(molecule);
    const Residue& residue = molecule->chains.front().residues.front();
    QCOMPARE(residue.atoms.size() + molecule->chains.front().residues[1].atoms.size(), plain);
    QVERIFY(std::abs(residue.atoms[4].place.x - two.place.x) < 1e-3);
    QCOMPARE(molecule->alternates, std::size_t(1));
  }

  void insertionCodes() {
    std::vector<Written> atoms = helix("AAA");
    for (Written& atom : atoms) {
      atom.insertion = atom.number == 1 ? ' ' : atom.number == 2 ? 'A' : 'B';
      atom.number = 52;
    }
    const auto molecule = read(pdbFile(atoms));
    QVERIFY(molecule && molecule->chains.front().residues.size() == 3);
    QCOMPARE(molecule->chains.front().residues[2].label, std::string("52B"));
  }

  void chainsWithoutNames() {
    std::vector<Written> atoms = helix("AAA", " ");
    const QByteArray one = pdbFile(atoms).replace("END\n", "TER\n");
    const auto molecule = read(one + one);
    QVERIFY(molecule && molecule->chains.size() == 2);
    QCOMPARE(molecule->chains[1].id, std::string("2"));
  }

  void namesOfChains() {
    const auto molecule = read(
        "HEADER    KINASE                                  29-DEC-98   2SRC\n"
        "COMPND    MOL_ID: 1;\nCOMPND   2 MOLECULE: TYROSINE-PROTEIN\n"
        "COMPND   3  KINASE SRC;\nCOMPND   4 CHAIN: A, B;\n" +
        pdbFile(helix("AAA", "B")));
    QCOMPARE(molecule->id, std::string("2SRC"));
    QCOMPARE(molecule->chains.front().name, std::string("Tyrosine-protein kinase SRC"));
  }

  void entitiesOfMmcif() {
    const QByteArray file =
        "data_x\nloop_\n_entity.id\n_entity.type\n_entity.pdbx_description\n"
        "1 polymer 'Proto-oncogene Src'\n2 non-polymer ?\n3 water water\n"
        "loop_\n_chem_comp.id\n_chem_comp.name\nXYZ '3-nonsense'\n"
        "loop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
        "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.auth_asym_id\n"
        "_atom_site.label_entity_id\n_atom_site.label_seq_id\n_atom_site.auth_seq_id\n"
        "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
        "ATOM C CA ABC A Q 1 1 301 0 0 0\nATOM C CA ALA A Q 1 2 302 3.8 0 0\n"
        "HETATM C C1 XYZ B Q 2 . 400 9 0 0\nHETATM C C2 XYZ B Q 2 . 400 10.5 0 0\n"
        "HETATM O O HOH C Q 3 . 500 20 0 0\n";
    const auto molecule = read(file, ".cif");
    QVERIFY(molecule && molecule->chains.size() == 1 && molecule->ligands.size() == 1);
    QCOMPARE(molecule->chains.front().id, std::string("Q"));
    QCOMPARE(molecule->chains.front().name, std::string("Proto-oncogene Src"));
    QCOMPARE(molecule->chains.front().residues[1].label, std::string("302"));
    QCOMPARE(molecule->ligands.front().name, std::string("3-nonsense (XYZ)"));
    QCOMPARE(molecule->waters, std::size_t(1));
  }

  void bonds_data() {
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::addColumn<double>("apart");
    QTest::addColumn<bool>("bonded");
    QTest::newRow("C–C") << "C"
                         << "C" << 1.54 << true;
    QTest::newRow("C–C, too far") << "C"
                                  << "C" << 2.5 << false;
    QTest::newRow("P–O") << "P"
                         << "O" << 1.6 << true;
    QTest::newRow("H–H of a methyl") << "H"
                                     << "H" << 1.7 << false;
    QTest::newRow("Fe–N") << "Fe"
                          << "N" << 2.05 << true;
    QTest::newRow("in one place") << "C"
                                  << "C" << 0.1 << false;
  }
  void bonds() {
    QFETCH(QString, first);
    QFETCH(QString, second);
    QFETCH(double, apart);
    const std::vector<Atom> atoms = {
        {"A", elementOf(first.toStdString()), {5.4, 0, 0}, 1},
        {"B", elementOf(second.toStdString()), {5.4 + apart, 0, 0}, 2}};
    QTEST(bondsBetween(atoms, {}).size() == 1, "bonded");
  }
  void listedBonds() {
    const std::vector<Atom> atoms = {{"A", elementOf("C"), {0, 0, 0}, 7},
                                     {"B", elementOf("C"), {2.3, 0, 0}, 9},
                                     {"C", elementOf("C"), {9, 0, 0}, 9}};
    QCOMPARE(bondsBetween(std::span(atoms).first(2), {{7, 9}}).size(), std::size_t(1));
    QVERIFY(bondsBetween(atoms, {{7, 9}}).empty());  // serial 9 belongs to two atoms
  }
};

SLINE_TEST_WITH_EVENTS(TestResidues)
#include "test_residues.moc"
