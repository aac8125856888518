// SPDX-License-Identifier: Apache-2.0
// Tests what of a file's name may be shown: words of anatomy and of the program, no person's.
#include <QFile>
#include <QTest>

#include "model/anatomy/shown_names.h"
#include "tests/support/suite.h"

using namespace sline::model;

class ShownNamesTest : public QObject {
  Q_OBJECT
 private slots:
  void names_data() {
    QTest::addColumn<QString>("shown");
    const std::pair<const char*, const char*> rows[] = {
        // What anatomy and the program know stays as it is.
        {"liver", "liver"},
        {"Rib6_left", "Rib6_left"},
        {"vertebrae_L3", "vertebrae_L3"},
        {"linke Niere", "linke Niere"},
        {"Leber", "Leber"},
        {"kidney cyst 2", "kidney cyst 2"},
        {"left_masseter", "left_masseter"},
        {"segmentation", "segmentation"},
        {"hepatovenous segment VIII", "hepatovenous segment VIII"},
        // Of others, what is known.
        {"Doe_Jane_liver", "liver"},
        {"liver-DOE^JANE", "liver"},
        {"DoeJane_left_kidney_v2", "left kidney v2"},
        // What else a name says of anatomy stays: a stone is no kidney.
        {"Doe kidney stone", "kidney stone"},
        {"mouse brain", "mouse brain"},
        {"4711_kidney", "kidney"},
        {"19610203-tumour", "tumour"},
        {"Müller_Leber", "Leber"},
        {"a", "a"},
        {"a1 liver", "a1 liver"},
        {"left 12", "left 12"},
        {"ct_labels_3mm", "ct_labels_3mm"},
        // What turns the sense of a name round or tells it from others stays.
        {"Liver_without_tumor", "Liver_without_tumor"},
        {"No_tumor", "No_tumor"},
        {"Doe_non_tumor_liver", "non tumor liver"},
        {"Leber_ohne_Tumor", "Leber_ohne_Tumor"},
        {"Suspected_tumor", "Suspected_tumor"},
        {"Kidney_R_not_visible", "Kidney_R_not_visible"},
        {"Contralateral_breast", "Contralateral_breast"},
        {"Nerve_preserved", "Nerve_preserved"},
        {"Bladder_PRV05", "Bladder_PRV05"},
        {"Lung_L-ITV", "Lung_L-ITV"},
        {"Doe_Liver-GTV", "Liver-GTV"},
        {"PTV_High_6000", "PTV_High_6000"},
        {"PTV_Low_5000cGy", "PTV_Low_5000cGy"},
        {"PTV_1961", "PTV"},
        {"Low_Jane_liver", "liver"},
        {"OpticNrv_R_PRV03", "OpticNrv_R_PRV03"},
        {"vermis 4 5", "vermis 4 5"},
        {"organs at risk", "organs at risk"},
        // Three numbers are a date of birth, and margins where all are one.
        {"liver 3 2 61", "liver 3 2"},
        {"Expanded_5_5_5_Bladder", "Expanded_5_5_5_Bladder"},
        {"PTV_10_10_10", "PTV_10_10_10"},
        {"liver 10 10 10", "liver 10 10"},
        {"liver 05 05 05", "liver 05 05"},
        // A number with a letter is a part's, a level's or a segment's.
        {"liver segment 4a", "liver segment 4a"},
        {"segment_8b", "segment_8b"},
        {"segment_IVa", "segment_IVa"},
        {"segment iva", "segment iva"},
        {"Doe_VIIb_vermis", "VIIb vermis"},
        {"Cerebellum_7b_L", "Cerebellum_7b_L"},
        {"GTV_7b", "GTV_7b"},
        {"C7b", "C7b"},
        {"nerve C7b", "nerve C7b"},
        {"Th12", "Th12"},
        {"T12 vertebra", "T12 vertebra"},
        {"L5", "L5"},
        {"S1", "S1"},
        {"Met_1", "Met_1"},
        {"HCC_S7", "HCC_S7"},
        {"Xia_liver", "liver"},
        {"Iva liver", "liver"},
        {"liver 1961b", "liver"},
        {"P4711a liver", "liver"},
        {"liver 12Mar61", "liver"},
        // A counter of the program's own.
        {"liver segment (no. 2)", "liver segment (no. 2)"},
        // Sides as they are abbreviated, which elsewhere are persons' names.
        {"Niere_li", "Niere_li"},
        {"Niere re.", "Niere re."},
        {"re Lunge", "re Lunge"},
        {"Niere_Li", "Niere_Li"},
        {"Niere_lks_2", "Niere_lks_2"},
        {"kidney_li", "kidney_li"},
        {"Nyre ve", "Nyre ve"},
        {"nyre_hø", "nyre_hø"},
        {"ren sin", "ren sin"},
        {"femur_dx", "femur_dx"},
        {"Doe_Niere_li", "Niere"},
        {"Li_liver", "liver"},
        {"liver_Li", "liver"},
        {"Wei_Li_liver", "liver"},
        {"Re", ""},
        // Umlauts as they are written without.
        {"Hueftbein_li", "Hueftbein_li"},
        {"Huefte rechts", "Huefte rechts"},
        {"Koerper", "Koerper"},
        {"Milchdruese li", "Milchdruese li"},
        // What cells are made of.
        {"mitochondria", "mitochondria"},
        {"chromosome 7", "chromosome 7"},
        {"golgi", "golgi"},
        {"soma", "soma"},
        {"endoplasmic reticulum", "endoplasmic reticulum"},
        {"Doe_lysosome_3", "lysosome 3"},
        {"dendritic spines", "dendritic spines"},
        // What is left of a person's name besides numbers, sides and letters is nothing.
        {"Doe_Jane", ""},
        {"DOE JANE 12 L", ""},
        {"P0004711", ""},
        {"1961", ""},
        {"19610203mm", ""},
        {"", ""},
        {"---", ""},
    };
    for (const auto& [name, shown] : rows)
      QTest::newRow(name) << QString::fromUtf8(shown);
  }
  void names() {
    QFETCH(QString, shown);
    QCOMPARE(QString::fromStdString(shownName(QTest::currentDataTag())), shown);
    // What is shown may be shown.
    QCOMPARE(shownName(shown.toStdString()), shown.toStdString());
  }

