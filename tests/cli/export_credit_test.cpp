// SPDX-License-Identifier: Apache-2.0
// Tests the credit of a file, its author and terms: it is where other programs look for it if it
// was given, and nowhere if it was not.
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include "render/export/formats/export_formats.h"
#include "tests/cli/sline_process.h"
#include "tests/support/marker_scan.h"
#include "tests/support/suite.h"

namespace sline::test {

namespace {

constexpr const char* author = "QZXAUTHOR Zoë <& Co>";
constexpr const char* rights = "QZXRIGHTS © CC BY 4.0";

QByteArray contents(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

/// Returns a program's output about a file; empty if the program is absent.
QString told(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(program, arguments);
  if (!process.waitForFinished(60'000) || process.exitCode() != 0)
    qWarning("%s fails", qPrintable(program));
  return QString::fromUtf8(process.readAll());
}

}  // namespace

class ExportCreditTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;
  QString m_scene = m_folder.filePath("scene.sline");

  QString out() const { return m_folder.filePath("out"); }
  /// Returns the files of that kind, exported to an empty folder.
  QStringList exported(const QString& kind, const QString& name, const QStringList& flags) {
    QDir(out()).removeRecursively();
    QDir().mkpath(out());
    // A sheet's paper has a size of its own.
    const QStringList size =
        flags.contains("--sheet") ? QStringList() : QStringList{"--size-mm", "80x60"};
    const Finished finished = runSline(
        QStringList{"export", m_scene, "--" + kind, out() + "/" + name, "--dpi", "72", "--seconds",
                    "0.5", "--fps", "6", "--film-height", "96", "--alt", "off"} +
        size + flags);
    if (finished.code != 0)
      qWarning("%s", finished.err.constData());
    QStringList files;
    for (QDirIterator each(out(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
         finished.code == 0 && each.hasNext();)
      files << each.next();
    return files;
  }
  /// Tells whether a file says it, or others beside it do: pictures, and the page of a site.
  static bool saysIt(const QString& file) {
    static const QStringList without{"txt", "css", "js", "wasm", "scene"};
    return !without.contains(QFileInfo(file).suffix());
  }
  static QStringList both() {
    return {"--author", QString::fromUtf8(author), "--copyright", QString::fromUtf8(rights)};
  }

 private slots:
  void initTestCase() {
    const QString sample = writeSample(m_folder.path());
    QCOMPARE(runSline({"import", sample, "-o", m_scene}).code, 0);
    QCOMPARE(runSline({"annotate", m_scene, "--on", "kidney"}).code, 0);
    for (const char* side : {"anterior", "left"})
      QCOMPARE(runSline({"view", m_scene, "--add", QString("From ") + QLatin1String(side), "--from",
                         side})
                   .code,
               0);
  }

  void everyFileHasIt_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("name");
    for (const render::ExportFormat& format : render::exportFormats())
      QTest::newRow(format.id) << format.id
                               << QString("figure") + (*format.extension ? "." : "") +
                                      format.extension;
    QTest::newRow("anki's text") << "anki"
                                 << "figure.zip";
    QTest::newRow("anki's folder") << "anki"
                                   << "figure";
    QTest::newRow("sheet") << "pdf"
                           << "sheet.pdf";
    QTest::newRow("lesson") << "pdf"
                            << "lesson.pdf";
    QTest::newRow("cards of all views") << "anki"
                                        << "lesson.apkg";
    QTest::newRow("pictures of all views") << "png"
                                           << "lesson.png";
  }
  void everyFileHasIt() {
    QFETCH(QString, kind);
    QFETCH(QString, name);
    const QStringList words{"QZXAUTHOR", "QZXRIGHTS"};
    const QStringList sheet = name == "sheet.pdf"         ? QStringList{"--sheet", "figure"}
                              : name.startsWith("lesson") ? QStringList{"--views", "all"}
                                                          : QStringList();
    const QStringList files = exported(kind, name, both() + sheet);
    QVERIFY(!files.isEmpty());
    for (const QString& file : files)
      if (saysIt(file))
        QCOMPARE(markersIn(contents(file), words), words);
    // Without a credit the file has no field for it, and with one of the two none for the other.
    const QStringList places{"dc:creator",    "dc:rights", "cc:Agent",
                             "adobe:ns:meta", "/Author",   "Author:"};
    for (const QString& file : exported(kind, name, sheet))
      QVERIFY2(markersIn(contents(file), words + places).isEmpty(),
               qPrintable(file + markersIn(contents(file), words + places).join(' ')));
    for (const QString& file : exported(kind, name, sheet + both().mid(0, 2)))
      if (saysIt(file))
        QCOMPARE(markersIn(contents(file), words), words.mid(0, 1));
  }

  /// Who has surfaces under terms that ask for their credit is told where a file has none.
  void whoseWorkIsNotSaidIsTold_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QStringList>("flags");
    QTest::addColumn<bool>("told");
    for (const char* kind : {"svg", "pdf", "pptx", "moodle", "qti", "h5p", "anki"})
      QTest::newRow(kind) << kind << QStringList() << true;
    for (const char* kind : {"page", "scorm12", "glb"})
      QTest::newRow(kind) << kind << QStringList() << false;
    QTest::newRow("said") << "svg" << QStringList{"--credits", "line"} << false;
    QTest::newRow("not wanted") << "svg" << QStringList{"--credits", "off"} << false;
  }
  void whoseWorkIsNotSaidIsTold() {
    QFETCH(QString, kind);
    QFETCH(QStringList, flags);
    QFETCH(bool, told);
    const QString scene = m_folder.filePath("credited.sline");
    QFile::remove(scene);
    QVERIFY(QFile::copy(m_scene, scene));
    const auto licensed = [&scene](const char* licence) {
      return runSline({"credit", scene, "--source", "Atlas of Balls", "--licence", licence});
    };
    QVERIFY2(licensed("CC BY-SA 4.0").code == 0, licensed("CC BY-SA 4.0").err.constData());
    const QStringList order =
        QStringList{"export", scene, "--" + kind, m_folder.filePath("credited." + kind)} + flags;
    const QByteArray err = runSline(order).err;
    QCOMPARE(err.contains("Atlas of Balls, CC BY-SA 4.0") && err.contains("--credits line"), told);
    QCOMPARE(licensed("CC0 1.0").code, 0);
    QVERIFY(!runSline(order).err.contains("Atlas of Balls"));
  }

  void othersReadIt_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("reader");
    QTest::addColumn<QStringList>("says");
    const QString name = QString::fromUtf8(author);
    const QString terms = QString::fromUtf8(rights);
    const QStringList oiio{"oiiotool", "--info", "-v"};
    const QStringList tags{"Artist: \"" + name + "\"", "Copyright: \"" + terms + "\""};
    QTest::newRow("png") << "png"
                         << "a.png" << oiio << tags;
    QTest::newRow("tiff") << "tiff"
                          << "a.tiff" << oiio << tags;
    QTest::newRow("jpeg") << "jpeg"
                          << "a.jpg" << oiio << tags;
    QTest::newRow("exr") << "exr"
                         << "a.exr" << oiio << tags;
    QTest::newRow("pdf") << "pdf"
                         << "a.pdf" << QStringList{"pdfinfo"} << QStringList{name};
    QTest::newRow("pdf's XMP") << "pdf"
                               << "a.pdf" << QStringList{"pdfinfo", "-meta"}
                               << QStringList{"<dc:creator>", "Zoë &lt;&amp; Co&gt;",
                                              "QZXRIGHTS ©"};
    QTest::newRow("mp4") << "mp4"
                         << "a.mp4" << QStringList{"ffprobe", "-hide_banner", "-show_format"}
                         << QStringList{"TAG:artist=" + name, "TAG:copyright=" + terms};
  }
  void othersReadIt() {
    QFETCH(QString, kind);
    QFETCH(QString, name);
    QFETCH(QStringList, reader);
    QFETCH(QStringList, says);
    if (QStandardPaths::findExecutable(reader.front()).isEmpty())
      SLINE_ABSENT(qPrintable(reader.front() + " is not installed"));
    const QStringList files = exported(kind, name, both());
    QCOMPARE(files.size(), 1);
    const QString text = told(reader.front(), reader.mid(1) + files);
    for (const QString& each : says)
      QVERIFY2(text.contains(each), qPrintable(each + "\n" + text));
  }

  void inTheirOwnWords() {
    const QByteArray svg = contents(exported("svg", "a.svg", both()).value(0));
    QVERIFY(
        svg.contains("<dc:creator><cc:Agent><dc:title>QZXAUTHOR Zoë &lt;&amp; Co&gt;</dc:title>"));
    QVERIFY(svg.contains("<dc:rights><cc:Agent><dc:title>QZXRIGHTS © CC BY 4.0</dc:title>"));
    const QByteArray glb = contents(exported("glb", "a.glb", both()).value(0));
    QVERIFY(glb.contains("\"copyright\":\"QZXAUTHOR Zoë <& Co>, QZXRIGHTS © CC BY 4.0\""));
    QVERIFY(glb.contains("\"extras\":{\"author\":\"QZXAUTHOR Zoë <& Co>\"}"));
    const QByteArray gif = contents(exported("gif", "a.gif", both()).value(0));
    QVERIFY(gif.contains("\x21\xFE"));
    QVERIFY(gif.contains("Author: QZXAUTHOR Zoë <& Co>\nCopyright: QZXRIGHTS © CC BY 4.0"));
    const QByteArray webp = contents(exported("webp", "a.webp", both()).value(0));
    QVERIFY(webp.contains("XMP ") &&
            webp.contains("<rdf:li>QZXAUTHOR Zoë &lt;&amp; Co&gt;</rdf:li>"));
  }

  void oneLineOfText() {
    const QByteArray svg =
        contents(exported("svg", "a.svg", {"--author", "  two\nlines\x01 "}).value(0));
    QVERIFY(svg.contains("<dc:title>two lines\xEF\xBF\xBD</dc:title>"));
    const Finished tooLong = runSline({"export", m_scene, "--svg", m_folder.filePath("x.svg"),
                                       "--author", QString(501, QLatin1Char('x'))});
    QCOMPARE(tooLong.code, 2);
    QVERIFY2(tooLong.err.contains("--author is too long"), tooLong.err.constData());
  }

  /// A list has a column for each of the two.
  void listsHaveIt() {
    writeFile(m_folder.filePath("list.csv"),
              "input,svg,size-mm,author,copyright\nscene.sline,list.svg,24x18,QZXAUTHOR,\n");
    const Finished finished = runSline({"jobs", m_folder.filePath("list.csv")});
    QVERIFY2(finished.code == 0, finished.err.constData());
    const QByteArray svg = contents(m_folder.filePath("list.svg"));
    QVERIFY(svg.contains("QZXAUTHOR") && !svg.contains("dc:rights"));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_EVENTS(sline::test::ExportCreditTest)
#include "export_credit_test.moc"
