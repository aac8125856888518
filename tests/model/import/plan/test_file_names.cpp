// SPDX-License-Identifier: Apache-2.0
// Tests that names of files and folders, which are often patients', stay out of what is imported.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <array>

#include "model/import/kinds/entry_names.h"
#include "model/import/plan/reload.h"
#include "model/scene_json/scene_json.h"
#include "tests/model/import/molecules/entry_files.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;
using namespace sline::test;

namespace {

constexpr const char* planted[] = {"Qzxdoe", "Qzxjane", "4711"};

QByteArray volume() {
  QByteArray text =
      "NRRD0004\ntype: uchar\ndimension: 3\nspace: left-posterior-superior\nsizes: 9 9 9\n"
      "space directions: (2,0,0) (0,2,0) (0,0,2)\nspace origin: (40,0,0)\nencoding: ascii\n\n";
  for (int i = 0; i < 729; ++i) {
    const int x = i % 9;
    const int y = i / 9 % 9;
    const int z = i / 81;
    text += std::min({x, y, z}) >= 2 && std::max({x, y, z}) < 7 ? "1 " : "0 ";
  }
  return text;
}

/// Returns what of the planted names the text has.
QStringList foundIn(const std::string& text) {
  QStringList found;
  for (const char* name : planted)
    if (QString::fromStdString(text).contains(QLatin1String(name), Qt::CaseInsensitive))
      found << name;
  return found;
}

}  // namespace

class FileNamesTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_top = m_folder.filePath("Qzxdoe_Qzxjane");

  Scene imported(const ImportOptions& options = {}) const {
    const auto result =
        importInputs(std::array{std::filesystem::path(m_top.toStdString())}, options);
    return result.ok() ? result->scene : Scene();
  }
  static QStringList namesIn(const Scene& scene) {
    QStringList names;
    for (const Node& node : scene.nodes())
      names << (node.isGroup() ? "[" + QString::fromStdString(node.name) + "]"
                               : QString::fromStdString(node.name));
    return names;
  }

 private slots:
  void init() {
    QDir(m_top).removeRecursively();
    QDir().mkpath(m_top + "/Qzxjane_bones");
    QDir().mkpath(m_top + "/4711");
    writeMesh(m_top + "/Qzxjane_bones/Qzxdoe_Qzxjane_femur.stl", *octahedron({0, 0, 0}, 9.0f));
    writeMesh(m_top + "/Qzxjane_bones/4711-left-tibia.ply", *octahedron({20, 0, 0}, 9.0f));
    writeMesh(m_top + "/4711/Qzxdoe.off", *octahedron({-20, 0, 0}, 9.0f));
    writeMesh(m_top + "/4711/Qzxjane_left.off", *octahedron({-40, 0, 0}, 9.0f));
    writeMesh(m_top + "/4711/liver.off", *octahedron({0, 40, 0}, 9.0f));
    writeText(m_top + "/4711/Qzxdoe_tumour.nrrd", volume());
  }

  void nothingOfThemIsKept() {
    const Scene scene = imported();
    QCOMPARE(scene.structuresBelow(rootId).size(), std::size_t(6));
    QCOMPARE(foundIn(sceneJson(scene)), QStringList());
    const QStringList names = namesIn(scene);
    for (const char* name : {"[bones]", "[group 1]", "femur", "left-tibia", "structure",
                             "left structure", "liver", "tumour"})
      QVERIFY2(names.contains(QLatin1String(name)), qPrintable(name + (": " + names.join(", "))));
    for (const Node& node : scene.nodes())
      if (!node.isGroup())
        QCOMPARE(node.provenance.file.starts_with('#'), node.name != "liver");
  }

  /// Values of a label volume that nothing names are no one's, whatever number they are.
  void valuesOfLabels() {
    QByteArray text = volume();
    text.replace(text.indexOf("uchar"), 5, "short");
    text.replace(text.lastIndexOf('1'), 1, "699");
    const QString file = m_top + "/4711/seg.nrrd";
    writeText(file, text);
    const auto result = importInputs(std::array{std::filesystem::path(file.toStdString())}, {});
    QVERIFY(result.ok());
    QCOMPARE(namesIn(result->scene).filter("label"), QStringList({"label 1", "label 699"}));
  }

  /// Programs title the solids of one file after files, too.
  void titlesOfSolids() {
    const auto solids = [](const char* size) {
      QByteArray text;
      for (const char* title : {"Qzxdoe_Qzxjane_femur", "Qzxjane_4711", "left kidney"}) {
        text += QByteArray("solid ") + title + "\n";
        for (const char* last : {"0 0 SIZE", "0 SIZE SIZE"})
          text += QByteArray(
                      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex SIZE 0 0\n"
                      "vertex ") +
                  last + "\nendloop\nendfacet\n";
        text += QByteArray("endsolid ") + title + "\n";
      }
      return text.replace("SIZE", size);
    };
    const QString file = m_top + "/4711/bones.stl";
    writeText(file, solids("90"));
    const auto inputs = std::array{std::filesystem::path(file.toStdString())};
    const auto imported = importInputs(inputs, {});
    QVERIFY(imported.ok());
    QCOMPARE(foundIn(sceneJson(imported->scene)), QStringList());
    QCOMPARE(named(imported->scene, "left kidney").provenance.part, std::string("left kidney"));
    // How many names are shorter is told once, with the words that they lack.
    QCOMPARE(imported->report.notes.size(), std::size_t(1));
    QVERIFY2(imported->report.notes[0].ends_with(
                 "left out of names: 2 (\"Qzxdoe\", \"Qzxjane\", \"4711\")"),
             imported->report.notes[0].c_str());
    writeText(file, solids("80"));
    const Reloaded reloaded = reload(imported->scene, inputs);
    QCOMPARE(reloaded.meshes.size(), std::size_t(3));
    QCOMPARE(named(reloaded.scene, "femur").mesh->bounds().high.x, 80.0f);
    QCOMPARE(foundIn(sceneJson(reloaded.scene)), QStringList());
    const auto kept = importInputs(inputs, {.keepFileNames = true});
    QVERIFY(kept.ok());
    QVERIFY(kept->report.notes.empty());
    QCOMPARE(named(kept->scene, "Qzxjane 4711").provenance.part, std::string("Qzxjane 4711"));
  }

  void allOfThemByChoice() {
    ImportOptions options;
    options.keepFileNames = true;
    const Scene scene = imported(options);
    const QStringList names = namesIn(scene);
    for (const char* name : {"[Qzxjane bones]", "[4711]", "Qzxdoe Qzxjane femur", "Qzxdoe"})
      QVERIFY2(names.contains(QLatin1String(name)), qPrintable(names.join(", ")));
    QCOMPARE(named(scene, "Qzxdoe").provenance.file, std::string("Qzxdoe.off"));
  }

  /// What stands in a file may be a person's as well.
  void namesInFilesNeither() {
    const auto solid = [](const char* title, const char* x) {
      QByteArray text = QByteArray("solid ") + title + '\n';
      const QByteArray corners[] = {QByteArray("0 0 0"), x + QByteArray(" 0 0"), "0 9 0", "0 0 9"};
      for (const auto& face : {std::array{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int corner : face)
          text += "vertex " + corners[corner] + '\n';
        text += "endloop\nendfacet\n";
      }
      return text + "endsolid\n";
    };
    QDir(m_top).removeRecursively();
    QDir().mkpath(m_top);
    const QString file = m_top + "/bones.stl";
    writeText(file, solid("Qzxdoe_femur", "9") + solid("Qzxjane", "-9"));
    const Scene scene = imported();
    QCOMPARE(namesIn(scene), QStringList({"femur", "bones"}));
    QCOMPARE(foundIn(sceneJson(scene)), QStringList());
    // Marks are enough to find them again.
    writeText(file, solid("Qzxdoe_femur", "7") + solid("Qzxjane", "-9"));
    const Reloaded reloaded = reload(scene, std::array{std::filesystem::path(m_top.toStdString())});
    QCOMPARE(named(reloaded.scene, "femur").mesh->bounds().high.x, 7.0f);
    QCOMPARE(foundIn(sceneJson(reloaded.scene)), QStringList());
  }

  /// Nor what the file of a molecule calls its chains and ligands, unless it is a published entry,
  /// whose names are public.
  void namesOfMoleculesNeither_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("id");
    QTest::addColumn<bool>("published");
    QTest::newRow("of a laboratory") << "model.pdb"
                                     << "    " << false;
    QTest::newRow("of a laboratory, with an id like a number") << "model.pdb"
                                                               << "4711" << false;
    QTest::newRow("entry") << "model.pdb"
                           << "1CRN" << true;
    QTest::newRow("entry, by its file's name") << "1crn.pdb"
                                               << "    " << true;
    QTest::newRow("predicted") << "AF-P69905-F1-model_v4.pdb"
                               << "    " << true;
  }
  void namesOfMoleculesNeither() {
    QFETCH(QString, file);
    QFETCH(QString, id);
    QFETCH(bool, published);
    std::vector<Written> atoms = helix("ACDEFGHIKL");
    for (int i = 0; i < 2; ++i)
      atoms.push_back({.name = i == 0 ? " C1 " : " O1 ",
                       .residue = "EOH",
                       .number = 50,
                       .place = {20.0 + 1.4 * i, 0, 0},
                       .element = i == 0 ? "C" : "O",
                       .hetero = true});
    atoms.push_back({.name = "ZN  ",
                     .residue = " ZN",
                     .number = 51,
                     .place = {30.0, 0, 0},
                     .element = "ZN",
                     .hetero = true});
    const QByteArray head = "HEADER    TRIAL                                   01-JAN-00   " +
                            id.toLatin1() +
                            "\nTITLE     MODEL OF QZXDOE\n"
                            "COMPND    MOL_ID: 1;\nCOMPND   2 MOLECULE: KINASE OF QZXJANE;\n"
                            "COMPND   3 CHAIN: A;\nHETNAM     EOH QZXJANES DRUG\n"
                            "HETNAM      ZN ZINC ION\n";
    QDir(m_top).removeRecursively();
    QDir().mkpath(m_top);
    writeText(m_top + '/' + file, head + pdbFile(atoms));
    const auto result =
        importInputs(std::array{std::filesystem::path((m_top + '/' + file).toStdString())}, {});
    QVERIFY(result.ok());
    const QString names = namesIn(result->scene).join(", ");
    QCOMPARE(names.contains("Chain A – Kinase of qzxjane"), published);
    QCOMPARE(names.contains("[Qzxjanes drug (EOH)]"), published);
    QVERIFY2(names.contains("Chain A") && names.contains("EOH") && names.contains("Zinc ion"),
             qPrintable(names));
    const QStringList found = foundIn(sceneJson(result->scene));
    QVERIFY2(published || found.isEmpty(), qPrintable(found.join(' ') + ": " + names));
    // Who wants it has it all.
    ImportOptions keep;
    keep.keepFileNames = true;
    const auto kept =
        importInputs(std::array{std::filesystem::path((m_top + '/' + file).toStdString())}, keep);
    QVERIFY(kept.ok() && namesIn(kept->scene).join(", ").contains("Kinase of qzxjane"));
  }

  /// A title may have any length.
  void entriesAreKnown() {
    for (const char* name :
         {"2src.cif.gz", "pdb_00002src.cif", "4hhb-assembly1.cif", "AF-P69905-F1-model_v4.cif"})
      QVERIFY2(isEntryFile(name), name);
    for (const std::string& name : {std::string("1961.pdb"), std::string("doe1.pdb"),
                                    "4hhb-assembly" + std::string(1'000'000, 'x')})
      QVERIFY(!isEntryFile(name));
  }

  /// It is said that names are not whole.
  void whatIsLeftOutIsTold() {
    const auto told = [this](bool keep) {
      ImportOptions options;
      options.keepFileNames = keep;
      const auto result =
          importInputs(std::array{std::filesystem::path(m_top.toStdString())}, options);
      QStringList notes;
      for (const std::string& note : result->report.notes)
        notes << QString::fromStdString(note);
      return notes.join('\n');
    };
    QVERIFY2(told(false).contains("left out of names: 6"), qPrintable(told(false)));
    QVERIFY(!told(true).contains("left out of names"));
  }

  /// A checksum is enough to find the file again.
  void theyAreReadAgain() {
    const Scene scene = imported();
    const std::array places{std::filesystem::path(m_top.toStdString())};
    QVERIFY(!reload(scene, places).changed);
    writeMesh(m_top + "/Qzxjane_bones/Qzxdoe_Qzxjane_femur.stl", *octahedron({0, 0, 0}, 7.0f));
    const Reloaded reloaded = reload(scene, places);
    QVERIFY(reloaded.changed);
    QCOMPARE(named(reloaded.scene, "femur").mesh->bounds().high.x, 7.0f);
    QCOMPARE(foundIn(sceneJson(reloaded.scene)), QStringList());
    // Whoever reads again is told which file it was; it is there, beside the person.
    QCOMPARE(std::count_if(reloaded.files.begin(), reloaded.files.end(),
                           [](const ReloadedFile& file) {
                             return file.fate == ReloadedFile::Fate::replaced &&
                                    file.file == "Qzxdoe_Qzxjane_femur.stl";
                           }),
             1);
  }
};

SLINE_TEST(FileNamesTest)
#include "test_file_names.moc"
