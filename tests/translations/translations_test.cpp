// SPDX-License-Identifier: Apache-2.0
// Checks the .ts files against each other and against the texts in the program.
#include <QDirIterator>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <QtTest>
#include <cerrno>
#include <cstring>
#include <map>

#include "tests/support/suite.h"

namespace {

struct Message {
  QString source;
  QString type;  ///< empty when finished
  bool plural = false;
  QStringList forms;
};
/// Holds messages by context, comment and source.
using Messages = std::map<QString, Message>;

Message readMessage(QXmlStreamReader& xml, QString& comment) {
  Message message;
  message.plural = xml.attributes().value("numerus") == QLatin1String("yes");
  while (xml.readNextStartElement()) {
    if (xml.name() == QLatin1String("source")) {
      message.source = xml.readElementText();
    } else if (xml.name() == QLatin1String("comment")) {
      comment = xml.readElementText();
    } else if (xml.name() == QLatin1String("translation")) {
      message.type = xml.attributes().value("type").toString();
      if (!message.plural)
        message.forms << xml.readElementText();
      else
        while (xml.readNextStartElement())
          message.forms << xml.readElementText();
    } else {
      xml.skipCurrentElement();
    }
  }
  return message;
}

Messages readMessages(const QString& path) {
  Messages messages;
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
    qFatal("no %s", qPrintable(path));
  QXmlStreamReader xml(&file);
  QString context;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement)
      continue;
    if (xml.name() == QLatin1String("name")) {
      context = xml.readElementText();
    } else if (xml.name() == QLatin1String("message")) {
      QString comment;
      const Message message = readMessage(xml, comment);
      messages[context + '|' + comment + '|' + message.source] = message;
    }
  }
  if (xml.hasError())
    qFatal("%s: %s", qPrintable(path), qPrintable(xml.errorString()));
  return messages;
}

QString file(const QString& name) {
  return QStringLiteral(SLINE_SOURCE "/translations/") + name + QStringLiteral(".ts");
}

/// Returns %1, %2 … and %n, each as often as it stands there, sorted.
QStringList argumentsOf(const QString& text) {
  static const QRegularExpression pattern(QStringLiteral("%L?\\d|%n"));
  QStringList found;
  for (auto match = pattern.globalMatch(text); match.hasNext();)
    found << match.next().captured();
  found.sort();
  return found;
}

/// Tells whether the text has an accelerator: "&File" has one, "R && D" none.
bool hasAccelerator(QString text) {
  return text.remove(QStringLiteral("&&")).contains(QLatin1Char('&'));
}

/// Holds what stands around the words: spaces, the ellipsis of dialogs, the colon of labels.
struct Edges {
  QString front;
  QString back;
  bool ellipsis;
  bool colon;
  bool operator==(const Edges&) const = default;
};
Edges edges(const QString& text) {
  static const QRegularExpression front(QStringLiteral("^\\s*"));
  static const QRegularExpression back(QStringLiteral("\\s*$"));
  return {front.match(text).captured(), back.match(text).captured(),
          text.endsWith(QStringLiteral("…")) || text.endsWith(QStringLiteral("...")),
          text.endsWith(QLatin1Char(':'))};
}

/// Returns what is wrong with a translation; empty if nothing is.
QString faultOf(const Message& message) {
  if (!message.type.isEmpty())
    return message.type;
  if (message.forms.isEmpty() || (message.plural && message.forms.size() != 2))
    return QStringLiteral("plural forms are missing");
  for (const QString& form : message.forms) {
    if (form.isEmpty())
      return QStringLiteral("empty");
    QStringList wanted = argumentsOf(message.source);
    QStringList there = argumentsOf(form);
    if (message.plural) {
      // "One structure" may give its number as a word.
      there.removeAll(QStringLiteral("%n"));
      wanted.removeAll(QStringLiteral("%n"));
    }
    if (there != wanted)
      return QStringLiteral("other arguments");
    if (hasAccelerator(form) != hasAccelerator(message.source))
      return QStringLiteral("accelerator");
    if (!(edges(form) == edges(message.source)))
      return QStringLiteral("other beginning or end");
  }
  if (message.plural && message.source.contains(QStringLiteral("%n")) &&
      !message.forms.back().contains(QStringLiteral("%n")))
    return QStringLiteral("the plural lost its number");
  return {};
}

