// SPDX-License-Identifier: Apache-2.0
// Tests whose work surfaces are said to be: by what files and the texts beside them say, by a
// person, and never by what tells of a patient.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <bit>

#include "model/edit/credits.h"
#include "model/import/credits/source_credit.h"
#include "model/import/plan/import.h"
#include "model/scene_file/scene_file.h"
#include "tests/model/import/molecules/entry_files.h"
#include "tests/model/import/written_meshes.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using model::CreditText;
using model::SourceCredit;

namespace {

void write(const QString& name, const QByteArray& text) {
  QFile file(name);
  if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
    qFatal("cannot write %s", qPrintable(name));
}

}  // namespace

class SourceCreditTest : public QObject {
  Q_OBJECT
 private slots:
  void textsSayIt_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    const auto add = [](const char* name, CreditText kind, const char* text, const char* says) {
      QTest::newRow(name) << int(kind) << QByteArray(text) << QString::fromUtf8(says);
    };
    add("OBJ", CreditText::mesh, "# Author: Jane Doe\n# a heart\n# (c) Atlas, CC BY 4.0\nv 0 0 0\n",
        "Jane Doe||(c) Atlas, CC BY 4.0");
    add("PLY", CreditText::mesh, "ply\ncomment Copyright 2020 An Atlas\nelement vertex 3\n",
        "||Copyright 2020 An Atlas");
    add("a program's line", CreditText::mesh, "# Created by Blender 3.6\n# www.blender.org\n",
        "||");
    add("glTF", CreditText::mesh,
        "{\"asset\":{\"version\":\"2.0\",\"copyright\":\"\\u00a9 J \\\"D\\\"\"}}", "||© J \"D\"");
    add("glTF's other texts", CreditText::mesh,
        "{\"asset\":{\"version\":\"2.0\",\"generator\":\"X (c) Y\"}}", "||");
    add("a licence", CreditText::licence,
        "                Apache License\n           Version 2.0, January 2004\n",
        "||Apache License");
    add("the best line", CreditText::licence,
        "License of this atlas\n\nIt is licensed under Creative Commons Attribution 4.0.\n",
        "||It is licensed under Creative Commons Attribution 4.0.");
    add("a citation", CreditText::citation,
        "title: \"An atlas\"\nauthors:\n  - family-names: Doe\n    given-names: Jane\n"
        "  - name: The Institute\nlicense: CC-BY-4.0\n",
        "Jane Doe, The Institute|An atlas|CC-BY-4.0");
    add("a readme", CreditText::readme, "# Meshes\nAuthors: A, B\nLicense: CC0\nSource: /tmp/x\n",
        "A, B||CC0");
    add("a readme's prose", CreditText::readme, "See the license. We made this in 2020.\n", "||");
    add("a patient", CreditText::readme, "Author: patient Jane Doe\nLicense: of patient 7\n", "||");
    add("a patient's birth", CreditText::mesh, "# Copyright of Jane Doe, date of birth 1.1.70\n",
        "||");
    add("a path", CreditText::mesh, "# Copyright /home/jane/scans\n# Author: C:\\Users\\jane\n",
        "||");
    add("a name, not a sentence about it", CreditText::licence,
        "All or portions of this licensed product are subject to the following terms\n\n"
        "The Atlas license below is a BSD style license, with extensions\n"
        "to cover contributions.\n\nAtlas Contribution and Software License Agreement\n"
        "Version 1.0\n\nIf you distribute it, this license must be included.\n",
        "||Atlas Contribution and Software License Agreement");
    add("a name, not a line within a sentence", CreditText::licence,
        "Atlas Software License Agreement\n\nWhoever gives it on keeps\n"
        "applicable attributions, copyright notices and licenses for any\nparts.\n",
        "||Atlas Software License Agreement");
    add("a sentence with a known name", CreditText::licence,
        "This work is licensed under CC BY 4.0.\n", "||This work is licensed under CC BY 4.0.");
    add("nothing", CreditText::licence, "", "||");
    add("control characters", CreditText::mesh, "# CC BY 4.0 \x01 by\tJ\n", "||");
    add("control characters of Latin 1", CreditText::mesh, "# CC BY\xc2\x85 4.0\n", "||");
    add("Latin 1", CreditText::licence, "\xa9 J, CC BY\nMIT License, \xfc\nCC0 for all\n",
        "||CC0 for all");
    add("numbers of a VTK file", CreditText::mesh,
        "# vtk DataFile Version 3.0\na heart\nBINARY\nDATASET POLYDATA\nPOINTS 9 float\n"
        "\x41\n#gpl \x99\x99\n# (c) J, CC BY\n",
        "||");
    add("after a PLY file's header", CreditText::mesh,
        "ply\ncomment CC0\nend_header\nxyz\n# CC BY by J\ncomment (c) J\n", "||CC0");
    add("between numbers", CreditText::mesh, "# a heart\nv 0 0 0\n# CC BY by J\n", "||");
    add("STL in binary", CreditText::mesh,
        "solid heart, CC BY 4.0                                                          "
        "\x01\x02\n# gpl\n",
        "||heart, CC BY 4.0");
    add("NRRD", CreditText::mesh, "NRRD0005\n# CC BY 4.0\ntype: int16\n\n# gpl\n", "||CC BY 4.0");
    add("appended data", CreditText::mesh,
        "<VTKFile>\n<AppendedData encoding=\"raw\">\n_\x05\n#gpl\n# (c) J\n", "||");
    add("within a word", CreditText::mesh, "# absdiff of singpl\n", "||");
  }
  void textsSayIt() {
    QFETCH(int, kind);
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const SourceCredit said =
        model::creditIn({text.constData(), std::size_t(text.size())}, CreditText(kind));
    QCOMPARE(QString::fromStdString(said.authors + "|" + said.source + "|" + said.licence), says);
  }

  /// A line that is too long for a scene is cut between letters, and import tells of it; one that
  /// is too long for any line is none.
  void longLinesAreCutAndTold() {
    QTemporaryDir folder;
    const auto credited = [&folder](const std::string& line) {
      write(folder.filePath("a.obj"),
            QByteArray::fromStdString("# " + line) + "\nv 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\n");
      return model::importInputs({{folder.filePath("a.obj").toStdString()}}, {});
    };
    const auto cut = credited("CC BY 4.0 " + std::string(289, 'x') + "\xc3\xa4\xc3\xa4");
    QVERIFY(cut.ok());
    QCOMPARE(cut->scene.nodes()[0].provenance.credit.licence, "CC BY 4.0 " + std::string(289, 'x'));
    QCOMPARE(cut->report.warnings.size(), std::size_t(1));
    QCOMPARE(cut->report.warnings[0].reason,
             std::string("structure \"a\": its credit is longer than 300 bytes; it was cut there"));
    const auto none = credited("CC BY 4.0 " + std::string(2000, 'x'));
    QVERIFY(none.ok() && none->scene.nodes()[0].provenance.credit.empty());
  }

  /// The numbers of this file have the bytes of a comment about a licence, and more that are no
  /// text; the scene that was made of it could be saved and not opened.
  void numbersAreNoLicence() {
    QTemporaryDir folder;
    QByteArray values("\n#gpl (c) ");
    values += QByteArray(3 * 33 * 4 - values.size(), '\xe9');
    QByteArray points;
    const auto number = [](QByteArray& to, std::uint32_t bits) {
      for (int shift = 24; shift >= 0; shift -= 8)
        to += char(bits >> shift & 0xff);
    };
    for (const float coordinate : {0.0f, 0.0f, 0.0f, 50.0f, 0.0f, 0.0f, 0.0f, 50.0f, 0.0f})
      number(points, std::bit_cast<std::uint32_t>(coordinate));
    QByteArray file = "# vtk DataFile Version 3.0\nvtk output\nBINARY\nDATASET POLYDATA\n";
    file += "POINTS 3 float\n" + points + "\nPOLYGONS 1 4\n";
    for (const std::uint32_t corner : {3u, 0u, 1u, 2u})
      number(file, corner);
    file += "\nPOINT_DATA 3\nFIELD FieldData 1\nmeasured 33 3 float\n" + values;
    write(folder.filePath("a.vtk"), file + "\n");
    const auto imported = model::importInputs({{folder.filePath("a.vtk").toStdString()}}, {});
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
    QVERIFY(imported->scene.nodes()[0].provenance.credit.empty());
    const auto bytes = model::sceneFileBytes({.scene = imported->scene});
    QVERIFY2(bytes.ok(), bytes.ok() ? "" : bytes.error().text().c_str());
    const auto again = model::documentFromBytes(*bytes);
    QVERIFY2(again.ok(), again.ok() ? "" : again.error().text().c_str());
    QVERIFY(again->leftOut.empty());
  }

  /// The file's own words come first, then its folder's, then the licence above; names of folders
  /// and files are none.
  void importReadsIt() {
    QTemporaryDir top;
    const QString folder = top.filePath("QZX Jane Doe/meshes");
    QVERIFY(QDir().mkpath(folder));
    test::writeMesh(folder + "/a.ply", *test::sphere(10.0f, 2));
    test::writeMesh(folder + "/b.ply", *test::sphere(12.0f, 2));
    QFile own(folder + "/a.ply");
    QVERIFY(own.open(QIODevice::ReadOnly));
    QByteArray ply = own.readAll();
    own.close();
    write(folder + "/a.ply", ply.insert(ply.indexOf("element"), "comment License: CC0 for this\n"));
    write(folder + "/README.txt", "Author: An Institute\n");
    write(top.filePath("QZX Jane Doe/LICENSE"), "All of it: CC BY 4.0\n");
    write(top.filePath("QZX Jane Doe/README"), "Author: QZX\n");
    const auto imported = model::importInputs({{folder.toStdString()}}, {});
    QVERIFY(imported.ok());
    std::map<std::string, std::string> lines;
    for (const model::Node& node : imported->scene.nodes())
      if (!node.isGroup())
        lines[node.name] = node.provenance.credit.line();
    QCOMPARE(lines["a"], std::string("An Institute, License: CC0 for this"));
    QCOMPARE(lines["b"], std::string("An Institute, All of it: CC BY 4.0"));
  }

  /// A published entry is no part of the collection that its file was put into.
  void entriesSayTheirOwn() {
    QTemporaryDir folder;
    const QByteArray pdb = test::pdbFile(test::helix("GGA"));
    write(folder.filePath("2src.pdb"), pdb);
    write(folder.filePath("AF-P69905-F1-model_v4.pdb"), pdb);
    write(folder.filePath("receptor.pdb"), pdb);
    write(folder.filePath("LICENSE.txt"), "The MIT License\n\nCopyright (c) 2014 A. Maker\n");
    const auto creditOf = [&folder](const char* file) {
      const auto imported = model::importInputs({{folder.filePath(file).toStdString()}}, {});
      std::string line = imported.ok() ? "no structure" : imported.error().text();
      if (imported.ok())
        for (const model::Node& node : imported->scene.nodes())
          if (!node.isGroup())
            line = node.provenance.credit.line();
      return line;
    };
    QCOMPARE(creditOf("2src.pdb"), std::string("PDB ID 2SRC"));
    QCOMPARE(creditOf("AF-P69905-F1-model_v4.pdb"), std::string("AlphaFold DB P69905"));
    QCOMPARE(creditOf("receptor.pdb"), std::string("The MIT License"));
  }

  void personsSayIt() {
    model::Scene scene;
    const model::NodeId group = scene.append({.name = "group"});
    const model::NodeId one =
        scene.append({.parent = group, .name = "one", .mesh = test::sphere(5.0f, 1)});
    const model::NodeId other = scene.append({.name = "other", .mesh = test::sphere(5.0f, 1)});
    const model::CreditChange said{.authors = " Jane\nDoe ", .source = {}, .licence = "CC0"};
    const model::Edited edited = model::withCredit(scene, {&group, 1}, said);
    QVERIFY(edited.changed);
    QCOMPARE(edited.scene.find(one)->provenance.credit.line(), std::string("Jane Doe, CC0"));
    QVERIFY(edited.scene.find(other)->provenance.credit.empty());
    QVERIFY(!model::withCredit(edited.scene, {&one, 1}, said).changed);
    QVERIFY(!model::withCredit(edited.scene, {&one, 1}, {}).changed);
    const model::Edited less = model::withCredit(edited.scene, {&one, 1}, {.authors = ""});
    QCOMPARE(less.scene.find(one)->provenance.credit.line(), std::string("CC0"));
  }
};

SLINE_TEST(SourceCreditTest)
#include "source_credit_test.moc"
