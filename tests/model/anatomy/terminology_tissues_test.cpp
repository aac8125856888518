// SPDX-License-Identifier: Apache-2.0
// Asks lists of thousands of anatomical names, which say themselves of what kind each is, whether
// the program's table takes them for the same (METHOD §12, proof): by what a concept is a kind of,
// by the file in which a structure stands, by the noun of its name.
#include <QFile>
#include <QHash>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSet>
#include <QTest>
#include <algorithm>

#include "model/anatomy/body_systems.h"
#include "model/anatomy/name_words.h"
#include "tests/support/suite.h"

namespace sline::model {

namespace {

QByteArray table(const char* name) {
  QFile file(QStringLiteral(SLINE_TEST_DATA "/terminology/") + name);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QList<QStringList> rows(const char* name, QChar separator = '\t') {
  QList<QStringList> rows;
  for (const QString& line : QString::fromUtf8(table(name)).split('\n', Qt::SkipEmptyParts))
    rows << line.trimmed().split(separator);
  if (!rows.isEmpty())
    rows.removeFirst();  // headings
  return rows;
}

/// Returns the tissue of the concepts that are kinds of this one.
Tissue tissueOfConcept(const QString& kind) {
  static const QHash<QString, Tissue> kinds{{"segment of arterial tree organ", Tissue::vessel},
                                            {"segment of venous tree organ", Tissue::vessel},
                                            {"pulmonary venous tree organ", Tissue::vessel},
                                            {"region of vascular tree organ", Tissue::vessel},
                                            {"set of arteries", Tissue::vessel},
                                            {"set of veins", Tissue::vessel},
                                            {"muscle organ", Tissue::muscle},
                                            {"zone of muscle organ", Tissue::muscle},
                                            {"musculature", Tissue::muscle},
                                            {"bone organ", Tissue::bone},
                                            {"zone of bone organ", Tissue::bone},
                                            {"cartilage organ", Tissue::joint},
                                            {"ligament organ", Tissue::joint},
                                            {"segment of neural tree organ", Tissue::nerve},
                                            {"segment of neuraxis", Tissue::organ},
                                            {"cell part cluster of neuraxis", Tissue::organ},
                                            {"segment of tracheobronchial tree", Tissue::organ},
                                            {"tooth", Tissue::bone},  // as which it is drawn
                                            {"zone of small intestine", Tissue::organ},
                                            {"zone of large intestine", Tissue::organ},
                                            {"parenchymatous organ", Tissue::organ},
                                            {"organ with organ cavity", Tissue::organ}};
  return kinds.value(kind, Tissue::unknown);
}

/// Returns the tissue that the noun says; unknown for words that say none.
Tissue tissueOfNoun(const std::string& word) {
  static const std::map<Tissue, std::set<std::string>> nouns{
      {Tissue::vessel, {"artery", "vein", "aorta", "vena", "arteriole", "venule", "vessel"}},
      {Tissue::nerve, {"nerve"}},
      {Tissue::muscle, {"muscle", "gluteus", "iliopsoas", "autochthon"}},
      {Tissue::bone,
       {"bone",  "vertebra", "rib",     "femur",   "humerus",  "scapula", "clavicle", "clavicula",
        "hip",   "sacrum",   "sternum", "skull",   "mandible", "maxilla", "skeleton", "patella",
        "tibia", "fibula",   "ilium",   "ischium", "pubis",    "coccyx",  "tooth"}},
      {Tissue::joint, {"ligament", "cartilage", "disc", "meniscus", "tendon"}},
      {Tissue::organ,
       {"ventricle", "nucleus", "gyrus", "lobe",     "kidney",    "liver",  "lung",    "heart",
        "spleen",    "brain",   "colon", "duodenum", "esophagus", "atrium", "stomach", "bladder",
        "prostate",  "uterus",  "ovary", "trachea",  "bronchus",  "gland",  "valve",   "pancreas"}},
      {Tissue::lesion, {"cyst", "tumour", "tumor"}},
      {Tissue::skin, {"skin", "fat"}}};
  for (const auto& [tissue, words] : nouns)
    if (words.contains(word))
      return tissue;
  return Tissue::unknown;
}

/// Returns what the name itself says: the last noun before "of", sides and numbers aside.
Tissue saidByName(const QString& name) {
  std::vector<std::string> words = nameWords(name.toStdString());
  words.erase(std::find(words.begin(), words.end(), "of"), words.end());
  Tissue said = Tissue::unknown;
  for (const std::string& word : words)
    if (const Tissue here = tissueOfNoun(word); here != Tissue::unknown)
      said = here;
  return said;
}

/// Counts how many names have the tissue that a list says.
class Score {
 public:
  void ask(const QString& name, Tissue told) {
    if (told == Tissue::unknown || m_seen.contains(name))
      return;
    m_seen << name;
    static const AnatomyTable names;
    const auto match = names.match(name.toStdString());
    const Tissue found = match ? names.systems()[match->system].tissue : Tissue::unknown;
    if (found == told)
      ++m_right;
    else
      m_wrong << name + ": " + tissueNames[std::size_t(found)].data() + ", not " +
                     tissueNames[std::size_t(told)].data();
  }
  int asked() const { return m_right + int(m_wrong.size()); }
  double share() const { return double(m_right) / std::max(1, asked()); }
  const QStringList& wrong() const { return m_wrong; }

 private:
  QSet<QString> m_seen;
  int m_right = 0;
  QStringList m_wrong;
};

/// Asks the names of BodyParts3D, each by the nearest concept of a known kind that it is one of.
void askBodyParts(Score& score) {
  QHash<QString, QStringList> above;
  QHash<QString, QString> names;
  for (const QStringList& row : rows("bodyparts3d/isa_inclusion_relation_list.txt")) {
    above[row.at(2)] << row.at(0);
    names[row.at(0)] = row.at(1);
    names[row.at(2)] = row.at(3);
  }
  QList<std::pair<QString, QString>> asked;
  for (const QStringList& row : rows("bodyparts3d/fj_element_names.tsv"))
    asked << std::pair(row.at(1), row.at(2));
  for (const QStringList& row : rows("bodyparts3d/partof_inclusion_relation_list.txt"))
    asked << std::pair(row.at(2), row.at(3));
  for (auto each = names.constBegin(); each != names.constEnd(); ++each)
    asked << std::pair(each.key(), each.value());
  for (const auto& [id, name] : asked) {
    Tissue told = Tissue::unknown;
    QStringList concepts{id};
    for (qsizetype i = 0; i < concepts.size() && told == Tissue::unknown; ++i) {
      told = tissueOfConcept(names.value(concepts[i]));
      concepts << above.value(concepts[i]);
    }
    score.ask(name, told);
  }
}

/// Asks the labels of the reference organs: by their noun, else by the organ whose file has them.
void askReferenceOrgans(Score& score) {
  const QList<std::pair<QString, Tissue>> files{{"blood_vasculature", Tissue::vessel},
                                                {"vertebrae", Tissue::bone},
                                                {"spinal_cord", Tissue::organ},
                                                {"allen_", Tissue::organ}};
  for (const QStringList& row : rows("hra/asct-b-3d-models-mapping_v1.3.csv", ',')) {
    if (row.size() < 7 || row.at(3).trimmed() == "-" || row.at(6).trimmed() == "-")
      continue;
    Tissue told = saidByName(row.at(3));
    for (const auto& [part, tissue] : files)
      if (told == Tissue::unknown && row.at(6).contains(part, Qt::CaseInsensitive))
        told = tissue;
    score.ask(row.at(3), told);
  }
}

void askSegmenters(Score& score) {
  for (const QStringList& row : rows("totalsegmentator/class_names.tsv"))
    score.ask(row.at(2), saidByName(row.at(2)));
  for (const QStringList& row : rows("slicer/GenericAnatomyColors.txt", ' '))
    if (row.size() == 6)
      score.ask(row.at(1), saidByName(row.at(1)));
  const QJsonObject codes =
      QJsonDocument::fromJson(
          table("slicer/SegmentationCategoryTypeModifier-SlicerGeneralAnatomy.json"))
          .object()["SegmentationCodes"]
          .toObject();
  for (const QJsonValue category : codes["Category"].toArray())
    for (const QJsonValue type : category["Type"].toArray()) {
      const QString name = type["CodeMeaning"].toString();
      score.ask(name, saidByName(name));
    }
}

}  // namespace

class TerminologyTissuesTest : public QObject {
  Q_OBJECT
 private slots:
  void namesHaveTheTissueOfTheirKind_data() {
    QTest::addColumn<int>("list");
    QTest::addColumn<int>("least");
    QTest::newRow("BodyParts3D") << 0 << 3500;
    QTest::newRow("reference organs") << 1 << 350;
    QTest::newRow("segmenters") << 2 << 200;
  }
  void namesHaveTheTissueOfTheirKind() {
    QFETCH(int, list);
    QFETCH(int, least);
    if (table("README.txt").isEmpty())
      SLINE_ABSENT("the terminology is not there");
    Score score;
    const std::array ask{askBodyParts, askReferenceOrgans, askSegmenters};
    ask[std::size_t(list)](score);
    qInfo("%d names, %.2f %% right", score.asked(), 100.0 * score.share());
    for (const QString& wrong : score.wrong())
      qInfo("%s", qPrintable(wrong));
    QVERIFY(score.asked() >= least);
    QVERIFY2(score.share() >= 0.97, qPrintable(score.wrong().join('\n')));
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::TerminologyTissuesTest)
#include "terminology_tissues_test.moc"
