// SPDX-License-Identifier: Apache-2.0
// Tests names as files have them, and the names made of them in each language.
#include <QDir>
#include <QFile>
#include <QtTest>
#include <algorithm>

#include "model/anatomy/anatomical_names.h"
#include "tests/support/suite.h"

using namespace sline::model;

class AnatomicalNamesTest : public QObject {
  Q_OBJECT

  AnatomicalNames m_names;

  QString shown(const QString& name, NameLanguage language) const {
    return QString::fromStdString(m_names.displayName(name.toStdString(), language));
  }
  bool knows(const std::string& name) const { return m_names.searchWords(name).size() > 1; }

 private slots:
  void tagsOfLanguages();
  void display_data();
  void display();
  void unknownStaysAsItIs_data();
  void unknownStaysAsItIs();
  void sidesAreNeverSwapped();
  void languagesReadEachOther();
  void search();
  void knowsWhatSegmentationNames();
  void knowsTheAtlas();
  void knowsThePelvis();
  void knowsTheDemos_data();
  void knowsTheDemos();
};

void AnatomicalNamesTest::tagsOfLanguages() {
  for (std::size_t i = 0; i < nameLanguages; ++i)
    QVERIFY(nameLanguageOf(nameLanguageTags[i]) == NameLanguage(i));
  QVERIFY(nameLanguageOf("de-AT") == NameLanguage::german);
  QVERIFY(nameLanguageOf("no") == NameLanguage::norwegian);
  QVERIFY(!nameLanguageOf("fr") && !nameLanguageOf("") && !nameLanguageOf("deu"));
}

