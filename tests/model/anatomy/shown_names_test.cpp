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
        // Three numbers are a date of birth.
        {"liver 3 2 61", "liver 3 2"},
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
