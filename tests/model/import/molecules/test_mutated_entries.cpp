// SPDX-License-Identifier: Apache-2.0
// Tests entries spoiled at random, with a fixed seed, and entries meant to do harm: an answer
// comes, and it is a sound surface or an error.
#include <zlib.h>
#include <QFile>
#include <QTest>
#include <random>

#include "model/import/molecules/residues.h"
#include "tests/model/import/molecules/entry_files.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/support/mutator.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

void overwrite(Mutator& random, QByteArray& bytes, qsizetype at) {
  static const char* const pieces[] = {"nan",          "1e39", "-1e9",  "\n",      "'", "\"",
                                       ";\n",          "_a.b", "HOH",   "loop_\n", "?", "\r\n",
                                       "999999999999", "\xff", "TER\n", "MODEL\n"};
  const QByteArray piece = pieces[random.below(std::size(pieces))];
  bytes.replace(at, piece.size(), piece);
}

/// Returns the bytes as gzip packs them.
QByteArray packed(const QByteArray& bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    qFatal("zlib");
  QByteArray result(qsizetype(deflateBound(&stream, uLong(bytes.size()))), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = uInt(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = uInt(result.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END)
    qFatal("zlib");
  result.truncate(qsizetype(stream.total_out));
  deflateEnd(&stream);
  return result;
}

std::vector<Written> scattered(int count, double size) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-size, size);
  std::vector<Written> atoms;
  for (int i = 0; i < count; ++i)
    atoms.push_back({.number = i % 9999,
                     .place = {coordinate(random), coordinate(random), coordinate(random)}});
  return atoms;
}

}  // namespace

class TestMutatedEntries : public QObject {
  Q_OBJECT