void AnatomicalNamesTest::display_data() {
  QTest::addColumn<QStringList>("shown");  // English, Latin, German, Dutch, Norwegian
  const auto row = [](const char* name, const QStringList& shown) { QTest::newRow(name) << shown; };
  row("kidney_left", {"left kidney", "ren sinister", "linke Niere", "linker nier", "venstre nyre"});
  row("Right Kidney", {"Right kidney", "Ren dexter", "Rechte Niere", "Rechter nier", "Høyre nyre"});
  row("left ovary", {"left ovary", "ovarium sinistrum", "linker Eierstock", "linker eierstok",
                     "venstre eggstokk"});
  row("scapula r.", {"right scapula", "scapula dextra", "rechtes Schulterblatt",
                     "rechter schouderblad", "høyre skulderblad"});
  // A counter of the program's own is no number of anatomy's.
  row("kidney (no. 2)",
      {"kidney (no. 2)", "ren (no. 2)", "Niere (Nr. 2)", "nier (nr. 2)", "nyre (nr. 2)"});
  row("liver segment (no. 2)",
      {"liver segment (no. 2)", "liver segment (no. 2)", "liver segment (no. 2)",
       "liver segment (no. 2)", "liver segment (no. 2)"});
  // Sides in short, and umlauts written as two letters.
  row("Niere_li", {"Left kidney", "Ren sinister", "Linke Niere", "Linker nier", "Venstre nyre"});
  row("Hueftbein re.", {"Right hip bone", "Os coxae dextrum", "Rechtes Hüftbein",
                        "Rechter heupbeen", "Høyre hoftebein"});
  // Groups of atlases.
  row("Muscular",
      {"Muscular system", "Systema musculare", "Muskelsystem", "Spierstelsel", "Muskelsystem"});
  row("Venous", {"Venous system", "Systema venosum", "Venensystem", "Aderstelsel", "Venesystem"});
  row("GI", {"gastrointestinal tract", "tractus gastrointestinalis", "Magen-Darm-Trakt",
             "maag-darmkanaal", "mage-tarm-kanal"});
  row("Vascular System",
      {"Vascular system", "Systema vasculare", "Gefäßsystem", "Vaatstelsel", "Karsystem"});
  row("Pelvic Structures", {"Pelvic structures", "Structurae pelvis", "Beckenstrukturen",
                            "Bekkenstructuren", "Bekkenstrukturer"});
  row("ureter L", {"left ureter", "ureter sinister", "linker Harnleiter", "linker urineleider",
                   "venstre urinleder"});
  row("right_iliac_arteries",
      {"right iliac arteries", "arteriae iliacae dextrae", "rechte Beckenarterien",
       "rechter bekkenslagaders", "høyre bekkenarterier"});
  row("corpora cavernosa of penis",
      {"corpora cavernosa of penis", "corpora cavernosa penis", "Penisschwellkörper",
       "zwellichamen van de penis", "corpora cavernosa penis"});
  row("gluteus_maximus_left",
      {"left gluteus maximus", "musculus gluteus maximus sinister", "linker großer Gesäßmuskel",
       "linker grote bilspier", "venstre store setemuskel"});
  row("left gluteus medius muscle",
      {"left gluteus medius", "musculus gluteus medius sinister", "linker mittlerer Gesäßmuskel",
       "linker middelste bilspier", "venstre midtre setemuskel"});
  row("left gastric artery", {"left gastric artery", "arteria gastrica sinistra",
                              "linke Magenarterie", "linker maagslagader", "venstre magearterie"});
  row("lung_upper_lobe_left",
      {"upper lobe of left lung", "lobus superior pulmonis sinistri", "Oberlappen der linken Lunge",
       "bovenkwab van de linkerlong", "overlapp av venstre lunge"});
  row("rib_left_7", {"left rib 7", "costa VII sinistra", "linke 7. Rippe", "linker 7e rib",
                     "venstre 7. ribbein"});
  row("left twelfth rib", {"left rib 12", "costa XII sinistra", "linke 12. Rippe", "linker 12e rib",
                           "venstre 12. ribbein"});
  row("Rib6", {"Rib 6", "Costa VI", "6. Rippe", "6e rib", "6. ribbein"});
  row("L4", {"L4 vertebra", "vertebra lumbalis IV", "4. Lendenwirbel", "4e lendenwervel",
             "4. lendevirvel"});
  row("vertebrae_T12", {"T12 vertebra", "vertebra thoracica XII", "12. Brustwirbel",
                        "12e borstwervel", "12. brystvirvel"});
  row("Lumbar5", {"L5 vertebra", "Vertebra lumbalis V", "5. Lendenwirbel", "5e lendenwervel",
                  "5. lendevirvel"});
  row("fifth lumbar vertebra", {"L5 vertebra", "vertebra lumbalis V", "5. Lendenwirbel",
                                "5e lendenwervel", "5. lendevirvel"});
  row("vertebrae_S1", {"S1 vertebra", "vertebra sacralis I", "1. Kreuzbeinwirbel",
                       "1e heiligbeenwervel", "1. korsbeinsvirvel"});
  row("vertebrae", {"vertebrae", "vertebrae", "Wirbel", "wervels", "virvler"});
  row("hepatovenous segment VIII", {"liver segment VIII", "segmentum hepatis VIII",
                                    "Lebersegment VIII", "leversegment VIII", "leversegment VIII"});
  row("liver segment 4", {"liver segment IV", "segmentum hepatis IV", "Lebersegment IV",
                          "leversegment IV", "leversegment IV"});
  row("L4-L3-IntervertebralDisc",
      {"intervertebral disc L3–L4", "discus intervertebralis L3–L4", "Bandscheibe L3–L4",
       "tussenwervelschijf L3–L4", "mellomvirvelskive L3–L4"});
  row("Sacrum-L5-IntervertebralDisc",
      {"Intervertebral disc L5–S1", "Discus intervertebralis L5–S1", "Bandscheibe L5–S1",
       "Tussenwervelschijf L5–S1", "Mellomvirvelskive L5–S1"});
  row("L1-T12-IntervertebralDisc",
      {"intervertebral disc T12–L1", "discus intervertebralis T12–L1", "Bandscheibe T12–L1",
       "tussenwervelschijf T12–L1", "mellomvirvelskive T12–L1"});
  row("intervertebral_discs", {"intervertebral discs", "disci intervertebrales", "Bandscheiben",
                               "tussenwervelschijven", "mellomvirvelskiver"});
  row("minor calyx L a",
      {"left minor calyx a", "calyx renalis minor sinister a", "linker kleiner Nierenkelch a",
       "linker kleine nierkelk a", "venstre liten nyrekalk a"});
  row("left kidney 2",
      {"left kidney 2", "ren sinister 2", "linke Niere 2", "linker nier 2", "venstre nyre 2"});
  row("Arteries", {"Arteries", "Arteriae", "Arterien", "Slagaders", "Arterier"});
  row("renal pelvis of the left",
      {"left renal pelvis", "pelvis renalis sinistra", "linkes Nierenbecken", "linker nierbekken",
       "venstre nyrebekken"});
}

