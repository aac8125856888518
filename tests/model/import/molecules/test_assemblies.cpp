// SPDX-License-Identifier: Apache-2.0
// Tests biological assemblies: which copies are made of which chains, their names, and what is
// refused.
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/import/molecules/assemblies.h"
#include "model/import/plan/import.h"
#include "tests/model/import/molecules/entry_files.h"
#include "tests/model/import/readers/mesh_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

/// Returns an assembly with five operators: 1 leaves all in place, 2 turns by half around z and
/// moves along x, 3 moves along y, 4 mirrors, 5 doubles; the assembly's parts are A (and W, which
/// has no atoms).
QByteArray assembly(const char* expression, const char* parts = "A,W") {
  QByteArray text =
      "_pdbx_struct_assembly.id 7\n_pdbx_struct_assembly.oligomeric_details dimeric\n"
      "_pdbx_struct_assembly_gen.assembly_id 7\n_pdbx_struct_assembly_gen.oper_expression '";
  text += QByteArray(expression) + "'\n_pdbx_struct_assembly_gen.asym_id_list " + parts;
  text += "\nloop_\n_pdbx_struct_oper_list.id\n";
  for (const char* item :
       {"matrix[1][1]", "matrix[1][2]", "matrix[1][3]", "vector[1]", "matrix[2][1]", "matrix[2][2]",
        "matrix[2][3]", "vector[2]", "matrix[3][1]", "matrix[3][2]", "matrix[3][3]", "vector[3]"})
    text += QByteArray("_pdbx_struct_oper_list.") + item + "\n";
  return text +
         "1 1 0 0 0 0 1 0 0 0 0 1 0\n2 -1 0 0 30 0 -1 0 0 0 0 1 0\n3 1 0 0 0 0 1 0 10 0 0 1 0\n"
         "4 -1 0 0 0 0 1 0 0 0 0 1 0\n5 2 0 0 0 0 2 0 0 0 0 2 0\nP 1 0 0 5 0 1 0 0 0 0 1 0\n";
}

/// Returns an atom of chain A at (1, 2, 3) and one of B at the origin.
QByteArray twoAtoms() {
  return cifFile(std::vector<Written>{{.place = {1, 2, 3}}, {.chain = "B"}});
}

/// Returns the entry with its assembly "7" made.
Result<EntryRecords> assembled(const QByteArray& bytes, const char* extension = ".cif",
                               const std::string& id = "7") {
  const QTemporaryDir folder;
  Result<EntryRecords> records = recordsOf(folder, extension, bytes);
  if (!records)
    return records;
  const Result<Source> source =
      Source::read(folder.filePath(QString("entry") + extension).toStdString(), {});
  if (const Status status = assemble(*source, *records, id); !status)
    return status.error();
  return records;
}

QString placesOf(const EntryRecords& entry) {
  QStringList places;
  for (const AtomRecord& atom : entry.atoms)
    places << QString("%1 %2 %3 %4")
                  .arg(QString::fromStdString(atom.chain))
                  .arg(atom.place.x)
                  .arg(atom.place.y)
                  .arg(atom.place.z);
  return places.join(", ");
}

std::vector<Written> dimerHalf() {
  std::vector<Written> atoms = helix("ACDEFGHIKL");
  atoms.push_back({.name = "MG  ",
                   .residue = "MG",
                   .number = 90,
                   .place = {9, 4, 2},
                   .element = "MG",
                   .hetero = true});
  return atoms;
}

const char* const remarks =
    "REMARK 350 BIOMOLECULE: 1\n"
    "REMARK 350 AUTHOR DETERMINED BIOLOGICAL UNIT: DIMERIC\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n"
    "REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350   BIOMT1   2 -1.000000  0.000000  0.000000       30.00000\n"
    "REMARK 350   BIOMT2   2  0.000000 -1.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000        0.00000\n"
    "REMARK 350 BIOMOLECULE: 2\n"
    "REMARK 350 APPLY THE FOLLOWING TO CHAINS: B\n"
    "REMARK 350   BIOMT1   1  0.000000 -1.000000  0.000000        1.50000\n"
    "REMARK 350   BIOMT2   1  1.000000  0.000000  0.000000        0.00000\n"
    "REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000\n";

}  // namespace

class TestAssemblies : public QObject {
  Q_OBJECT

 private slots:
  void copies_data() {
    QTest::addColumn<QByteArray>("expression");
    QTest::addColumn<QString>("places");
    QTest::newRow("one") << QByteArray("1") << "A 1 2 3";
    QTest::newRow("turned") << QByteArray("2") << "A 29 -2 3";
    QTest::newRow("two") << QByteArray("1,2") << "A 1 2 3, A-2 29 -2 3";
    QTest::newRow("brackets and blanks") << QByteArray("( 1, 2 )") << "A 1 2 3, A-2 29 -2 3";
    QTest::newRow("a range") << QByteArray("(1-3)") << "A 1 2 3, A-2 29 -2 3, A-3 1 12 3";
    QTest::newRow("a range without brackets") << QByteArray("2-3") << "A 29 -2 3, A-2 1 12 3";
    QTest::newRow("a product, the right one first")
        << QByteArray("(2)(P,3)") << "A 24 -2 3, A-2 29 -12 3";
    QTest::newRow("first without brackets") << QByteArray("P(1-2)") << "A 6 2 3, A-2 34 -2 3";
  }
  void copies() {
    QFETCH(QByteArray, expression);
    const auto entry = assembled(twoAtoms() + assembly(expression.constData()));
    QVERIFY2(entry.ok(), entry.ok() ? "" : entry.error().text().c_str());
    QTEST(placesOf(*entry), "places");
  }

