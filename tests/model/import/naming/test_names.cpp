// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include "model/import/naming/names.h"
#include "tests/support/suite.h"

using namespace sline::model;

class NamesTest : public QObject {
  Q_OBJECT
 private slots:
  void readable_data();
  void readable();
  void inFile_data();
  void inFile();
  void words_data();
  void words();
  void sides_data();
  void sides();
  void unique();
  void toldApart();
};

void NamesTest::readable_data() {
  QTest::addColumn<QString>("stem");
  QTest::addColumn<QString>("name");
  QTest::newRow("BodyParts3D") << "FJ3152_FMA16586_right_hip_bone"
                               << "right hip bone";
  QTest::newRow("mirrored element") << "FJ1426M_FMA22325_left_obturator"
                                    << "left obturator";
  QTest::newRow("Slicer model") << "Model_51_right_kidney"
                                << "right kidney";
  QTest::newRow("Visible Human") << "VH_M_Liver"
                                 << "Liver";
  QTest::newRow("printed Visible Human") << "3d-vh-m-main-bronchus"
                                         << "main-bronchus";
  QTest::newRow("number in front") << "007_aorta"
                                   << "aorta";
  QTest::newRow("plain") << "liver"
                         << "liver";
  QTest::newRow("only an id") << "FJ3152"
                              << "FJ3152";
  QTest::newRow("only numbers") << "Model_12"
                                << "Model 12";
  QTest::newRow("hyphens stay") << "Model_551_Sacrum-L5-IntervertebralDisc"
                                << "Sacrum-L5-IntervertebralDisc";
  QTest::newRow("number behind") << "rib_7"
                                 << "rib 7";
  QTest::newRow("spaces collapse") << "left__renal _vein_"
                                   << "left renal vein";
  QTest::newRow("word that starts like an id") << "fmaple"
                                               << "fmaple";
}

void NamesTest::readable() {
  QFETCH(QString, stem);
  QFETCH(QString, name);
  QCOMPARE(QString::fromStdString(readableName(stem.toStdString())), name);
}

void NamesTest::inFile_data() {
  QTest::addColumn<QString>("given");
  QTest::addColumn<QString>("name");
  QTest::newRow("group") << "left_kidney"
                         << "left kidney";
  QTest::newRow("id") << "VH_M_ureter_L"
                      << "ureter L";
  QTest::newRow("program's signature") << "Visualization Toolkit generated SLA File"
                                       << "";
  QTest::newRow("nothing") << ""
                           << "";
}

void NamesTest::inFile() {
  QFETCH(QString, given);
  QFETCH(QString, name);
  QCOMPARE(QString::fromStdString(nameInFile(given.toStdString())), name);
}

void NamesTest::words_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("words");
  QTest::newRow("underscores") << "left_renal-Vein"
                               << "left renal vein";
  QTest::newRow("camel case") << "IntervertebralDisc"
                              << "intervertebral disc";
  QTest::newRow("spelling") << "intervertebral disk"
                            << "intervertebral disc";
  QTest::newRow("number apart") << "Rib6"
                                << "rib 6";
  QTest::newRow("level together") << "L5-L4"
                                  << "l5 l4";
  QTest::newRow("plural") << "iliac arteries"
                          << "iliac artery";
  QTest::newRow("no plural") << "psoas abdominis pelvis"
                             << "psoas abdominis pelvis";
  QTest::newRow("Latin plural") << "vertebrae"
                                << "vertebra";
}

void NamesTest::words() {
  QFETCH(QString, name);
  QFETCH(QString, words);
  QStringList list;
  for (const std::string& word : nameWords(name.toStdString()))
    list << QString::fromStdString(word);
  QCOMPARE(list.join(' '), words);
}

void NamesTest::sides_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<int>("side");
  QTest::addColumn<QString>("rest");
  QTest::newRow("left") << "left kidney" << int(Side::left) << "kidney";
  QTest::newRow("behind") << "kidney_right" << int(Side::right) << "kidney";
  QTest::newRow("letter") << "VH_M_ureter_L" << int(Side::left) << "vh m ureter";
  QTest::newRow("short") << "Rt Lung" << int(Side::right) << "lung";
  QTest::newRow("German") << "Amygdala links" << int(Side::left) << "amygdala";
  QTest::newRow("German adjective") << "rechte Niere" << int(Side::right) << "niere";
  QTest::newRow("Norwegian") << "høyre nyre" << int(Side::right) << "nyre";
  QTest::newRow("Latin") << "Ureter_sinister" << int(Side::left) << "ureter";
  QTest::newRow("German, short") << "Niere_li" << int(Side::left) << "niere";
  QTest::newRow("Dutch, short, before it") << "re. nier" << int(Side::right) << "nier";
  QTest::newRow("Norwegian, short") << "nyre_hø" << int(Side::right) << "nyre";
  QTest::newRow("Latin, short") << "ren sin." << int(Side::left) << "ren";
  QTest::newRow("short, with a number") << "Niere_li_2" << int(Side::left) << "niere 2";
  QTest::newRow("a person in the midst") << "Wei Li liver" << int(Side::none) << "wei li liver";
  QTest::newRow("level is no side") << "L5" << int(Side::none) << "l5";
  QTest::newRow("inside a word") << "cleft palate" << int(Side::none) << "cleft palate";
  QTest::newRow("the first counts")
      << "left duct of right lobe" << int(Side::left) << "duct of right lobe";
}

void NamesTest::sides() {
  QFETCH(QString, name);
  QFETCH(int, side);
  QFETCH(QString, rest);
  const SidedName result = sidedName(name.toStdString());
  QCOMPARE(int(result.side), side);
  QCOMPARE(QString::fromStdString(result.rest), rest);
}

void NamesTest::unique() {
  std::vector<std::string> names{"rib", "Rib", "rib 2", "aorta", "rib"};
  makeUnique(names);
  QCOMPARE(names, (std::vector<std::string>{"rib", "Rib 3", "rib 2", "aorta", "rib 4"}));
}

/// A number that tells names apart is not read as anatomy's, or as one that the file had.
void NamesTest::toldApart() {
  std::vector<std::string> names{"rib", "Rib", "rib 2", "tumour", "tumour", "kidney", "kidney"};
  tellApart(names, {false, false, false, true, false, false, false});
  QCOMPARE(names, (std::vector<std::string>{"rib", "Rib (no. 2)", "rib 2", "tumour",
                                            "tumour (no. 2)", "kidney", "kidney 2"}));
  names = {"liver segment", "liver segment", "liver segment (no. 2)"};
  tellApart(names, {true, true, true});
  QCOMPARE(names, (std::vector<std::string>{"liver segment", "liver segment (no. 3)",
                                            "liver segment (no. 2)"}));
  QCOMPARE(sidedName("left kidney (no. 2)").rest, std::string("kidney"));
}

SLINE_TEST(NamesTest)
#include "test_names.moc"
