// SPDX-License-Identifier: Apache-2.0
// Tests that LibreOffice opens presentations of odd names and draws every slide. It takes a minute
// and is a part of tests/thorough.sh, which sets SLINE_OFFICE.
#include <QDir>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include "render/export/slides/slides_file.h"
#include "tests/render/export/slides/lesson.h"
#include "tests/render/export/slides/opened_slides.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {

constexpr int decks = 50;
constexpr int patience = 900'000;  // milliseconds

struct Said {
  int code = -1;
  QString out;
  QString err;
};

Said run(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  process.waitForFinished(patience);
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
          QString::fromUtf8(process.readAllStandardOutput()),
          QString::fromUtf8(process.readAllStandardError())};
}

}  // namespace

class SlideOfficeTest : public QObject {
  Q_OBJECT

 private slots:
  void opensAllOfThem() {
    if (!qEnvironmentVariableIsSet("SLINE_OFFICE"))
      QSKIP("SLINE_OFFICE is not set: tests/thorough.sh office sets it");
    const QString office = QStandardPaths::findExecutable("libreoffice");
    if (office.isEmpty())
      QSKIP("LibreOffice is not installed");
    const QTemporaryDir folder;
    QStringList files;
    std::map<QString, int> slides;
    for (int i = 0; i < decks; ++i) {
      const QString name = QString("deck%1").arg(i);
      files << folder.filePath(name + ".pptx");
      const Status written =
          render::writeSlides(test::oddLesson(i), files.last().toStdString(), {});
      QVERIFY2(written.ok(), written.ok() ? "" : written.error().text().c_str());
      QFile file(files.last());
      QVERIFY(file.open(QIODevice::ReadOnly));
      slides[name] = test::OpenedSlides(file.readAll().toStdString()).slides();
    }
    const Said said =
        run(office, QStringList{"-env:UserInstallation=file://" + folder.filePath("user"),
                                "--headless", "--convert-to", "pdf", "--outdir", folder.path()} +
                        files);
    QCOMPARE(said.code, 0);
    for (const char* complaint : {"repair", "corrupt", "error", "failed to load"})
      QVERIFY2(!said.err.contains(complaint, Qt::CaseInsensitive) &&
                   !said.out.contains(complaint, Qt::CaseInsensitive),
               qPrintable(said.out + said.err));
    for (const auto& [name, count] : slides) {
      const Said info = run("pdfinfo", {folder.filePath(name + ".pdf")});
      QVERIFY2(info.out.contains(QRegularExpression(QString("Pages:\\s+%1\n").arg(count))),
               qPrintable(name + info.out + info.err));
    }
    QFile many(folder.filePath("deck9.pptx"));
    QVERIFY(many.open(QIODevice::ReadOnly));
    const test::OpenedSlides opened(many.readAll().toStdString());
    const Said text = run("pdftotext", {"-l", "1", folder.filePath("deck9.pdf"), "-"});
    const QStringList lines = text.out.split('\n');
    int found = 0;
    for (const auto& [name, group] : test::groupsOn(opened.slide(1)))
      if (name.startsWith("label ")) {
        QVERIFY2(lines.contains(name), qPrintable(name + text.out));
        ++found;
      }
    QVERIFY2(found > 60, qPrintable(QString::number(found)));
  }
};

SLINE_TEST_WITH_GUI(SlideOfficeTest)
#include "slide_office_test.moc"