 private slots:
  void mutations_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    std::vector<Written> atoms = helix("AY");
    atoms.push_back(
        {.name = "MG  ", .residue = "MG", .place = {9, 4, 2}, .element = "MG", .hetero = true});
    QTest::newRow("pdb") << ".pdb"
                         << "HEADER\n" + pdbFile(atoms) + "CONECT    1    2    3\n";
    QTest::newRow("cif") << ".cif" << cifFile(atoms);
    QTest::newRow("json") << ".json" << jsonFile(atoms);
    QTest::newRow("packed") << ".pdb.gz" << packed(pdbFile(atoms));
    QTest::newRow("packed mmCIF") << ".cif.gz" << packed(cifFile(atoms));
  }
  void mutations() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    const QTemporaryDir folder;
    Mutator mutate(20240611, {overwrite, overwrite});
    int refused = 0;
    for (int i = 0; i < 200; ++i) {
      const Result<RawMeshes> read = readBytes(folder, "spoiled" + extension, mutate(bytes));
      if (read)
        QVERIFY2(isSound(*read), qPrintable(QString("mutation %1").arg(i)));
      else
        QVERIFY(!read.error().reason.empty() && !read.error().remedy.empty() && ++refused > 0);
    }
    // A checksum shows that a packed file is spoiled.
    QVERIFY2(refused > 5 && (refused < 200 || extension.endsWith(".gz")),
             qPrintable(QString::number(refused)));
  }

  void assembliesSpoiled_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    const QByteArray lines =
        "REMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
        "REMARK 350   BIOMT1   1 -1.000000  0.000000  0.000000       30.00000\n"
        "REMARK 350   BIOMT2   1  0.000000 -1.000000  0.000000        0.00000\n"
        "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n";
    QTest::newRow("pdb") << ".pdb" << lines + pdbFile(helix("AY"));
    QTest::newRow("cif") << ".cif"
                         << cifFile(helix("AY")) +
                                "_pdbx_struct_assembly_gen.assembly_id 1\n"
                                "_pdbx_struct_assembly_gen.oper_expression (1-2)(X)\n"
                                "_pdbx_struct_assembly_gen.asym_id_list A\n"
                                "loop_\n_pdbx_struct_oper_list.id\n"
                                "_pdbx_struct_oper_list.vector[1]\n1 0\n2 30\nX 0\n";
  }
  void assembliesSpoiled() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    const QTemporaryDir folder;
    const QString path = folder.filePath("spoiled" + extension);
    Mutator mutate(350, {overwrite, overwrite});
    int refused = 0;
    for (int i = 0; i < 200; ++i) {
      // Most of the bytes are atoms, so every other time only the lines about the assembly are
      // spoiled.
      const QByteArray spoiled = i % 2 == 0 ? mutate(bytes)
                                 : extension == ".pdb"
                                     ? mutate(bytes.left(400)) + bytes.mid(400)
                                     : bytes.chopped(250) + mutate(bytes.right(250));
      QFile::remove(path);
      QFile file(path);
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(spoiled);
      file.close();
      const Result<RawMeshes> read = readSurfaces(path.toStdString(), {.assembly = "1"});
      if (read)
        QVERIFY2(isSound(*read), qPrintable(QString("copy %1").arg(i)));
      else
        QVERIFY(!read.error().reason.empty() && !read.error().remedy.empty() && ++refused > 0);
    }
    QVERIFY2(refused > 20 && refused < 200, qPrintable(QString::number(refused)));
  }

  void bombs() {
    // Zeros pack a thousandfold: only as much is unpacked as a file of that size may hold.
    const QTemporaryDir folder;
    const QByteArray bomb = packed(QByteArray(qsizetype(200) << 20, ' '));
    const Result<RawMeshes> read = readBytes(folder, "bomb.pdb.gz", bomb);
    QVERIFY(!read.ok());
    QVERIFY2(read.error().reason.find("unpacks to more than") != std::string::npos,
             read.error().reason.c_str());
  }

  void packedEntries_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    const std::vector<Written> atoms = helix("ACDEFGHIKL");
    QTest::newRow("pdb") << "1abc.pdb.gz" << pdbFile(atoms);
    QTest::newRow("ent, as the archive has it") << "pdb1abc.ent.gz" << pdbFile(atoms);
    QTest::newRow("cif") << "1abc.CIF.GZ" << cifFile(atoms);
    QTest::newRow("mmcif") << "1abc.mmcif.gz" << cifFile(atoms);
    QTest::newRow("json") << "1abc.json.gz" << jsonFile(atoms);
  }
  void packedEntries() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    const QTemporaryDir folder;
    const Result<RawMeshes> stored = readBytes(folder, name.chopped(3), bytes);
    const Result<RawMeshes> read = readBytes(folder, name, packed(bytes));
    QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
    QVERIFY(stored.ok() && stored->meshes.size() == 1 && read->meshes.size() == 1);
    QVERIFY(stored->meshes.front().positions == read->meshes.front().positions);
    QCOMPARE(read->meshes.front().groups, stored->meshes.front().groups);
    // A packed file cut in the middle is refused rather than read in part.
    QVERIFY(!readBytes(folder, name, packed(bytes).chopped(40)).ok());
  }

  void wholeEntriesSpoiled_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QString>("file");
    QTest::newRow("pdb") << ".pdb" << SLINE_TEST_DATA "/protein/1crn.pdb";
    QTest::newRow("cif") << ".cif" << SLINE_TEST_DATA "/protein/1CRN.cif";
  }
  void wholeEntriesSpoiled() {
    QFETCH(QString, extension);
    QFETCH(QString, file);
    const QByteArray bytes = bytesOf(qPrintable(file));
    if (bytes.isEmpty())
      SLINE_ABSENT("no protein data");
    const QTemporaryDir folder;
    Mutator mutate(7, {overwrite, overwrite});
    for (int i = 0; i < 200; ++i) {
      Result<EntryRecords> read = recordsOf(folder, qPrintable(extension), mutate(bytes));
      if (!read)
        continue;
      const std::size_t atoms = read->atoms.size();
      const Molecule molecule = moleculeOf(std::move(read.value()));
      std::size_t sorted = molecule.waters > 0 ? 1 : 0;
      for (const Chain& chain : molecule.chains)
        for (const Residue& residue : chain.residues)
          sorted += residue.atoms.size();
      for (const Ligand& ligand : molecule.ligands)
        sorted += ligand.atoms.size();
      QVERIFY(sorted > 0 && sorted <= atoms + 1);
    }
  }

  void hostile_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("mostTriangles");
    QTest::newRow("two atoms ten thousand ångström apart")
        << pdbFile(std::vector<Written>{{}, {.number = 2, .place = {9999, 0, 0}}}) << 2000;
    QTest::newRow("scattered atoms") << pdbFile(scattered(1500, 990.0)) << 800'000;
    QTest::newRow("a heap") << pdbFile(scattered(1500, 2.0)) << 0;
  }
  void hostile() {
    QFETCH(QByteArray, bytes);
    QFETCH(int, mostTriangles);
    const QTemporaryDir folder;
    const Result<RawMeshes> read = readBytes(folder, "hostile.pdb", bytes);
    QCOMPARE(read.ok(), mostTriangles > 0);
    if (!read)
      return;
    QVERIFY(isSound(*read));
    QVERIFY2(int(triangleCount(*read)) <= mostTriangles,
             qPrintable(QString::number(triangleCount(*read))));
  }

  void farAway() {
    // A million ångström are beyond what a scene resolves; the rest is drawn.
    const QByteArray file = cifFile(helix("AAAA")) + "ATOM 99 C CA . ALA A 9 ? 1000000 0 0 1\n";
    const QTemporaryDir folder;
    const Result<RawMeshes> read = readBytes(folder, "far.cif", file);
    QVERIFY(read.ok());
    QVERIFY(warningText(*read).contains("1 atom more than 50,000 Å"));
    QVERIFY(triangleCount(*read) < 20'000);
  }

  void manyLigands() {
    // Each atom is a residue of its own name, but groups and structures stay few.
    QByteArray file =
        "data_x\nloop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n"
        "_atom_site.label_comp_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
        "_atom_site.Cartn_z\n";
    for (int i = 0; i < 400; ++i)
      file += QString("HETATM C L%1 %2 0 0\n").arg(i / 2 * 2).arg(3.0 * i - (i % 2) * 1.5).toUtf8();
    for (int i = 0; i < 400; ++i)
      file += QString("HETATM MG I%1 %2 50 0\n").arg(i).arg(5.0 * i).toUtf8();
    const QTemporaryDir folder;
    const Result<RawMeshes> read = readBytes(folder, "many.cif", file);
    QVERIFY(read.ok() && isSound(*read));
    QVERIFY2(read->meshes.size() < 200, qPrintable(QString::number(read->meshes.size())));
  }
};

SLINE_TEST_WITH_EVENTS(TestMutatedEntries)
#include "test_mutated_entries.moc"
