// SPDX-License-Identifier: Apache-2.0
// Tests the table of names itself: each row whole, each name once, genders as grammar has them.
#include <QRegularExpression>
#include <QtTest>
#include <map>

#include "model/anatomy/anatomical_names.h"
#include "tests/support/suite.h"

using namespace sline::model;

class NamesTableTest : public QObject {
  Q_OBJECT

  AnatomicalNames m_names;

 private slots:
  void isWhole();
  void namesOnce();
  void genders_data();
  void genders();
  void brokenRowsAreLeftOut_data();
  void brokenRowsAreLeftOut();
  void numerals();
  void sides_data();
  void sides();
};

void NamesTableTest::isWhole() {
  QCOMPARE(m_names.badRows(), std::size_t(0));
  QVERIFY(m_names.rows().size() >= 400);
  for (const std::string& key : m_names.ambiguities())
    QFAIL(("stands for two rows: " + key).c_str());
  for (const NameRow& row : m_names.rows()) {
    QVERIFY2(row.latin.gender != Gender::none, row.names[0].c_str());
    QVERIFY2(row.german.plural || row.german.gender != Gender::none, row.names[0].c_str());
    for (const std::string& name : row.names) {
      const QString text = QString::fromStdString(name);
      QVERIFY2(text == text.simplified() && !text.contains(','), name.c_str());
    }
    for (const std::string& synonym : row.synonyms)
      QVERIFY2(!synonym.empty(), row.names[0].c_str());
  }
}

void NamesTableTest::namesOnce() {
  for (std::size_t language = 0; language < nameLanguages; ++language) {
    std::map<std::string, std::string> seen;
    for (const NameRow& row : m_names.rows()) {
      const auto [there, isNew] = seen.emplace(row.names[language], row.names[0]);
      QVERIFY2(isNew, (row.names[language] + ": " + there->second + ", " + row.names[0]).c_str());
    }
  }
}

void NamesTableTest::genders_data() {
  QTest::addColumn<int>("language");
  QTest::addColumn<QString>("pattern");
  QTest::addColumn<int>("gender");
  QTest::addColumn<bool>("plural");
  const auto row = [](NameLanguage language, const char* pattern, Gender gender, bool plural) {
    QTest::newRow(pattern) << int(language) << QString::fromUtf8(pattern) << int(gender) << plural;
  };
  using enum Gender;
  // In Latin, the first word is the head of the name.
  const NameLanguage latin = NameLanguage::latin;
  row(latin,
      "^(arteria|vena|vesica|glandula|valva|costa|vertebra|aorta|pars|pelvis|medulla|articulatio)"
      "\\b(?!.* et )",
      feminine, false);
  row(latin,
      "^(musculus|nervus|ductus|lobus|truncus|plexus|ramus|ren|ureter|discus|bronchus|canalis)\\b",
      masculine, false);
  row(latin,
      "^(os|ligamentum|intestinum|colon|corpus|caput|ovarium|atrium|septum|systema|segmentum|"
      "omentum)\\b(?!.* et )",
      neuter, false);
  row(latin, "^(arteriae|venae|vertebrae|costae|glandulae|articulationes)\\b", feminine, true);
  row(latin, "^(musculi|nervi|disci intervertebrales|dentes)", masculine, true);
  row(latin, "^(ossa|organa|corpora|vasa)\\b", neuter, true);
  // In German, the last word's end decides.
  const NameLanguage german = NameLanguage::german;
  row(german, "(arterie|vene|schlagader|drüse|niere|blase|klappe|röhre|rippe|scheibe|aorta|lunge)$",
      feminine, false);
  row(german, "(muskel|nerv|lappen|darm|leiter|strecker|anzieher|gang|hoden|tumor)$", masculine,
      false);
  row(german, "(bein|becken|hirn|mark|blatt|gelenk|band|geflecht|netz|system|herz)$", neuter,
      false);
  row(german, "(arterien|venen|nerven|organe|drüsen|muskeln)$", none, true);
}

void NamesTableTest::genders() {
  QFETCH(int, language);
  QFETCH(QString, pattern);
  QFETCH(int, gender);
  QFETCH(bool, plural);
  const QRegularExpression head(pattern, QRegularExpression::CaseInsensitiveOption |
                                             QRegularExpression::UseUnicodePropertiesOption);
  QVERIFY(head.isValid());
  int seen = 0;
  for (const NameRow& row : m_names.rows()) {
    const std::string& name = row.names[std::size_t(language)];
    // A name made of several has its gender from another word.
    const QString text = QString::fromStdString(name);
    if (!head.match(text).hasMatch() || text.contains(" und ") || text.contains(" der "))
      continue;
    ++seen;
    const Agreement& agreement = row.agreement(NameLanguage(language));
    QVERIFY2(int(agreement.gender) == gender && agreement.plural == plural, name.c_str());
  }
  QVERIFY(seen > 1);
}

