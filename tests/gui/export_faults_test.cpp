// SPDX-License-Identifier: Apache-2.0
// Tests what can prevent export by hand, and that nothing is left or lost then.
#include <unistd.h>

#include <QAction>
#include <QPushButton>
#include <QStatusBar>

#include "model/edit/visibility.h"
#include "tests/gui/export_desk.h"
#include "tests/gui/file_contents.h"
#include "tests/support/suite.h"
#include "widgets/language/language_switch.h"

namespace sline::test {

class ExportFaultsTest : public QObject {
  Q_OBJECT

 private slots:
  void cancelLeavesNothing() {
    ExportDesk desk(7);
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.target(desk.out.filePath(QStringLiteral("large.svg")));
    desk.click("exportButton");
    QVERIFY(desk.exporting());
    QVERIFY2(!desk.control<QAction>("export").isEnabled(), "one at a time");
    QTest::mouseClick(&desk.control<QToolButton>("exportCancel"), Qt::LeftButton);
    QVERIFY(desk.finished());
    QCOMPARE(desk.written(), QStringList());
    QCOMPARE(desk.window.statusBar()->currentMessage(), QStringLiteral("The export was stopped"));
    QVERIFY(desk.control<QAction>("export").isEnabled());
  }

  void windowGoesOnMeanwhile() {
    ExportDesk desk(6);
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.target(desk.out.filePath(QStringLiteral("before.svg")));
    desk.click("exportButton");
    QVERIFY(desk.exporting());
    // An edit made now is not in the file, which shows the scene as it was ordered.
    const model::Scene none;
    desk.session.apply(QStringLiteral("hide"), model::withOnlyVisible(desk.session.scene(), {}));
    desk.window.preferences().set(QStringLiteral("appearance/toolTexts"), true);
    widgets::LanguageSwitch language;
    language.use(QStringLiteral("de"));
    QCoreApplication::sendPostedEvents();
    QVERIFY2(desk.exporting() || !desk.written().isEmpty(), "a change of language ends nothing");
    language.use(QStringLiteral("en"));
    QVERIFY(desk.finished());
    QVERIFY(contents(desk.out.filePath(QStringLiteral("before.svg"))).contains("left ball"));
  }

  void closingAsksWhatBecomesOfIt() {
    ExportDesk desk(7);
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.target(desk.out.filePath(QStringLiteral("large.svg")));
    desk.click("exportButton");
    QVERIFY(desk.exporting());
    QVERIFY(!desk.window.close());
    QTest::keyClick(&desk.control<QDialog>("exportingDialog"), Qt::Key_Escape);
    QTRY_VERIFY(!desk.window.findChild<QDialog*>(QStringLiteral("exportingDialog")));
    QVERIFY(desk.window.isVisible() && desk.exporting());
    QVERIFY(!desk.window.close());
    QTest::mouseClick(&desk.control<QPushButton>("stopExport"), Qt::LeftButton);
    // The scene was made and is saved nowhere, so a question about that comes next.
    QTRY_VERIFY_WITH_TIMEOUT(!desk.window.isVisible() ||
                                 desk.window.findChild<QDialog*>(QStringLiteral("unsavedDialog")),
                             60'000);
    QVERIFY(!desk.exporting());
    QCOMPARE(desk.written(), QStringList());
  }

  void badTargets_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("says");
    QTest::newRow("no folder") << "nowhere/x.svg"
                               << "no folder";
    QTest::newRow("a folder") << "folder.svg"
                              << "is a folder";
    QTest::newRow("below a file") << "file/x.svg"
                                  << "is a file";
    QTest::newRow("no name") << ""
                             << "called";
    QTest::newRow("too long") << QString(300, QLatin1Char('x')) << "too long";
    QTest::newRow("read-only") << "locked/x.svg"
                               << "may not write";
  }
  void badTargets() {
    QFETCH(QString, name);
    QFETCH(QString, says);
    ExportDesk desk;
    QVERIFY(QDir(desk.out.path()).mkdir(QStringLiteral("folder.svg")));
    QVERIFY(QDir(desk.out.path()).mkdir(QStringLiteral("locked")));
    QFile::setPermissions(desk.out.filePath(QStringLiteral("locked")),
                          QFile::ReadOwner | QFile::ExeOwner);
    QFile file(desk.out.filePath(QStringLiteral("file")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    if (name.startsWith(QStringLiteral("locked")) && geteuid() == 0)
      QSKIP("nothing is read-only for the system's owner");
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.target(name.isEmpty() ? QString() : desk.out.filePath(name));
    const auto& doubt = desk.part<QLabel>("exportDoubt");
    QVERIFY(doubt.isVisible());
    QVERIFY2(doubt.text().contains(says), qPrintable(doubt.text()));
    QVERIFY(!desk.part<QPushButton>("exportButton").isEnabled());
    QTest::keyClick(&desk.part<QLineEdit>("exportTarget"), Qt::Key_Return);
    QVERIFY(desk.dialog() && !desk.exporting());
    QCOMPARE(desk.written(), QStringList{QStringLiteral("file")});
  }

  void folderThatGoesAway() {
    ExportDesk desk;
    QVERIFY(QDir(desk.out.path()).mkdir(QStringLiteral("gone")));
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.target(desk.out.filePath(QStringLiteral("gone/x.svg")));
    QVERIFY(desk.part<QPushButton>("exportButton").isEnabled());
    QVERIFY(QDir(desk.out.path()).rmdir(QStringLiteral("gone")));
    desk.click("exportButton");
    QVERIFY(desk.part<QLabel>("exportDoubt").text().contains(QStringLiteral("no folder")));
    QVERIFY(!desk.exporting());
  }

  void fullDiskIsTold() {
    if (!QFile::exists(QStringLiteral("/dev/full")))
      QSKIP("this system has no device without space");
    ExportDesk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.small();
    desk.target(QStringLiteral("/dev/full"));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    QVERIFY2(desk.message().contains(QStringLiteral("/dev/full")), qPrintable(desk.message()));
    QVERIFY2(desk.message().contains(QStringLiteral("space")), qPrintable(desk.message()));
  }

  void replacingAsksOnce() {
    ExportDesk desk;
    const QString file = desk.out.filePath(QStringLiteral("there.svg"));
    QFile there(file);
    QVERIFY(there.open(QIODevice::WriteOnly) && there.write("mine") == 4);
    there.close();
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.small();
    // The name gets the ending that it lacks; the question comes for that file, too.
    desk.target(desk.out.filePath(QStringLiteral("there")));
    desk.click("exportButton");
    QTRY_VERIFY(desk.dialog()->findChild<QDialog*>(QStringLiteral("exportReplaceDialog")));
    QTest::keyClick(desk.dialog()->findChild<QDialog*>(QStringLiteral("exportReplaceDialog")),
                    Qt::Key_Escape);
    QTRY_VERIFY(!desk.dialog()->findChild<QDialog*>(QStringLiteral("exportReplaceDialog")));
    QVERIFY(!desk.exporting());
    QCOMPARE(contents(file), QByteArray("mine"));
    desk.click("exportButton");
    QTRY_VERIFY(desk.dialog()->findChild<QPushButton*>(QStringLiteral("exportReplace")));
    desk.click("exportReplace");
    QTRY_VERIFY(!desk.dialog());
    QVERIFY(desk.finished());
    QVERIFY(contents(file).contains("<svg"));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ExportFaultsTest)
#include "export_faults_test.moc"