/// Tells whether the sources have the piece of a message, in one string or in a few that stand for
/// a count's noun, a list or a reason.
bool isMade(const QString& made, const QString& piece, int cuts) {
  if (made.contains(piece.trimmed()))
    return true;
  static const QRegularExpression joint(QStringLiteral("[ :(]"));
  for (auto match = joint.globalMatch(piece.trimmed()); cuts > 0 && match.hasNext();) {
    const qsizetype at = match.next().capturedStart();
    if (at > 0 && made.contains(piece.trimmed().left(at)) &&
        isMade(made, piece.trimmed().mid(at), cuts - 1))
      return true;
  }
  return false;
}

/// Tells whether the system says this of files.
bool isOfSystem(const QString& text) {
  for (const int code : {EACCES, ENOENT, ENOSPC, EROFS, EISDIR, ENOTDIR, EIO, EFBIG, EMFILE})
    if (text == QLatin1String(std::strerror(code)))
      return true;
  return false;
}

}  // namespace

class TranslationsTest : public QObject {
  Q_OBJECT
 private slots:
  void complete_data();
  void complete();
  void upToDate_data();
  void upToDate();
  void quotationMarks_data();
  void quotationMarks();
  void keysStay();
  void contextsOfTables();
  void messagesAreMade();
  void faults_data();
  void faults();
};

void TranslationsTest::complete_data() {
  QTest::addColumn<QString>("name");
  for (const char* name : {"sline_de", "sline_nl", "sline_nb", "sline_en", "qt_nb"})
    QTest::newRow(name) << QString(name);
}

void TranslationsTest::complete() {
  QFETCH(QString, name);
  const Messages messages = readMessages(file(name));
  QVERIFY(messages.size() >= 5);
  for (const auto& [key, message] : messages)
    QVERIFY2(faultOf(message).isEmpty(), qPrintable(faultOf(message) + ": " + key));
}

void TranslationsTest::upToDate_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("pluralsOnly");
  QTest::newRow("de") << "sline_de" << false;
  QTest::newRow("nl") << "sline_nl" << false;
  QTest::newRow("nb") << "sline_nb" << false;
  QTest::newRow("en") << "sline_en" << true;
}

