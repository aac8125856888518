// SPDX-License-Identifier: Apache-2.0
// Tests a callout with bold and italic words and a list, in every kind of file, and its words
// wherever they are listed.
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "tests/cli/sline_process.h"
#include "tests/support/suite.h"

namespace sline::test {

class CalloutTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase();
  void listsAreWithoutMarkers();
  void vectorsHaveStyles();
  void printHasTextInItsFonts();
  void keysAreWithoutMarkers();
  void picturesDiffer();
  void cardsAndModels();

 private:
  QString path(const char* name) const { return m_folder.filePath(QLatin1String(name)); }
  /// Exports the scene to a file of that name.
  QByteArray exported(const char* name, const QStringList& flags);
  QString run(const QString& program, const QStringList& arguments);
  void annotate(const QString& scene, const QString& text);

  QTemporaryDir m_folder;
};

namespace {
const char* const markedText = "**Kidney** & *ren*\n- a ***hilum***\n- 5 * 3 <b>cm</b>\\*";
const char* const plainWords = "Kidney & ren • a hilum • 5 * 3 <b>cm</b>*";

QByteArray contents(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}
}  // namespace

void CalloutTest::annotate(const QString& scene, const QString& text) {
  QCOMPARE(
      runSline({"annotate", scene, "--kind", "callout", "--on", "kidney", "--label", text}).err,
      QByteArray());
}

void CalloutTest::initTestCase() {
  QCOMPARE(runSline({"import", writeSample(m_folder.path()), "-o", path("scene.sline")}).code, 0);
  QVERIFY(QFile::copy(path("scene.sline"), path("plain.sline")));
  annotate(path("scene.sline"), QString::fromUtf8(markedText));
  annotate(path("plain.sline"), "Kidney & ren\n- a hilum\n- 5 * 3 <b>cm</b>\\*");
  QCOMPARE(
      runSline({"annotate", path("scene.sline"), "--on", "renal vein", "--label", "**vein**"}).code,
      0);
}

QByteArray CalloutTest::exported(const char* name, const QStringList& flags) {
  const QString kind = QString(name).section('.', -1);
  const Finished done = runSline(
      QStringList{"export", path("scene.sline"), "--" + kind, path(name), "--view", "anterior"} +
      flags);
  if (done.code != 0)
    qWarning("%s", done.err.constData());
  return contents(path(name));
}

QString CalloutTest::run(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  if (!process.waitForFinished() || process.exitCode() != 0)
    return {};
  return QString::fromUtf8(process.readAllStandardOutput());
}

/// A label's asterisks stay asterisks.
void CalloutTest::listsAreWithoutMarkers() {
  const QByteArray listed = runSline({"annotate", path("scene.sline"), "--list"}).out;
  QCOMPARE(listed,
           QByteArray("1\tcallout\tkidney\t") + plainWords + "\n2\tlabel\trenal vein\t**vein**\n");
  const QByteArray info = runSline({"info", path("scene.sline")}).out;
  QVERIFY2(info.contains(QByteArray("callout \"") + plainWords + "\" at"), info);
  QVERIFY(info.contains("label \"**vein**\" at"));
}

void CalloutTest::vectorsHaveStyles() {
  // The page is so wide that no line need be broken.
  const QByteArray svg = exported("figure.svg", {"--labels", "on", "--size-mm", "240x135"});
  for (const char* part :
       {">Kidney</tspan> &amp; <tspan font-style=\"italic\">ren</tspan></tspan>",
        "<tspan font-weight=\"bold\">Kidney</tspan>",
        ">• a <tspan font-weight=\"bold\" font-style=\"italic\">hilum</tspan></tspan>",
        ">**vein**</text>"})
    QVERIFY2(svg.contains(part), part);
  QVERIFY(svg.contains("inkscape:label=\"Kidney &amp; ren • a hilum • 5 * 3 &lt;b>cm&lt;/b>*\"") ||
          svg.contains("inkscape:label=\"Kidney &amp; ren • a hilum • 5 * 3 "
                       "&lt;b&gt;cm&lt;/b&gt;*\""));
  QVERIFY(!svg.contains("<b>"));
  QVERIFY(!svg.contains("**Kidney"));
}