void AnatomicalNamesTest::display() {
  QFETCH(QStringList, shown);
  QStringList actual;
  for (std::size_t language = 0; language < nameLanguages; ++language)
    actual << this->shown(QString::fromUtf8(QTest::currentDataTag()), NameLanguage(language));
  QCOMPARE(actual, shown);
}

void AnatomicalNamesTest::unknownStaysAsItIs_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"", " ", "Segment_1", "foo bar", "left", "R", "rib 13", "rib 0", "T13",
                           "L4 L5", "L1-L5 disc", "left branch of right renal artery", "rib 3 4",
                           "<b>liver</b> x", "9", "#", "{", "liver segment IX", "linkes Rechteck"})
    QTest::newRow(name) << QString::fromUtf8(name);
}

void AnatomicalNamesTest::unknownStaysAsItIs() {
  QFETCH(QString, name);
  for (std::size_t language = 0; language < nameLanguages; ++language)
    QCOMPARE(shown(name, NameLanguage(language)), name);
  QCOMPARE(int(m_names.searchWords(name.toStdString()).size()), 1);
}

void AnatomicalNamesTest::sidesAreNeverSwapped() {
  // For each structure, each way to say a side and each language, that side's words appear and none
  // of the other's.
  const std::vector<std::pair<const char*, Side>> spellings{
      {"left %1", Side::left},    {"%1_left", Side::left},    {"%1 L", Side::left},
      {"Left %1", Side::left},    {"l. %1", Side::left},      {"%1 sinistra", Side::left},
      {"linke %1", Side::left},   {"venstre %1", Side::left}, {"right %1", Side::right},
      {"%1_right", Side::right},  {"%1 R", Side::right},      {"RIGHT %1", Side::right},
      {"%1 dexter", Side::right}, {"rechte %1", Side::right}, {"høyre %1", Side::right}};
  int pairs = 0;
  for (const NameRow& row : m_names.rows()) {
    const QString english = QString::fromStdString(withNumber(row.names[0], row.numbers ? 2 : 0));
    const bool ownSide =
        std::any_of(row.names.begin(), row.names.end(), [](const std::string& name) {
          const std::vector<std::string> words = wordsOf(name);
          return std::any_of(words.begin(), words.end(), [](const std::string& word) {
            return sideOfWord(word) != Side::none;
          });
        });
    if (ownSide)
      continue;
    for (const auto& [spelling, side] : spellings) {
      const QString name = QString::fromUtf8(spelling).arg(english);
      for (std::size_t language = 0; language < nameLanguages; ++language) {
        const QString text = shown(name, NameLanguage(language));
        std::vector<Side> said;
        for (const std::string& word : wordsOf(text.toStdString()))
          if (const Side here = sideOfWord(word); here != Side::none)
            said.push_back(here);
        QVERIFY2(said == std::vector<Side>{side}, qPrintable(name + " -> " + text));
        ++pairs;
      }
    }
  }
  QVERIFY(pairs > 25'000);
}

void AnatomicalNamesTest::languagesReadEachOther() {
  // A name shown in one language is understood when it comes back in a file.
  for (const NameRow& row : m_names.rows()) {
    const int number = row.numbers ? row.numbers->last : 0;
    const std::string english = withNumber(row.names[0], number);
    for (std::size_t from = 0; from < nameLanguages; ++from) {
      const std::string name = m_names.displayName(english, NameLanguage(from));
      for (std::size_t to = 0; to < nameLanguages; ++to)
        QVERIFY2(shown(QString::fromStdString(name), NameLanguage(to))
                         .compare(shown(QString::fromStdString(english), NameLanguage(to)),
                                  Qt::CaseInsensitive) == 0,
                 name.c_str());
    }
  }
}

void AnatomicalNamesTest::search() {
  const std::vector<std::string> words = m_names.searchWords("gland_adrenal_left");
  for (const char* word : {"gland_adrenal_left", "left adrenal gland", "linke Nebenniere",
                           "glandula suprarenalis sinistra", "linker bijnier", "venstre binyre",
                           "suprarenal gland", "adrenal"})
    QVERIFY2(std::find(words.begin(), words.end(), word) != words.end(), word);
  const std::vector<std::string> rib = m_names.searchWords("rib 3");
  QVERIFY(std::find(rib.begin(), rib.end(), "costa III") != rib.end());
}

void AnatomicalNamesTest::knowsWhatSegmentationNames() {
  QFile table(QStringLiteral(SLINE_TEST_DATA "/terminology/totalsegmentator/class_names.tsv"));
  if (!table.open(QIODevice::ReadOnly))
    SLINE_ABSENT("no real names here");
  table.readLine();
  int seen = 0;
  while (!table.atEnd()) {
    const QByteArray name = table.readLine().trimmed().split('\t').value(2);
    QVERIFY2(knows(name.toStdString()), name.constData());
    ++seen;
  }
  QVERIFY(seen > 100);
}

void AnatomicalNamesTest::knowsTheAtlas() {
  QFile table(QStringLiteral(SLINE_TEST_DATA "/abdomen/MANIFEST.tsv"));
  if (!table.open(QIODevice::ReadOnly))
    SLINE_ABSENT("no real names here");
  table.readLine();
  QStringList unknown;
  while (!table.atEnd()) {
    // Data/Model_10_gallbladder.vtk
    const QString file = QString::fromUtf8(table.readLine()).section('\t', 0, 0);
    const QString name = file.section('_', 2).section(".vtk", 0, 0);
    if (!knows(name.toStdString()))
      unknown << name;
  }
  QCOMPARE(unknown, QStringList());
}

void AnatomicalNamesTest::knowsThePelvis() {
  QDir folder(QStringLiteral(SLINE_TEST_DATA "/pelvis/bodyparts3d"));
  const QStringList files = folder.entryList({QStringLiteral("*.obj")});
  if (files.isEmpty())
    SLINE_ABSENT("no real names here");
  for (const QString& file : files) {
    // FJ2571_FMA14544_rectum.obj
    const QString name = file.section('_', 2).section(".obj", 0, 0);
    QVERIFY2(knows(name.toStdString()), qPrintable(name));
  }
}

void AnatomicalNamesTest::knowsTheDemos_data() {
  QTest::addColumn<bool>("known");
  for (const char* name : {"Arteries",
                           "Biliary system",
                           "Bones",
                           "Digestive system",
                           "Discs and cartilage",
                           "Glands and spleen",
                           "Muscles",
                           "Nerves",
                           "Organs",
                           "Portal system",
                           "Tumour",
                           "Urinary organs",
                           "Urinary system",
                           "Veins",
                           "Vessels",
                           "abdominal aorta",
                           "ascending colon",
                           "bile duct",
                           "coeliac trunk",
                           "corpora cavernosa of penis",
                           "corpus spongiosum of penis",
                           "descending colon",
                           "duodenum",
                           "external anal sphincter",
                           "fifth lumbar intervertebral disc",
                           "fifth lumbar vertebra",
                           "gallbladder",
                           "ileum",
                           "inferior mesenteric artery",
                           "inferior vena cava",
                           "jejunum",
                           "L5 vertebra",
                           "left adrenal gland",
                           "left common iliac artery",
                           "left coccygeus",
                           "left deferent duct",
                           "left epididymis",
                           "left external iliac vein",
                           "left femoral nerve",
                           "left femur",
                           "left hip bone",
                           "left iliac arteries",
                           "left iliac veins",
                           "left iliacus",
                           "left iliococcygeus",
                           "left internal pudendal artery",
                           "left kidney",
                           "left obturator artery",
                           "left obturator internus",
                           "left obturator nerve",
                           "left ovary",
                           "left piriformis",
                           "left psoas major",
                           "left pubococcygeus",
                           "left puborectalis",
                           "left pudendal nerve",
                           "left renal artery",
                           "left renal vein",
                           "left sciatic nerve",
                           "left seminal vesicle",
                           "left superior vesical artery",
                           "left testis",
                           "left twelfth rib",
                           "left ureter",
                           "left uterine tube",
                           "liver",
                           "pancreas",
                           "portal vein",
                           "prostate",
                           "pubic symphysis",
                           "rectal tumour",
                           "rectum",
                           "sacrum",
                           "sigmoid colon",
                           "spleen",
                           "splenic vein",
                           "stomach",
                           "superior mesenteric artery",
                           "superior mesenteric vein",
                           "T12-L1 intervertebral disc",
                           "transverse colon",
                           "urethra",
                           "urinary bladder",
                           "uterus",
                           "vagina",
                           "vermiform appendix"})
    QTest::newRow(name) << true;
}

void AnatomicalNamesTest::knowsTheDemos() {
  QTEST(knows(QTest::currentDataTag()), "known");
}

SLINE_TEST(AnatomicalNamesTest)
#include "anatomical_names_test.moc"