  void cellsAreShown() {
    for (const char* name :
         {"mitochondrion",    "lysosome", "axon",      "synapse",    "cilium",
          "endosome",         "vacuole",  "nucleolus", "cytoplasm",  "membrane",
          "vesicle",          "dendrite", "ribosome",  "peroxisome", "cell membrane",
          "nuclear envelope", "neurons",  "astrocyte", "centriole",  "cilia"})
      QCOMPARE(shownName(name), std::string(name));
  }

  void whatIsLeftOut() {
    QCOMPARE(wordsNotShown("Meier_Hans_liver"), (std::vector<std::string>{"Meier", "Hans"}));
    QCOMPARE(wordsNotShown("Doe_1961"), (std::vector<std::string>{"Doe", "1961"}));
    QCOMPARE(wordsNotShown("Niere_li"), std::vector<std::string>());
    QCOMPARE(wordsNotShown("liver segment 4a"), std::vector<std::string>());
  }

  /// What anatomists call things is no person's name.
  void anatomyIsShown() {
    QFile list(QStringLiteral(SLINE_TEST_DATA "/terminology/bodyparts3d/fj_element_names.tsv"));
    if (!list.open(QIODevice::ReadOnly))
      SLINE_ABSENT("the terminology is not there");
    list.readLine();  // headings
    QStringList hidden;
    int count = 0;
    while (!list.atEnd()) {
      const std::string name = list.readLine().trimmed().split('\t').at(2).toStdString();
      ++count;
      if (shownName(name) != name)
        hidden << QString::fromStdString(name);
    }
    qInfo("%d of %d names are shown whole", count - int(hidden.size()), count);
    QVERIFY(count > 2000);
    QVERIFY2(hidden.size() < count / 50, qPrintable(hidden.join('\n')));
  }
};

SLINE_TEST(ShownNamesTest)
#include "shown_names_test.moc"