void NamesTableTest::brokenRowsAreLeftOut_data() {
  QTest::addColumn<QByteArray>("row");
  QTest::addColumn<int>("good");
  QTest::newRow("whole") << QByteArray("kidney\tren, m\tNiere, f\tnier\tnyre\t") << 1;
  QTest::newRow("synonyms") << QByteArray("kidney\tren, m\tNiere, f\tnier\tnyre\ta|b") << 1;
  QTest::newRow("plural") << QByteArray("ribs\tcostae, fp\tRippen, p\tribben\tribbein\t") << 1;
  QTest::newRow("number") << QByteArray("rib {1-12}\tcosta @, f\t#. Rippe, f\t#e rib\t#. rib\t")
                          << 1;
  QTest::newRow("no gender") << QByteArray("kidney\tren\tNiere, f\tnier\tnyre\t") << 0;
  QTest::newRow("no such gender") << QByteArray("kidney\tren, x\tNiere, f\tnier\tnyre\t") << 0;
  QTest::newRow("plural without gender") << QByteArray("ribs\tcostae, p\tRippen, p\ta\tb\t") << 0;
  QTest::newRow("empty") << QByteArray("kidney\tren, m\tNiere, f\t\tnyre\t") << 0;
  QTest::newRow("short") << QByteArray("kidney\tren, m\tNiere, f\tnier\tnyre") << 0;
  QTest::newRow("no range") << QByteArray("rib {}\tcosta @, f\t#. Rippe, f\t#e rib\t#. rib\t") << 0;
  QTest::newRow("range open") << QByteArray("rib {1-\tcosta @, f\t#. Rippe, f\t#e\t#.\t") << 0;
  QTest::newRow("backwards") << QByteArray("rib {9-1}\tcosta @, f\t#. Rippe, f\t#e\t#.\t") << 0;
  QTest::newRow("number lost") << QByteArray("rib {1-12}\tcosta @, f\t#. Rippe, f\trib\t#.\t") << 0;
  QTest::newRow("number from nowhere") << QByteArray("rib\tcosta @, f\t#. Rippe, f\t#e\t#.\t") << 0;
}

void NamesTableTest::brokenRowsAreLeftOut() {
  QFETCH(QByteArray, row);
  QFETCH(int, good);
  const AnatomicalNames names("# comment\n" + row.toStdString() + "\r\n");
  QCOMPARE(int(names.rows().size()), good);
  QCOMPARE(int(names.badRows()), 1 - good);
}

void NamesTableTest::numerals() {
  QCOMPARE(romanNumeral(4), "IV");
  QCOMPARE(romanNumeral(12), "XII");
  for (int number = 1; number < 40; ++number)
    QCOMPARE(fromRoman(QByteArray(romanNumeral(number).c_str()).toLower().toStdString()), number);
  QCOMPARE(fromRoman("iiii"), 0);
  QCOMPARE(fromRoman(""), 0);
}

void NamesTableTest::sides_data() {
  QTest::addColumn<int>("gender");
  QTest::addColumn<bool>("plural");
  QTest::addColumn<QString>("latin");
  QTest::addColumn<QString>("german");
  using enum Gender;
  QTest::newRow("masculine") << int(masculine) << false << "x dexter"
                             << "rechter x";
  QTest::newRow("feminine") << int(feminine) << false << "x dextra"
                            << "rechte x";
  QTest::newRow("neuter") << int(neuter) << false << "x dextrum"
                          << "rechtes x";
  QTest::newRow("masculines") << int(masculine) << true << "x dextri"
                              << "rechte x";
  QTest::newRow("feminines") << int(feminine) << true << "x dextrae"
                             << "rechte x";
  QTest::newRow("neuters") << int(neuter) << true << "x dextra"
                           << "rechte x";
}

void NamesTableTest::sides() {
  QFETCH(int, gender);
  QFETCH(bool, plural);
  QFETCH(QString, latin);
  QFETCH(QString, german);
  const Agreement agreement{Gender(gender), plural};
  const auto said = [&](Side side, NameLanguage language) {
    return QString::fromStdString(withSide("x", side, language, agreement));
  };
  QCOMPARE(said(Side::right, NameLanguage::latin), latin);
  QCOMPARE(said(Side::right, NameLanguage::german), german);
  QCOMPARE(said(Side::left, NameLanguage::latin),
           latin.replace("dexter", "sinister").replace("dext", "sinist"));
  QCOMPARE(said(Side::left, NameLanguage::german), german.replace("recht", "link"));
  QCOMPARE(said(Side::none, NameLanguage::latin), QStringLiteral("x"));
}

SLINE_TEST(NamesTableTest)
#include "names_table_test.moc"