void CalloutTest::printHasTextInItsFonts() {
  if (QStandardPaths::findExecutable("pdftotext").isEmpty())
    SLINE_ABSENT("poppler-utils are not installed");
  QVERIFY(!exported("figure.pdf", {"--labels", "on"}).isEmpty());
  const QString text = run("pdftotext", {path("figure.pdf"), "-"}).simplified();
  QVERIFY2(text.contains("Kidney & ren"), qPrintable(text));
  QVERIFY2(text.contains("• a hilum"), qPrintable(text));
  QVERIFY2(text.contains("**vein**"), qPrintable(text));
  QVERIFY(!text.contains("**Kidney") && !text.contains("*ren"));
  const QString fonts = run("pdffonts", {path("figure.pdf")});
  for (const char* name :
       {"DejaVuSans", "DejaVuSans-Bold", "DejaVuSans-Oblique", "DejaVuSans-BoldOblique"}) {
    // The columns are type, encoding and embedded.
    const QRegularExpression row("(^|\\+|\n)" + QRegularExpression::escape(name) +
                                 " +CID TrueType +\\S+ +yes ");
    QVERIFY2(row.match(fonts).hasMatch(), qPrintable(name + ('\n' + fonts)));
  }
}

void CalloutTest::keysAreWithoutMarkers() {
  const Finished render = runSline({"render", path("scene.sline"), "-o", path("numbers.png"),
                                    "--size", "800x400", "--labels", "numbers"});
  QCOMPARE(render.code, 0);
  QVERIFY2(("\n" + render.out).contains(QByteArray("\n2\t") + plainWords + "\n"), render.out);
  if (QStandardPaths::findExecutable("pdftotext").isEmpty())
    SLINE_ABSENT("poppler-utils are not installed");
  QVERIFY(!exported("sheet.pdf", {"--sheet", "teaching", "--ask-callouts"}).isEmpty());
  const QString key = run("pdftotext", {"-f", "3", "-l", "3", path("sheet.pdf"), "-"}).simplified();
  QVERIFY2(key.contains("Kidney & ren • a hilum"), qPrintable(key));
  QVERIFY2(key.contains("**vein**"), qPrintable(key));
  QVERIFY(!key.contains("**Kidney"));
}

void CalloutTest::picturesDiffer() {
  const auto drawn = [this](const char* scene, const QStringList& flags) {
    const QString file = path("picture.png");
    QFile::remove(file);
    runSline(QStringList{"render", path(scene), "-o", file, "--size", "800x400"} + flags);
    return readPicture(file);
  };
  // Sums up ink by how dark it is.
  const auto ink = [](const Pixels& picture) {
    qint64 sum = 0;
    for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4)
      sum += 255 - picture.rgba[i + 1];
    return sum;
  };
  QCOMPARE(runSline({"annotate", path("scene.sline"), "--remove", "2"}).code, 0);
  const Pixels marked = drawn("scene.sline", {"--labels", "on"});
  const Pixels plain = drawn("plain.sline", {"--labels", "on"});
  QCOMPARE(marked.width, 800);
  QVERIFY2(ink(marked) > ink(plain) + 2000,
           qPrintable(QString("%1, %2").arg(ink(marked)).arg(ink(plain))));
  // Without words nothing tells the two apart.
  QVERIFY(drawn("scene.sline", {}).rgba == drawn("plain.sline", {}).rgba);
}

void CalloutTest::cardsAndModels() {
  const QStringList cards{"export", path("scene.sline"), "--anki", path("cards"),
                          "--view", "anterior"};
  // There is only the callout, which is no question unless that is asked for.
  const auto none = runSline(cards);
  QVERIFY(none.code != 0 && none.err.contains("no labels to ask for"));
  QCOMPARE(runSline(cards + QStringList{"--ask-callouts"}).code, 0);
  const QByteArray deck = contents(path("cards/deck.txt"));
  QVERIFY2(deck.contains("<br>Kidney &amp; ren • a hilum • 5 * 3 &lt;b&gt;cm&lt;/b&gt;*\t"), deck);
  const QByteArray glb = exported("model.glb", {});
  // The file's fourth word is the JSON chunk's length.
  const QJsonObject root =
      QJsonDocument::fromJson(
          glb.mid(20, qsizetype(*reinterpret_cast<const quint32*>(glb.constData() + 12))))
          .object();
  QVERIFY(!root.isEmpty());
  const QByteArray nodes = QJsonDocument(root).toJson(QJsonDocument::Compact);
  QVERIFY2(nodes.contains("Kidney & ren\\n• a hilum\\n• 5 * 3 <b>cm</b>*"), nodes.right(2000));
  QVERIFY(!nodes.contains("**Kidney"));
}

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::CalloutTest)
#include "callout_test.moc"
