// SPDX-License-Identifier: Apache-2.0
// Tests whose work surfaces are said to be: by what files and the texts beside them say, by a
// person, and never by what tells of a patient.
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "model/edit/credits.h"
#include "model/import/credits/source_credit.h"
#include "model/import/plan/import.h"
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
    add("nothing", CreditText::licence, "", "||");
    add("zeros", CreditText::mesh, "# CC BY 4.0 \x01 by\tJ\n", "||CC BY 4.0 by J");
  }
  void textsSayIt() {
    QFETCH(int, kind);
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    const SourceCredit said =
        model::creditIn({text.constData(), std::size_t(text.size())}, CreditText(kind));
    QCOMPARE(QString::fromStdString(said.authors + "|" + said.source + "|" + said.licence), says);
  }

  void longLinesAreCutBetweenLetters() {
    const std::string text = "# CC BY 4.0 " + std::string(290, 'x') + "\xc3\xa4\xc3\xa4\n";
    const SourceCredit said = model::creditIn(text, CreditText::mesh);
    QVERIFY(said.licence.size() <= model::longestCredit);
    QVERIFY(!QString::fromStdString(said.licence).contains(QChar::ReplacementCharacter));
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