  void refuses_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("said");
    const auto with = [](const char* expression, const char* parts = "A") {
      return twoAtoms() + assembly(expression, parts);
    };
    QTest::newRow("none") << twoAtoms() << "describes no assembly";
    QTest::newRow("another") << with("1,2").replace("_id 7", "_id 8").replace(".id 7", ".id 8")
                             << "no assembly '7'; it describes assembly 8 (2 copies, dimeric)";
    QTest::newRow("an operator is missing") << with("1,9") << "operator '9'";
    QTest::newRow("mirrored") << with("4") << "no rotation";
    QTest::newRow("twice as large") << with("5") << "no rotation";
    QTest::newRow("not a number") << with("2").replace("30 0 -1", "30 0 1e999") << "no rotation";
    QTest::newRow("of nothing") << with("1", "X,Y") << "no part";
    QTest::newRow("by nothing") << with("()") << "no part";
    QTest::newRow("two billion copies") << with("1-2000000000") << "more than 1000 copies";
    QTest::newRow("a product of a million") << with("(1-1000)(1-1000)") << "more than 1000 copies";
    QTest::newRow("far too many factors")
        << with(QByteArray(20'000, ' ').replace(" ", "(1-99)").constData())
        << "more than 1000 copies";
    QTest::newRow("a row of operators without end")
        << with(QByteArray(300'000, ' ').replace(" ", "(1)").constData()) << "8 operators in a row";
    QTest::newRow("too many atoms")
        << cifFile(std::vector<Written>(2100)) + assembly("(1-1000)") << "2100000 atoms";
  }
  void refuses() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, said);
    const auto entry = assembled(bytes);
    QVERIFY(!entry.ok());
    const QString text = QString::fromStdString(entry.error().text());
    QVERIFY2(text.contains(said), qPrintable(text));
    QVERIFY(!entry.error().remedy.empty() && !entry.error().file.empty());
  }

  void tooManyChains() {
    std::vector<Written> atoms;
    std::vector<QByteArray> names;
    for (int i = 0; i < 6; ++i)
      names.push_back("C" + QByteArray::number(i));
    for (const QByteArray& name : names)
      atoms.push_back({.chain = name.constData()});
    QByteArray list = assembly("(1-1000)", "C0,C1,C2,C3,C4,C5");
    for (int i = 6; i <= 1000; ++i)
      list += QByteArray::number(i) + " 1 0 0 0 0 1 0 0 0 0 1 0\n";
    list.replace("4 -1 0 0 0 0 1", "4 1 0 0 0 0 1")
        .replace("5 2 0 0 0 0 2 0 0 0 0 2", "5 1 0 0 0 0 1 0 0 0 0 1");
    const auto entry = assembled(cifFile(atoms) + list);
    QVERIFY(!entry.ok());
    QVERIFY2(entry.error().reason.find("5000 chains") != std::string::npos,
             entry.error().reason.c_str());
  }

  void remarks350() {
    const QByteArray file =
        QByteArray(remarks) +
        pdbFile(std::vector<Written>{{.place = {1, 2, 3}}, {.chain = "B", .place = {1, 0, 0}}});
    const auto one = assembled(file, ".pdb", "1");
    QVERIFY(one.ok());
    QCOMPARE(placesOf(*one), QString("A 1 2 3, A-2 29 -2 3"));
    const auto two = assembled(file, ".pdb", "2");
    QVERIFY(two.ok());
    QCOMPARE(placesOf(*two), QString("B 1.5 1 0"));
    QCOMPARE(assembliesText(one->assemblies),
             std::string("describes assemblies 1 (2 copies, dimeric), 2 (1 copy)"));
  }

  void aNameThatIsTaken() {
    const auto entry =
        assembled(cifFile(std::vector<Written>{{}, {.chain = "A-2"}}) + assembly("1,2", "A,A-2"));
    QVERIFY(entry.ok());
    std::set<std::string> chains;
    for (const AtomRecord& atom : entry->atoms)
      chains.insert(atom.chain);
    QCOMPARE(chains.size(), std::size_t(4));
  }

  void inAScene_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("mmCIF") << "1abc.cif" << cifFile(dimerHalf()) + assembly("1,2");
    QTest::newRow("PDB") << "1abc.pdb"
                         << QByteArray(remarks).replace("LE: 1", "LE: 7") + pdbFile(dimerHalf());
  }
  void inAScene() {
    QFETCH(QString, file);
    QFETCH(QByteArray, bytes);
    const QTemporaryDir folder;
    QVERIFY(readBytes(folder, file, bytes).ok());
    const std::vector<std::filesystem::path> files = {folder.filePath(file).toStdString()};
    const Result<Imported> plain = importInputs(files, {});
    QVERIFY(plain.ok());
    QVERIFY(plain->scene.named("Chain A").size() == 1 && plain->scene.named("Chain A-2").empty());
    QVERIFY(!plain->report.notes.empty());
    const QString note = QString::fromStdString(plain->report.notes.front());
    QVERIFY2(note.contains("7 (2 copies, dimeric)") && note.startsWith("1abc: describes"),
             qPrintable(note));
    QVERIFY(plain->report.warnings.empty());
    const Result<Imported> whole = importInputs(files, {.assembly = "7"});
    QVERIFY(whole.ok() && whole->report.notes.empty());
    QCOMPARE(whole->scene.named("Chain A").size(), std::size_t(1));
    const std::vector<NodeId> second = whole->scene.named("Chain A-2");
    QCOMPARE(second.size(), std::size_t(1));
    QCOMPARE(whole->scene.groupPath(second.front()), std::string("1abc, assembly 7"));
    QCOMPARE(whole->scene.named("magnesium (MG) × 2").size(), std::size_t(1));
  }
};

SLINE_TEST_WITH_EVENTS(TestAssemblies)
#include "test_assemblies.moc"
