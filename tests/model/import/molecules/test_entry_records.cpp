// SPDX-License-Identifier: Apache-2.0
// Tests the two readers row by row: what is read, what is refused and how.
#include <QTest>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "model/import/molecules/entry_rows.h"
#include "tests/model/import/molecules/entry_files.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

const char* const loopHead =
    "data_x\nloop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_comp_id\n"
    "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";

QByteArray goodLine(int serial = 1) {
  return pdbLine({.place = {1.5, -2.25, 3.125}}, serial);
}

/// Returns the line with its columns from `first` (counted from 1) overwritten.
QByteArray with(QByteArray line, int first, const char* text) {
  return line.replace(first - 1, qsizetype(qstrlen(text)), text);
}

}  // namespace

class TestEntryRecords : public QObject {
  Q_OBJECT

 private slots:
  void reads_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("atoms");
    QTest::addColumn<int>("unreadable");
    QTest::addColumn<int>("otherModels");
    const QByteArray ten = goodLine() + goodLine(2) + goodLine(3) + goodLine(4) + goodLine(5) +
                           goodLine(6) + goodLine(7) + goodLine(8) + goodLine(9) + goodLine(10);
    const QByteArray two = goodLine() + goodLine(2);
    QTest::newRow("plain") << ".pdb" << two << 2 << 0 << 0;
    QTest::newRow("DOS line ends")
        << ".pdb" << QByteArray(two).replace("\n", "\r\n") << 2 << 0 << 0;
    QTest::newRow("old Macintosh") << ".pdb" << QByteArray(two).replace("\n", "\r") << 2 << 0 << 0;
    QTest::newRow("no last line end") << ".pdb" << two.chopped(1) << 2 << 0 << 0;
    QTest::newRow("cut behind z") << ".pdb" << goodLine().left(54) << 1 << 0 << 0;
    QTest::newRow("one cut inside z") << ".pdb" << ten + goodLine().left(40) << 10 << 1 << 0;
    QTest::newRow("one NaN") << ".pdb" << ten + with(goodLine(), 31, "     nan") << 10 << 1 << 0;
    QTest::newRow("one overflow") << ".pdb" << ten + with(goodLine(), 39, "********") << 10 << 1
                                  << 0;
    QTest::newRow("serials wrap") << ".pdb"
                                  << with(goodLine(), 7, "99999") + with(goodLine(), 7, "    0") +
                                         with(goodLine(), 7, "*****") + with(goodLine(), 7, "A0000")
                                  << 4 << 0 << 0;
    QTest::newRow("three models") << ".pdb"
                                  << "MODEL        1\n" + two + "ENDMDL\nMODEL        2\n" + two +
                                         "ENDMDL\nMODEL        3\n" + two + "ENDMDL\n"
                                  << 2 << 0 << 2;
    QTest::newRow("cif") << ".cif" << QByteArray(loopHead) + "1 C ALA 1 2 3\n2 N ALA 4 5 6\n"
                         << 2 << 0 << 0;
    QTest::newRow("cif, one value a line, comment, quotes")
        << ".cif" << QByteArray(loopHead) + "1\n'C'\n\"ALA\"\n1\n2 # two\n3\n"
        << 1 << 0 << 0;
    QTest::newRow("cif, capitals and DOS")
        << ".cif"
        << QByteArray(QByteArray(loopHead).replace("Cartn", "CARTN").replace("loop_", "LOOP_") +
                      "1 C ALA 1 2 3\n")
               .replace("\n", "\r\n")
        << 1 << 0 << 0;
    QTest::newRow("cif, uncertainty") << ".cif" << QByteArray(loopHead) + "1 C ALA 1.5(2) 2 3\n"
                                      << 1 << 0 << 0;
    QTest::newRow("cif, second block ignored")
        << ".cif" << QByteArray(loopHead) + "1 C ALA 1 2 3\n" + loopHead + "1 C ALA 1 2 3\n"
        << 1 << 0 << 0;
    QTest::newRow("json") << ".json" << jsonFile(helix("A")) << 5 << 0 << 0;
    QTest::newRow("json, numbers as text, capitals as they like")
        << ".json"
        << QByteArray(R"({"data_X": {"atom_site": {"cartn_X": ["1.5", "2"], "Cartn_y": [0, 0],
                        "Cartn_z": [-1e2, 3]}}})")
        << 2 << 0 << 0;
    QTest::newRow("cif, models")
        << ".cif"
        << QByteArray(
               "data_x\nloop_\n_atom_site.pdbx_PDB_model_num\n_atom_site.Cartn_x\n"
               "_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 0 0 0\n1 1 0 0\n2 0 0 0\n7 0 0 0\n")
        << 2 << 0 << 2;
  }
  void reads() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    const QTemporaryDir folder;
    const Result<EntryRecords> records = recordsOf(folder, qPrintable(extension), bytes);
    QVERIFY2(records.ok(), records.ok() ? "" : records.error().text().c_str());
    QTEST(int(records->atoms.size()), "atoms");
    QTEST(int(records->unreadable), "unreadable");
    QTEST(int(records->otherModels), "otherModels");
  }

  void refuses_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("said");
    QTest::newRow("no atom") << ".pdb" << QByteArray("HEADER    NOTHING\nEND\n") << "holds no atom";
    QTest::newRow("a debugger's database")
        << ".pdb" << QByteArray("Microsoft C/C++ MSF 7.00\r\n\x1a") << "holds no atom";
    QTest::newRow("no coordinates") << ".pdb" << goodLine().left(30) << "1 of 1 atoms";
    QTest::newRow("a million atoms promised")
        << ".pdb" << QByteArray("MASTER  1000000 1000000\nNUMMDL 1000000\n") << "holds no atom";
    QTest::newRow("half without z") << ".pdb" << goodLine() + goodLine().left(50) << "1 of 2 atoms";
    QTest::newRow("cif without block") << ".cif" << QByteArray("loop_\n_a.b\n1\n") << "data block";
    QTest::newRow("cif of something else")
        << ".cif" << QByteArray("data_x\n_cell.length_a 5\n") << "without the atoms";
    QTest::newRow("small molecule")
        << ".cif"
        << QByteArray(
               "data_x\nloop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n"
               "_atom_site_fract_z\nC1 0.1 0.2 0.3\n")
        << "fractional coordinates";
    QTest::newRow("cif, places unknown") << ".cif" << QByteArray(loopHead) + "1 C ALA ? . ?\n"
                                         << "1 of 1 atoms";
    QTest::newRow("cif, ends in an atom") << ".cif" << QByteArray(loopHead) + "1 C ALA 1\n"
                                          << "1 of 1 atoms";
    QTest::newRow("cif, text never ends")
        << ".cif" << QByteArray("data_x\n_struct.title\n;endless\n") << "unterminated text field";
    QTest::newRow("no mmJSON") << ".json" << QByteArray("{\"format\": 1}") << "no mmJSON";
    QTest::newRow("broken JSON") << ".json" << QByteArray("{\"data_X\": {\"a\": ") << "as JSON";
    QTest::newRow("JSON, columns of different lengths")
        << ".json" << QByteArray(R"({"data_X": {"atom_site": {"id": [1, 2], "Cartn_x": [1]}}})")
        << "equally long";
    QTest::newRow("JSON, deep") << ".json" << QByteArray("{\"data_X\":") + QByteArray(5000, '[')
                                << "as JSON";
    QTest::newRow("JSON, places unknown")
        << ".json"
        << QByteArray(R"({"data_X": {"atom_site": {"Cartn_x": [null], "Cartn_y": ["a"]}}})")
        << "1 of 1 atoms";
  }
  void refuses() {
    QFETCH(QString, extension);
    QFETCH(QByteArray, bytes);
    QFETCH(QString, said);
    const QTemporaryDir folder;
    const Result<EntryRecords> records = recordsOf(folder, qPrintable(extension), bytes);
    QVERIFY(!records.ok());
    const QString text = QString::fromStdString(records.error().text());
    QVERIFY2(text.contains(said), qPrintable(text));
    QVERIFY(!records.error().remedy.empty() && !records.error().file.empty());
  }

  void serials_data() {
    QTest::addColumn<QByteArray>("columns");
    QTest::addColumn<qlonglong>("serial");
    QTest::newRow("decimal") << QByteArray("   42") << 42LL;
    QTest::newRow("largest") << QByteArray("99999") << 99'999LL;
    QTest::newRow("first of hybrid-36") << QByteArray("A0000") << 100'000LL;
    QTest::newRow("next letter") << QByteArray("B0000") << 100'000LL + 1'679'616LL;
    QTest::newRow("last capital") << QByteArray("ZZZZZ") << 43'770'015LL;
    QTest::newRow("first small") << QByteArray("a0000") << 43'770'016LL;
    QTest::newRow("none") << QByteArray("*****") << 0LL;
  }
  void serials() {
    QFETCH(QByteArray, columns);
    const QTemporaryDir folder;
    const auto records = recordsOf(folder, ".pdb", with(goodLine(), 7, columns.constData()));
    QVERIFY(records.ok());
    QTEST(qlonglong(records->atoms.front().serial), "serial");
  }

  void elements_data() {
    QTest::addColumn<QString>("columns");
    QTest::addColumn<QString>("residue");
    QTest::addColumn<QString>("symbol");
    QTest::newRow("Cα") << " CA "
                        << "ALA"
                        << "C";
    QTest::newRow("calcium") << "CA  "
                             << "CA"
                             << "Ca";
    QTest::newRow("calcium in the wrong columns") << " CA "
                                                  << "CA"
                                                  << "Ca";
    QTest::newRow("hydrogen with digit") << "1HB "
                                         << "ALA"
                                         << "H";
    QTest::newRow("hydrogen of four letters") << "HG11"
                                              << "VAL"
                                              << "H";
    QTest::newRow("iron") << "FE  "
                          << "HEM"
                          << "Fe";
    QTest::newRow("nitrogen of haem") << " NA "
                                      << "HEM"
                                      << "N";
    QTest::newRow("prime") << " O5'"
                           << "DA"
                           << "O";
    QTest::newRow("deuterium") << " D  "
                               << "DOD"
                               << "H";
    QTest::newRow("selenium") << "SE  "
                              << "MSE"
                              << "Se";
    QTest::newRow("nothing") << " 12 "
                             << "ALA"
                             << "";
    // CHARMM's ions, and names that programs write from the first column on.
    const std::array<std::array<const char*, 3>, 14> names{{{"POT ", "POT", "K"},
                                                            {" POT", "POT", "K"},
                                                            {"SOD ", "SOD", "Na"},
                                                            {" SOD", "SOD", "Na"},
                                                            {"CLA ", "CLA", "Cl"},
                                                            {" CLA", "CLA", "Cl"},
                                                            {"CAL ", "CAL", "Ca"},
                                                            {" CAL", "CAL", "Ca"},
                                                            {"CA  ", "HSD", "C"},
                                                            {"CD2 ", "HSE", "C"},
                                                            {"NE2 ", "HSP", "N"},
                                                            {"HG1 ", "THR", "H"},
                                                            {"N9  ", "GUA", "N"},
                                                            {"P   ", "CYT", "P"}}};
    for (const auto& [columns, residue, symbol] : names)
      QTest::addRow("%s of %s", columns, residue) << columns << residue << symbol;
  }
  void elements() {
    QFETCH(QString, columns);
    QFETCH(QString, residue);
    const Element* element = elementOfName(columns.toStdString(), residue.toStdString());
    const QString symbol =
        element ? QString::fromUtf8(element->symbol.data(), qsizetype(element->symbol.size()))
                : QString();
    QTEST(symbol, "symbol");
  }

  void missingElementColumn() {
    const QTemporaryDir folder;
    const auto records = recordsOf(folder, ".pdb", goodLine().left(66) + "\n");
    QVERIFY(records.ok());
    QCOMPARE(records->atoms.front().element, elementOf("C"));
    QCOMPARE(records->atoms.front().place, glm::dvec3(1.5, -2.25, 3.125));
  }

  void valuesOfCif() {
    // One row of items, then a table, then items again: words, quotes, text, comments.
    const QTemporaryDir folder;
    QFile file(folder.filePath("values.cif"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "data_one # comment\n_A.b 'it's one'\n_a.C \"two words\"\n_a.d\n;first\nsecond;\n;\n"
        "_e.f ?\nLOOP_ _g.h _g.i\n'?' . #end\n3 ;4\n_a.b 5\n");
    file.close();
    const Result<Source> source = Source::read(file.fileName().toStdString(), {});
    QVERIFY(source.ok());
    struct Rows : EntryRowReader {
      void readRow(const EntryColumns& columns, std::span<const EntryValue> values) override {
        std::string row;
        for (std::size_t i = 0; i < values.size(); ++i)
          row += columns.names[i] + "=" + (values[i].says() ? "" : "!") +
                 std::string(values[i].text) + " ";
        rows << QString::fromStdString(row).trimmed();
      }
      void missRow(const EntryColumns&) override { rows << "missed"; }
      bool hasEnough() const override { return false; }
      QStringList rows;
    } reader;
    QVERIFY(readCifRows(*source, reader).ok());
    QCOMPARE(reader.rows, QStringList({"_a.b=it's one _a.c=two words _a.d=first\nsecond;",
                                       "_e.f=!?", "_g.h=? _g.i=!.", "_g.h=3 _g.i=;4", "_a.b=5"}));
  }

  void cutShort_data() {
    QTest::addColumn<QByteArray>("behind");
    QTest::addColumn<QString>("said");
    QTest::newRow("a text never ends")
        << QByteArray("_a.b\n;endless\n") << "line 13: unterminated text field";
    QTest::newRow("a quote never ends")
        << QByteArray("_a.b 'endless\n_c.d 1\n") << "line 11: unterminated 'string'";
    QTest::newRow("a value without item")
        << QByteArray("_a.b 1 2\n") << "line 11: cannot be read as CIF";
  }
  void cutShort() {
    QFETCH(QByteArray, behind);
    const QTemporaryDir folder;
    const auto records =
        recordsOf(folder, ".cif", QByteArray(loopHead) + "1 C ALA 1 2 3\n2 C ALA 4 5 6\n" + behind);
    QVERIFY(records.ok());
    QCOMPARE(records->atoms.size(), std::size_t(2));
    QFETCH(QString, said);
    QVERIFY2(QString::fromStdString(records->cutShort).startsWith(said), records->cutShort.c_str());
  }

  void names_data() {
    QTest::addColumn<QString>("capitals");
    QTest::addColumn<QString>("readable");
    QTest::newRow("title") << "CRYSTAL STRUCTURE OF C-SRC, IN COMPLEX WITH AMP-PNP"
                           << "Crystal structure of C-SRC, in complex with AMP-PNP";
    QTest::newRow("digits") << "CYTOCHROME P450 OF RAT"
                            << "Cytochrome P450 of RAT";
    QTest::newRow("two sentences") << "ONE WORD. PENTAGON RINGS"
                                   << "One word. Pentagon rings";
    QTest::newRow("as written") << "Crystal of c-Src"
                                << "Crystal of c-Src";
    QTest::newRow("blanks") << "  HEAT   SHOCK "
                            << "Heat shock";
    QTest::newRow("no ASCII") << "TRIAL \xc3\xa9"
                              << "Trial ??";
    QTest::newRow("empty") << ""
                           << "";
  }
  void names() {
    QFETCH(QString, capitals);
    QTEST(QString::fromStdString(readableCapitals(capitals.toStdString())), "readable");
  }
};

SLINE_TEST_WITH_EVENTS(TestEntryRecords)
#include "test_entry_records.moc"
