// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include "model/anatomy/cut_patterns.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

class CutPatternsTest : public QObject {
  Q_OBJECT
 private slots:
  void tableIsWhole();
  void patterns_data();
  void patterns();
  void brokenRowsAreLeftOut();
};

void CutPatternsTest::tableIsWhole() {
  const CutPatternTable table;
  QCOMPARE(table.badRows(), std::size_t(0));
  for (std::size_t i = 0; i < tissueNames.size(); ++i)
    QVERIFY2(table.covers(Tissue(i)), std::string(tissueNames[i]).c_str());
  for (std::size_t i = 0; i < cutPatternNames.size(); ++i)
    QCOMPARE(cutPatternNamed(cutPatternNames[i]), std::optional(CutPattern(i)));
}

void CutPatternsTest::patterns_data() {
  QTest::addColumn<QString>("pattern");
  const std::pair<const char*, const char*> rows[] = {
      {"femur", "spongy"},
      // Margins that a plan draws, a cavity, stones and implants are no tissue.
      {"PTV", "plain"},
      {"GTV", "crossed"},
      {"Tumor Bed", "plain"},
      {"Kidney stone", "plain"},
      {"Heart prosthesis", "plain"},
      {"Bone marrow nail", "plain"},
      {"Liver-GTV", "stipple"},
      {"L3 vertebra", "spongy"},
      {"gluteus_maximus_left", "fibres"},
      {"inguinal ligament", "fibres"},
      {"Heart", "fibres"},
      {"left atrium", "wall"},
      {"abdominal aorta", "wall"},
      {"right common iliac vein", "wall"},
      {"sigmoid colon", "wall"},
      {"stomach and duodenum", "wall"},
      {"urinary_bladder", "wall"},
      {"gallbladder", "wall"},
      {"left kidney", "stipple"},
      {"liver", "stipple"},
      {"hepatic flexure of colon", "wall"},
      {"pancreas", "stipple"},
      {"spleen", "stipple"},
      {"prostate", "stipple"},
      {"subcutaneous fat", "cells"},
      {"Skin", "rim"},
      {"body", "rim"},
      {"skin of thoracic wall", "rim"},
      {"perirenal fat", "cells"},
      {"adipose tissue", "cells"},
      {"left cerebral white matter", "plain"},
      {"corpus callosum", "plain"},
      {"internal capsule", "plain"},
      {"left cerebral cortex", "stipple"},
      {"grey matter", "stipple"},
      {"thalamus", "stipple"},
      {"cerebral aqueduct", "waterlines"},
      {"carotid", "wall"},
      {"hepatic vessels", "wall"},
      {"scrotum", "wall"},
      {"mesorectum", "cells"},
      {"intervertebral disc L4-L5", "lamellae"},
      {"costal cartilage", "lacunae"},
      {"sciatic nerve", "fascicles"},
      {"tumour", "crossed"},
      {"kidney cyst", "waterlines"},
      {"left lateral ventricle", "waterlines"},
      {"CSF", "waterlines"},
      {"segment 7 of something", ""},
  };
  for (const auto& [name, pattern] : rows)
    QTest::newRow(name) << QString(pattern);
}

void CutPatternsTest::patterns() {
  QFETCH(QString, pattern);
  static const CutPatternTable table;
  const auto found = table.match(QTest::currentDataTag());
  QCOMPARE(found ? QString::fromUtf8(cutPatternNames[std::size_t(*found)].data()) : QString(),
           pattern);
}

void CutPatternsTest::brokenRowsAreLeftOut() {
  const CutPatternTable table(
      "# a comment\n"
      "bone\t\tspongy\n"
      "bone\t\tplain\n"       // said twice
      "stone\t\tplain\n"      // no tissue
      "muscle\t\tchequers\n"  // no pattern
      "muscle\tfibres\n"      // a field is missing
      "bone\t12\tplain\n"     // a number alone is no word of a name
      "muscle\ttongue\tfibres\n");
  QVERIFY(table.badRows() >= 4);
  QVERIFY(table.covers(Tissue::bone));
  QVERIFY(!table.covers(Tissue::muscle));
  QCOMPARE(table.match("femur"), std::optional(CutPattern::spongy));
  QVERIFY(!table.match("gluteus maximus"));
}

SLINE_TEST(CutPatternsTest)
#include "cut_patterns_test.moc"
