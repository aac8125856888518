// SPDX-License-Identifier: Apache-2.0
// Tests that rooms which other hosts share name no flag and no command, and that the command line
// adds its own to what they say.
#include "app/cli/files/flag_words.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include "tests/support/suite.h"

namespace sline::cli {

class FlagWordsTest : public QObject {
  Q_OBJECT

  /// Returns the sources of the folder by their paths; tables of the command line's flags aside.
  static QMap<QString, QString> sourcesIn(const QString& folder) {
    QMap<QString, QString> sources;
    QDirIterator all(QString(SLINE_SOURCE) + "/" + folder, {"*.cpp"}, QDir::Files,
                     QDirIterator::Subdirectories);
    while (all.hasNext()) {
      QFile file(all.next());
      const QString name = file.fileName();
      if (!name.endsWith("_options.cpp") && !name.endsWith("/view_orders.cpp") &&
          file.open(QIODevice::ReadOnly))
        sources[name] = QString::fromUtf8(file.readAll());
    }
    return sources;
  }

 private slots:
  void noOtherRoomNamesFlags() {
    const QRegularExpression named(QStringLiteral(
        "\"(?:[^\"\\\\\\n]|\\\\.)*?(?:--[a-z]{2}|`sline )(?:[^\"\\\\\\n]|\\\\.)*\""));
    int sources = 0;
    for (const char* folder : {"model", "render", "widgets"}) {
      const QMap<QString, QString> all = sourcesIn(folder);
      for (auto source = all.begin(); source != all.end(); ++source, ++sources)
        for (const QString& line : source.value().split('\n'))
          if (!line.contains("//") && !line.contains(".flag ="))
            QVERIFY2(!named.match(line).hasMatch(), qPrintable(source.key() + ": " + line));
    }
    QVERIFY(sources > 500);
  }

  void everyPhraseIsSaid() {
    QString all;
    for (const char* folder : {"model", "render"})
      for (const QString& text : sourcesIn(folder))
        all += text;
    // A literal may be broken into lines.
    all.replace(QRegularExpression(QStringLiteral("\"\\s*\"")), QString());
    for (const FlagWords& words : flagWords())
      QVERIFY2(all.contains(QLatin1String(words.phrase)), words.phrase);
  }

  void flagsAreAdded() {
    QCOMPARE(withFlags("Give the files of one patient, or put them together on purpose."),
             std::string("Give the files of one patient, or put them together on purpose "
                         "(--together)."));
    QCOMPARE(withFlags("liver.stl: is empty"), std::string("liver.stl: is empty"));
  }
};

}  // namespace sline::cli

SLINE_TEST(sline::cli::FlagWordsTest)
#include "flag_words_test.moc"
