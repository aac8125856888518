// SPDX-License-Identifier: Apache-2.0
#include "app/cli/files/names.h"

#include <QTest>

#include "tests/support/suite.h"

namespace sline::cli {

class NamesTest : public QObject {
  Q_OBJECT

 private slots:
  void near_data();
  void near();
  void unknownNamesTheNear();
  void namesInAnyLanguage_data();
  void namesInAnyLanguage();
};

void NamesTest::near_data() {
  QTest::addColumn<QString>("wanted");
  QTest::addColumn<QString>("found");
  QTest::newRow("typing error") << "livr"
                                << "liver";
  QTest::newRow("swapped letters") << "spelen"
                                   << "spleen";
  QTest::newRow("part of two") << "kidney"
                               << "left kidney,right_kidney";
  QTest::newRow("longer than the name") << "the liver"
                                        << "liver";
  QTest::newRow("case and dash") << "RIGHT-KIDNY"
                                 << "right_kidney";
  QTest::newRow("far from all") << "femur"
                                << "";
  QTest::newRow("empty") << ""
                         << "";
}

void NamesTest::near() {
  QFETCH(QString, wanted);
  QFETCH(QString, found);
  const std::vector<std::string> names{"right_kidney", "liver",           "left kidney",
                                       "spleen",       "abdominal aorta", "liver"};
  QStringList list;
  for (const std::string& name : nearNames(wanted.toStdString(), names))
    list << QString::fromStdString(name);
  QCOMPARE(list.join(','), found);
}

void NamesTest::unknownNamesTheNear() {
  model::Scene scene;
  model::Node node;
  node.name = "Liver";
  scene.append(node);
  QVERIFY(nodesNamed(scene, "LIVER").ok());
  const auto wrong = nodesNamed(scene, "lver");
  QVERIFY(!wrong.ok());
  QVERIFY(wrong.error().text().find("\"Liver\"") != std::string::npos);
}

void NamesTest::namesInAnyLanguage_data() {
  QTest::addColumn<QString>("wanted");
  QTest::addColumn<QString>("found");
  QTest::newRow("its own name first") << "bladder"
                                      << "Bladder";
  QTest::newRow("a synonym") << "urinary bladder"
                             << "Bladder";
  QTest::newRow("German") << "linke Niere"
                          << "kidney_left";
  QTest::newRow("Latin") << "REN DEXTER"
                         << "Right kidney";
  QTest::newRow("no side is not both") << "kidney"
                                       << "";
  QTest::newRow("not there") << "left femur"
                             << "";
}

void NamesTest::namesInAnyLanguage() {
  QFETCH(QString, wanted);
  QFETCH(QString, found);
  model::Scene scene;
  for (const char* name : {"Bladder", "kidney_left", "Right kidney", "label 7"}) {
    model::Node node;
    node.name = name;
    scene.append(node);
  }
  QStringList names;
  if (const auto ids = nodesNamed(scene, wanted.toStdString()); ids.ok())
    for (const model::NodeId id : *ids)
      names << QString::fromStdString(scene.find(id)->name);
  QCOMPARE(names.join(','), found);
}

}  // namespace sline::cli

SLINE_TEST(sline::cli::NamesTest)
#include "names_test.moc"
