// SPDX-License-Identifier: Apache-2.0
// Asks a list of two thousand anatomical names, which says itself of what kind each is, whether the
// program's table takes them for the same (METHOD §12, proof).
#include <QFile>
#include <QHash>
#include <QSet>
#include <QTest>
#include <algorithm>

#include "model/anatomy/body_systems.h"
#include "tests/support/suite.h"

namespace sline::model {

class TerminologyTissuesTest : public QObject {
  Q_OBJECT

  static QList<QStringList> rows(const char* name) {
    QFile file(QStringLiteral(SLINE_TEST_DATA "/terminology/bodyparts3d/") + name);
    QList<QStringList> rows;
    if (!file.open(QIODevice::ReadOnly))
      return rows;
    file.readLine();  // headings
    while (!file.atEnd())
      rows << QString::fromUtf8(file.readLine()).trimmed().split('\t');
    return rows;
  }

  /// Returns the tissue of the concepts that are kinds of this one.
  static Tissue tissueOf(const QString& kind) {
    static const QHash<QString, Tissue> kinds{{"segment of arterial tree organ", Tissue::vessel},
                                              {"segment of venous tree organ", Tissue::vessel},
                                              {"muscle organ", Tissue::muscle},
                                              {"zone of muscle organ", Tissue::muscle},
                                              {"bone organ", Tissue::bone},
                                              {"cartilage organ", Tissue::joint},
                                              {"ligament organ", Tissue::joint},
                                              {"segment of neural tree organ", Tissue::nerve},
                                              {"segment of neuraxis", Tissue::organ},
                                              {"segment of tracheobronchial tree", Tissue::organ},
                                              {"tooth", Tissue::bone},  // as which it is drawn
                                              {"pulmonary venous tree organ", Tissue::vessel},
                                              {"zone of small intestine", Tissue::organ},
                                              {"zone of large intestine", Tissue::organ},
                                              {"parenchymatous organ", Tissue::organ},
                                              {"organ with organ cavity", Tissue::organ}};
    return kinds.value(kind, Tissue::unknown);
  }

 private slots:
  void namesHaveTheTissueOfTheirKind() {
    QHash<QString, QStringList> above;
    QHash<QString, QString> names;
    for (const QStringList& row : rows("isa_inclusion_relation_list.txt")) {
      above[row.at(2)] << row.at(0);
      names[row.at(0)] = row.at(1);
    }
    const QList<QStringList> listed = rows("fj_element_names.tsv");
    if (above.isEmpty() || listed.isEmpty())
      SLINE_ABSENT("the terminology is not there");
    const AnatomyTable table;
    QSet<QString> seen;
    int right = 0;
    QStringList wrong;
    for (const QStringList& row : listed) {
      const QString& name = row.at(2);
      if (seen.contains(name))
        continue;
      seen << name;
      Tissue told = Tissue::unknown;
      QStringList concepts{row.at(1)};
      for (qsizetype i = 0; i < concepts.size() && told == Tissue::unknown; ++i) {
        told = tissueOf(names.value(concepts[i]));
        concepts << above.value(concepts[i]);
      }
      if (told == Tissue::unknown)
        continue;
      const auto match = table.match(name.toStdString());
      const Tissue found = match ? table.systems()[match->system].tissue : Tissue::unknown;
      if (found == told)
        ++right;
      else
        wrong << name + ": " + tissueNames[std::size_t(found)].data() + ", not " +
                     tissueNames[std::size_t(told)].data();
    }
    const double share = double(right) / double(right + wrong.size());
    qInfo("%d of %d names, %.1f %%", right, int(right + wrong.size()), 100.0 * share);
    QVERIFY(right > 1000);
    QVERIFY2(share >= 0.97, qPrintable(wrong.join('\n')));
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::TerminologyTissuesTest)
#include "terminology_tissues_test.moc"