void TranslationsTest::upToDate() {
  QFETCH(QString, name);
  QFETCH(bool, pluralsOnly);
  const QTemporaryDir folder;
  const QString fresh = folder.filePath(QStringLiteral("fresh.ts"));
  QStringList arguments{"-I",           ".",   "-silent", "widgets", "render/export",
                        "app/main.cpp", "-ts", fresh};
  QProcess lupdate;
  lupdate.setWorkingDirectory(QStringLiteral(SLINE_SOURCE));
  lupdate.start(QStringLiteral(SLINE_LUPDATE), arguments);
  QVERIFY(lupdate.waitForFinished(120'000));
  QCOMPARE(lupdate.exitCode(), 0);
  Messages texts = readMessages(fresh);
  if (pluralsOnly)
    std::erase_if(texts, [](const auto& each) { return !each.second.plural; });
  QVERIFY(!texts.empty());
  // The program does not find a text in another context.
  static const QRegularExpression known(QStringLiteral(
      "^(sline::widgets(::\\w+)?|sline::render::Export(Format|Option)|Told|main)\\|"));
  for (const auto& [key, message] : texts)
    QVERIFY2(known.match(key).hasMatch(), qPrintable("lupdate lost the class: " + key));
  const Messages translated = readMessages(file(name));
  for (const auto& [key, message] : texts)
    QVERIFY2(translated.contains(key), qPrintable("not translated: " + key));
  for (const auto& [key, message] : translated)
    QVERIFY2(texts.contains(key), qPrintable("nobody says: " + key));
}

void TranslationsTest::quotationMarks_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("foreign");
  QTest::newRow("de") << "sline_de"
                      << "\"”«»‘";
  QTest::newRow("nl") << "sline_nl"
                      << "\"„«»";
  QTest::newRow("nb") << "sline_nb"
                      << "\"“”„";
}

void TranslationsTest::quotationMarks() {
  QFETCH(QString, name);
  QFETCH(QString, foreign);
  for (const auto& [key, message] : readMessages(file(name)))
    for (const QString& form : message.forms)
      for (const QChar mark : foreign)
        // Markup has such marks of its own.
        QVERIFY2(!form.contains(mark) || form.contains(QLatin1Char('<')), qPrintable(key));
}

void TranslationsTest::keysStay() {
  // Keys are where they are in every language; only their labels differ.
  static const QRegularExpression key(QStringLiteral("^((Ctrl|Shift|Alt)\\+)+.+$|^[A-Z/]$|^Home$"));
  for (const char* name : {"sline_de", "sline_nl", "sline_nb"})
    for (const auto& [id, message] : readMessages(file(name)))
      if (key.match(message.source).hasMatch() && !message.source.contains(' '))
        QVERIFY2(message.forms.front() == message.source, qPrintable(id));
}

void TranslationsTest::contextsOfTables() {
  // lupdate files tr() outside of classes under the namespace; a function that looks elsewhere
  // finds nothing.
  static const QRegularExpression asks(
      QStringLiteral("QString tr\\(.*\\n\\s*return QCoreApplication::translate\\((\"[^\"]*\")"));
  int seen = 0;
  QDirIterator sources(QStringLiteral(SLINE_SOURCE "/widgets"), {"*.cpp"}, QDir::Files,
                       QDirIterator::Subdirectories);
  while (sources.hasNext()) {
    QFile source(sources.next());
    QVERIFY(source.open(QIODevice::ReadOnly));
    const auto match = asks.match(QString::fromUtf8(source.readAll()));
    if (!match.hasMatch())
      continue;
    ++seen;
    QVERIFY2(match.captured(1) == QStringLiteral("\"sline::widgets\""),
             qPrintable(source.fileName()));
  }
  QCOMPARE(seen, 1);  // in widgets/text, for all
}

/// Each pattern of a message stands in the source of a room without Qt, piece by piece.
void TranslationsTest::messagesAreMade() {
  // Strings that stand side by side are one; quotation marks in them are masked.
  static const QRegularExpression joint(QStringLiteral("\"\\s*\\n\\s*\""));
  static const QRegularExpression marker(QStringLiteral("%[1-9]"));
  QString made;
  for (const char* layer : {"model", "render", "widgets/session", "widgets/viewport"}) {
    QDirIterator sources(QStringLiteral(SLINE_SOURCE "/") + QLatin1String(layer), {"*.cpp", "*.h"},
                         QDir::Files, QDirIterator::Subdirectories);
    while (sources.hasNext()) {
      QFile source(sources.next());
      QVERIFY(source.open(QIODevice::ReadOnly));
      made += QString::fromUtf8(source.readAll()).remove(joint);
    }
  }
  QStringList strange;
  int seen = 0;
  for (const auto& [key, message] : readMessages(file(QStringLiteral("sline_de")))) {
    if (!key.startsWith(QStringLiteral("Told|")))
      continue;
    ++seen;
    for (const QString& piece : message.source.split(marker))
      if (piece.trimmed().size() > 3 && !isMade(made, piece, 2))
        strange << message.source;
  }
  QVERIFY(seen > 200);
  // What the system says of files is made by nobody here.
  strange.removeIf(isOfSystem);
  QVERIFY2(strange.isEmpty(), qPrintable(strange.join('\n')));
}

void TranslationsTest::faults_data() {
  QTest::addColumn<QString>("source");
  QTest::addColumn<QStringList>("forms");
  QTest::addColumn<bool>("plural");
  QTest::addColumn<bool>("good");
  const auto row = [](const char* name, const char* source, const QStringList& forms, bool plural,
                      bool good) {
    QTest::newRow(name) << QString::fromUtf8(source) << forms << plural << good;
  };
  row("whole", "&Open %1…", {"%1 ö&ffnen…"}, false, true);
  row("argument lost", "Open %1", {"Öffnen"}, false, false);
  row("argument twice", "Open %1", {"%1 %1"}, false, false);
  row("accelerator lost", "&Open", {"Öffnen"}, false, false);
  row("accelerator too many", "Open", {"Ö&ffnen"}, false, false);
  row("ampersand", "A && B", {"A && B"}, false, true);
  row("space lost", "Γ  ", {"Γ "}, false, false);
  row("ellipsis lost", "Open…", {"Öffnen"}, false, false);
  row("plural", "%n items", {"ein Element", "%n Elemente"}, true, true);
  row("plural without number", "%n items", {"ein Element", "viele Elemente"}, true, false);
  row("one form", "%n items", {"%n Elemente"}, true, false);
  row("empty", "Open", {""}, false, false);
}

void TranslationsTest::faults() {
  QFETCH(QString, source);
  QFETCH(QStringList, forms);
  QFETCH(bool, plural);
  QFETCH(bool, good);
  QCOMPARE(faultOf({source, {}, plural, forms}).isEmpty(), good);
}

SLINE_TEST_WITH_EVENTS(TranslationsTest)
#include "translations_test.moc"
