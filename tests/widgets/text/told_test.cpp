// SPDX-License-Identifier: Apache-2.0
// Tests that errors and remarks of rooms without Qt are read in the interface's language, as those
// rooms really make them.
#include "widgets/text/told.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "model/import/plan/import.h"
#include "model/scene_file/scene_file.h"
#include "tests/support/memory_requests.h"
#include "tests/support/suite.h"
#include "widgets/language/language_switch.h"

namespace sline::widgets {

class ToldTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_folder;

  std::filesystem::path written(const QString& name, const QByteArray& bytes) {
    const QString path = m_folder.filePath(name);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
      qFatal("no %s", qPrintable(path));
    return path.toStdString();
  }
  static Error errorOf(const std::filesystem::path& path) {
    const auto imported = model::importInputs({{path}}, {});
    return imported.ok() ? Error() : imported.error();
  }
  static QStringList languages() { return {"de", "nl", "nb"}; }

 private slots:
  void errorsAreTranslated_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::newRow("no file") << "absent.stl" << QByteArray();
    QTest::newRow("empty") << "empty.stl" << QByteArray("");
    QTest::newRow("unknown kind") << "notes.xyz" << QByteArray("words");
    QTest::newRow("no extension") << "notes" << QByteArray("words");
    QTest::newRow("no faces") << "points.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    QTest::newRow("not of its kind") << "words.obj" << QByteArray("some words\nand more\n");
    QTest::newRow("no PLY") << "words.ply" << QByteArray("some words\n");
    QTest::newRow("no OFF") << "words.off" << QByteArray("some words\n");
    QTest::newRow("faces of nothing")
        << "beyond.obj" << QByteArray("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 7 8 9\n");
    QTest::newRow("cut STL") << "cut.stl"
                             << QByteArray(80, ' ') + QByteArray("\x0a\0\0\0", 4) +
                                    QByteArray(70, '\0');
    QTest::newRow("short STL") << "short.stl" << QByteArray(20, '\0');
    QTest::newRow("no NIfTI") << "words.nii" << QByteArray(400, 'w');
    QTest::newRow("no DICOM") << "words.dcm" << QByteArray(400, 'w');
    QTest::newRow("no Slicer scene") << "other.mrml" << QByteArray("<html></html>");
    QTest::newRow("a folder without meshes") << "folder" << QByteArray();
    QTest::newRow("an archive") << "meshes.zip" << QByteArray("PK");
  }
  void errorsAreTranslated() {
    QFETCH(QString, name);
    QFETCH(QByteArray, bytes);
    if (name == "folder")
      QDir(m_folder.path()).mkdir(name);
    else if (!bytes.isNull())
      written(name, bytes);
    const Error error = errorOf(m_folder.filePath(name).toStdString());
    QVERIFY(!error.reason.empty());
    for (const QString& choice : languages()) {
      LanguageSwitch language;
      language.use(choice);
      for (const std::string& part : {error.reason, error.remedy})
        if (!part.empty())
          QVERIFY2(told(part) != QString::fromStdString(part), part.c_str());
      // The name of the file stays, and what is said of it is as when it stands alone.
      const QString whole = told(error.text());
      QVERIFY2(whole.contains(told(error.reason)), qPrintable(whole));
      QVERIFY2(error.remedy.empty() || whole.contains(told(error.remedy)), qPrintable(whole));
      language.use(QStringLiteral("en"));
      QCOMPARE(told(error.text()), QString::fromStdString(error.text()));
    }
  }

  void remarksAreTranslated() {
    // One statement among hundreds is forgiven.
    const QByteArray square = QByteArray("v 0 0 0\n").repeated(300) +
                              "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 100 100 0\nwords\nl 1 2\n"
                              "f 301 302 303\nf 301 302 303\nf 302 304 303\nf 302 302 302\n";
    const auto imported = model::importInputs({{written("square.obj", square)}}, {});
    QVERIFY2(imported.ok(), imported.ok() ? "" : imported.error().text().c_str());
    QStringList remarks;
    for (const model::ImportWarning& warning : imported->report.warnings)
      remarks << QString::fromStdString(warning.file + ": " + warning.reason);
    remarks << QString::fromStdString(imported->report.repairs.summary);
    for (const std::string& line : imported->report.repairs.surfaces)
      remarks << QString::fromStdString(line);
    remarks.removeAll(QString());
    QVERIFY2(remarks.size() >= 3, qPrintable(remarks.join('\n')));
    for (const QString& choice : languages()) {
      LanguageSwitch language;
      language.use(choice);
      for (const QString& remark : remarks) {
        QVERIFY2(told(remark) != remark, qPrintable(remark));
        for (const char* english : {" left", " faces", " are ", "repaired", "line "})
          QVERIFY2(!told(remark).contains(QLatin1String(english)), qPrintable(told(remark)));
      }
      QVERIFY(told(imported->report.frameReason) !=
              QString::fromStdString(imported->report.frameReason));
      language.use(QStringLiteral("en"));
    }
  }

  void sceneFilesAreTranslated() {
    const auto read = model::readSceneFile(written("spoiled.sline", "no archive"));
    QVERIFY(!read.ok());
    LanguageSwitch language;
    language.use(QStringLiteral("de"));
    QVERIFY2(told(read.error().reason).startsWith("ist keine vollständige ZIP-Datei"),
             qPrintable(told(read.error().reason)));
    QCOMPARE(told(read.error().remedy), "Öffne eine ältere Kopie oder importiere die Netze erneut");
    language.use(QStringLiteral("en"));
  }

  /// A folder of many meshes has many remarks, and the window reads them out.
  void manyAreTold() {
    LanguageSwitch language;
    language.use(QStringLiteral("de"));
    constexpr int count = 1000;
    const std::uint64_t before = test::memoryRequests();
    for (int i = 0; i < count; ++i)
      told(
          QStringLiteral("Structures/structure %1.obj: \"part %1\": 3 faces given twice, 2 without "
                         "area")
              .arg(i));
    const std::uint64_t each = (test::memoryRequests() - before) / count;
    QVERIFY2(each < 500, qPrintable(QString::number(each)));
    language.use(QStringLiteral("en"));
  }

  void partsAndWhatIsUnknown() {
    LanguageSwitch language;
    language.use(QStringLiteral("de"));
    QCOMPARE(told(QStringLiteral("it cannot be written: Permission denied")),
             "kann nicht geschrieben werden: Zugriff verweigert");
    QCOMPARE(told(QStringLiteral("liver.stl: line 12: is empty. Check the name.")),
             "liver.stl: Zeile 12: ist leer. Prüfe den Namen.");
    // Names with signs of their own stay as they are.
    QCOMPARE(told(QStringLiteral("files of kind '%2' are not supported")),
             "Dateien der Art „%2“ werden nicht unterstützt");
    for (const char* same : {"", ".", ": ", "50 %1 of words", "something else. And more."})
      QCOMPARE(told(QString::fromUtf8(same)), QString::fromUtf8(same));
    language.use(QStringLiteral("en"));
  }
};

}  // namespace sline::widgets

SLINE_TEST_WITH_EVENTS(sline::widgets::ToldTest)
#include "told_test.moc"
