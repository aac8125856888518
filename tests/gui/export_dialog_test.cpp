// SPDX-License-Identifier: Apache-2.0
// Export by hand: every kind of file there is, what is chosen for it, and what stands in the way.
#include <unistd.h>
#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDirIterator>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRadioButton>
#include <QStatusBar>
#include <QToolButton>
#include <QTranslator>
#include <QtTest>

#include "model/edit/visibility.h"
#include "render/export/formats/export_formats.h"
#include "tests/gui/text_fit.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "widgets/export/export_dialog.h"
#include "widgets/export/export_preview.h"
#include "widgets/language/language_switch.h"
#include "widgets/language/languages.h"
#include "widgets/window/message_bar.h"

namespace sline::test {

using widgets::ExportDialog;

namespace {

constexpr int minute = 60'000;

model::Annotation labelOn(model::NodeId structure, const char* english, const char* german) {
  model::Annotation label;
  label.anchors = {model::SurfacePoint{.structure = structure, .triangle = 5}};
  label.text = english;
  label.texts["de"] = german;
  return label;
}

/// A window with two balls, a label on each and two saved views, and hands for the dialog.
struct Desk : WindowFixture {
  QTemporaryDir out;

  explicit Desk(int fineness = 3) { open(fineness); }

  void open(int fineness) {
    session.openMade(QStringLiteral("Balls"), [fineness](const auto&, const auto&) {
      model::Scene scene;
      const model::MeshPtr ball = sphere(20, fineness);
      const auto left =
          scene.append({.name = "left ball", .mesh = moved(*ball, 1.0f, {30.0f, 0.0f, 0.0f})});
      const auto right =
          scene.append({.name = "right ball", .mesh = moved(*ball, 1.0f, {-30.0f, 0.0f, 0.0f})});
      scene.appendAnnotation(labelOn(left, "The left one", "Die linke"));
      scene.appendAnnotation(labelOn(right, "The right one", "Die rechte"));
      model::View front{.name = "Front/ \xE5\xBF\x83"};
      model::View back{.name = "front- \xE5\xBF\x83"};  // the same where case does not count
      back.camera.eye = {0.0f, 1000.0f, 0.0f};
      scene.setViews({front, back});
      return Result<widgets::Loaded>(
          widgets::Loaded{.scene = std::move(scene), .title = QStringLiteral("Balls")});
    });
    if (!settled())
      qFatal("the scene does not come");
  }

  ExportDialog* dialog() { return window.findChild<ExportDialog*>(); }
  ExportDialog& show() {
    QTest::keyClick(&viewport(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    if (!QTest::qWaitFor([this] { return dialog() && dialog()->isVisible(); }))
      qFatal("no dialog");
    return *dialog();
  }
  template <class T>
  T& part(const char* name) {
    T* found = dialog()->findChild<T*>(QLatin1String(name));
    if (!found)
      qFatal("the dialog has no %s", name);
    return *found;
  }
  /// By arrow keys, from the top.
  void chooseKind(const QString& id) {
    auto& kinds = part<QListWidget>("exportKinds");
    kinds.setFocus();
    QTest::keyClick(&kinds, Qt::Key_Home);
    for (int i = 0; i < kinds.count() && kinds.currentItem()->data(Qt::UserRole) != id; ++i)
      QTest::keyClick(&kinds, Qt::Key_Down);
    QCOMPARE(kinds.currentItem()->data(Qt::UserRole).toString(), id);
  }
  void pick(const char* name, const QString& text) {
    auto& box = part<QComboBox>(name);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_Home);
    for (int i = 0; i < box.count() && box.currentText() != text; ++i)
      QTest::keyClick(&box, Qt::Key_Down);
    QCOMPARE(box.currentText(), text);
    // As a click on the entry would; arrow keys say so only where the list is open.
    emit box.activated(box.currentIndex());
  }
  void number(const char* name, double value) {
    auto& box = part<QDoubleSpinBox>(name);
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, QLocale().toString(value, 'f', box.decimals()));
    QTest::keyClick(&box, Qt::Key_Tab);
  }
  void target(const QString& path) {
    auto& line = part<QLineEdit>("exportTarget");
    line.setFocus();
    line.selectAll();
    QTest::keyClick(&line, Qt::Key_Delete);
    // Not every character has a key.
    line.setText(path);
  }
  void click(const char* button) {
    auto& pressed = part<QAbstractButton>(button);
    // Where its box is: a line is longer than its text.
    QTest::mouseClick(&pressed, Qt::LeftButton, {}, {8, pressed.height() / 2});
  }
  /// A small page, so that every kind is quick.
  void small() {
    number("exportWidth", 40);
    number("exportHeight", 30);
  }
  QString message() { return control<widgets::MessageBar>("messageBar").text(); }
  bool exporting() { return window.findChild<QToolButton*>(QStringLiteral("exportCancel")); }
  bool finished() {
    return QTest::qWaitFor([this] { return !exporting(); }, 2 * minute);
  }
  bool previewed() {
    return QTest::qWaitFor([this] { return dialog()->preview().upToDate(); }, minute);
  }
  /// All below the folder that files went to.
  QStringList written() {
    QStringList names;
    for (QDirIterator each(out.path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
         each.hasNext();)
      names << QDir(out.path()).relativeFilePath(each.next());
    names.sort();
    return names;
  }
};

QByteArray contents(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

/// How files begin, by the kind's extension.
bool beginsRight(const QString& extension, const QByteArray& bytes) {
  static const std::map<QString, QList<QByteArray>> begins = {
      {"svg", {"<?xml", "<svg"}},
      {"png", {"\x89PNG\r\n\x1a\n"}},
      {"tif", {QByteArray("II*\0", 4), QByteArray("MM\0*", 4)}},
      {"tiff", {QByteArray("II*\0", 4), QByteArray("MM\0*", 4)}},
      {"exr", {"\x76\x2f\x31\x01"}},
      {"jpg", {"\xff\xd8\xff"}},
      {"pdf", {"%PDF-"}},
      {"glb", {"glTF"}},
      {"webp", {"RIFF"}},
      {"gif", {"GIF8"}},
      {"apkg", {"PK"}},
      {"zip", {"PK"}}};
  if (extension == "mp4")
    return bytes.mid(4, 4) == "ftyp";
  const auto found = begins.find(extension);
  if (found == begins.end())
    return !bytes.isEmpty();
  return std::any_of(found->second.begin(), found->second.end(),
                     [&bytes](const QByteArray& each) { return bytes.startsWith(each); });
}

/// For eyes: SLINE_SCREENSHOTS names a folder that takes the pictures.
void keep(QWidget& widget, const QString& name) {
  const QString folder = qEnvironmentVariable("SLINE_SCREENSHOTS");
  if (!folder.isEmpty())
    QVERIFY(QDir().mkpath(folder) && widget.grab().save(folder + '/' + name + ".png"));
}

}  // namespace

class ExportDialogTest : public QObject {
  Q_OBJECT

  static void kinds() {
    QTest::addColumn<QString>("kind");
    for (const render::ExportFormat& format : render::exportFormats())
      QTest::newRow(format.id) << format.id;
  }

 private slots:
  void everyKind_data() { kinds(); }
  void everyKind() {
    QFETCH(QString, kind);
    Desk desk;
    desk.show();
    desk.chooseKind(kind);
    if (desk.part<QDoubleSpinBox>("exportWidth").isVisible())
      desk.small();
    desk.target(desk.out.filePath(QStringLiteral("ball-心")));
    QTest::keyClick(&desk.part<QLineEdit>("exportTarget"), Qt::Key_Return);
    QVERIFY(desk.finished());
    QVERIFY2(desk.message().contains(QStringLiteral("Exported")), qPrintable(desk.message()));
    const QStringList names = desk.written();
    QVERIFY(!names.isEmpty());
    QVERIFY2(names.front().startsWith(QStringLiteral("ball-心")), qPrintable(names.front()));
    for (const QString& name : names)
      QVERIFY2(beginsRight(QFileInfo(name).suffix(), contents(desk.out.filePath(name))),
               qPrintable(name));
  }

  void optionsReachTheFile() {
    Desk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.pick("exportPaper", QStringLiteral("A5"));
    QVERIFY(desk.part<QDoubleSpinBox>("exportWidth").value() == 210.0);
    desk.click("exportTurn");
    desk.pick("export-background", QStringLiteral("Paper"));
    desk.target(desk.out.filePath(QStringLiteral("page.svg")));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    const QByteArray svg = contents(desk.out.filePath(QStringLiteral("page.svg")));
    QVERIFY(svg.contains("width=\"148mm\" height=\"210mm\""));
    QVERIFY(svg.contains("#faf6ec"));
    QVERIFY(svg.contains("left ball"));
  }

  void pixelsAndMillimetresAreLinked() {
    QString pixels;
    for (const render::ExportFormat& format : render::exportFormats())
      if (widgets::madeOfPixels(QLatin1String(format.id)) && pixels.isEmpty())
        pixels = QLatin1String(format.id);
    if (pixels.isEmpty())
      QSKIP("no kind is made of pixels");
    Desk desk;
    desk.show();
    desk.chooseKind(pixels);
    desk.number("exportDpi", 254);
    desk.number("exportWidth", 100);
    desk.number("exportHeight", 50);
    QVERIFY(desk.part<QLabel>("exportOtherSize").text().contains(QStringLiteral("1,000 × 500")));
    desk.pick("exportUnit", QStringLiteral("px"));
    QCOMPARE(desk.part<QDoubleSpinBox>("exportWidth").value(), 1000.0);
    desk.number("exportWidth", 2000);
    QVERIFY(desk.part<QLabel>("exportOtherSize").text().contains(QStringLiteral("200 × 50")));
    desk.number("exportDpi", 508);
    QCOMPARE(desk.part<QDoubleSpinBox>("exportWidth").value(), 2000.0);
    QVERIFY(desk.part<QLabel>("exportOtherSize").text().contains(QStringLiteral("100 × 25")));
  }

  void eachSavedViewIsAFile() {
    Desk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.small();
    desk.click("exportSavedViews");
    QVERIFY(desk.part<QLabel>("exportSummary").text().contains(QStringLiteral("2 files")));
    desk.target(desk.out.filePath(QStringLiteral("balls.svg")));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    QCOMPARE(desk.written(), (QStringList{QStringLiteral("balls - Front- 心.svg"),
                                          QStringLiteral("balls - front- 心 2.svg")}));
    QVERIFY(contents(desk.out.filePath(desk.written()[0])) !=
            contents(desk.out.filePath(desk.written()[1])));
  }

  void cancelLeavesNothing() {
    Desk desk(7);
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
    Desk desk(6);
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.target(desk.out.filePath(QStringLiteral("before.svg")));
    desk.click("exportButton");
    QVERIFY(desk.exporting());
    // What is done now is not in the file: it is of the scene as it was asked for.
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
    Desk desk;
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
    Desk desk;
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
    Desk desk;
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
    Desk desk;
    const QString file = desk.out.filePath(QStringLiteral("there.svg"));
    QFile there(file);
    QVERIFY(there.open(QIODevice::WriteOnly) && there.write("mine") == 4);
    there.close();
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.small();
    // Without its ending, which it gets: that file is asked about, too.
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

  void previewFollows() {
    Desk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.pick("exportPaper", QStringLiteral("A4"));
    QVERIFY(desk.previewed());
    const QImage first = desk.dialog()->preview().picture();
    QVERIFY(first.width() > first.height());
    desk.click("exportTurn");
    QVERIFY(desk.previewed());
    const QImage upright = desk.dialog()->preview().picture();
    QVERIFY(upright.width() < upright.height());
    desk.pick("export-labels", QStringLiteral("None"));
    QVERIFY(desk.previewed());
    const QImage unlabelled = desk.dialog()->preview().picture();
    QVERIFY2(unlabelled != upright, "labels are in the preview");
    desk.click("exportFilled");
    QVERIFY(desk.previewed());
    const QImage filled = desk.dialog()->preview().picture();
    QVERIFY(filled != unlabelled);
    desk.pick("export-background", QStringLiteral("Dark"));
    QVERIFY(desk.previewed());
    QVERIFY(desk.dialog()->preview().picture().pixelColor(2, 2).lightness() < 80);
  }

  void summaryTellsWhatWillBe() {
    Desk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.pick("exportPaper", QStringLiteral("A4"));
    const auto text = [&desk] { return desk.part<QLabel>("exportSummary").text(); };
    QVERIFY(text().contains(QStringLiteral("2 structures")));
    QVERIFY(text().contains(QStringLiteral("297 × 210 mm")));
    QVERIFY(text().contains(QStringLiteral("2 labels")));
    QVERIFY(text().contains(QStringLiteral("Names of structures")));
    QVERIFY(text().contains(QStringLiteral("MB")));
    desk.pick("export-language", QStringLiteral("Deutsch"));
    QVERIFY(text().contains(QStringLiteral("Deutsch")));
    desk.pick("export-labels", QStringLiteral("None"));
    QVERIFY(text().contains(QStringLiteral("No labels")));
  }

  void choicesAreRemembered() {
    Desk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.pick("exportPaper", QStringLiteral("A5"));
    desk.pick("export-background", QStringLiteral("Paper"));
    desk.number("export-labelSize", 14);
    desk.click("exportFilled");
    desk.click("exportSavedViews");
    desk.target(desk.out.filePath(QStringLiteral("mine.svg")));
    QTest::keyClick(desk.dialog(), Qt::Key_Escape);
    QTRY_VERIFY(!desk.dialog());
    QCOMPARE(desk.written(), QStringList());
    // In the same document all is as it was left; in another the file's name is its own.
    for (const char* name : {"mine.svg", "Balls.svg"}) {
      desk.show();
      QCOMPARE(desk.part<QComboBox>("exportPaper").currentText(), QStringLiteral("A5"));
      QCOMPARE(desk.part<QComboBox>("export-background").currentText(), QStringLiteral("Paper"));
      QCOMPARE(desk.part<QDoubleSpinBox>("export-labelSize").value(), 14.0);
      QVERIFY(desk.part<QRadioButton>("exportSavedViews").isChecked());
      QCOMPARE(QFileInfo(desk.part<QLineEdit>("exportTarget").text()),
               QFileInfo(desk.out.filePath(QLatin1String(name))));
      QTest::keyClick(desk.dialog(), Qt::Key_Escape);
      QTRY_VERIFY(!desk.dialog());
      desk.open(2);
    }
  }

  void badSettingsAreIgnored() {
    Desk desk;
    for (const char* key : {"kind", "subject", "width", "height", "dpi", "options/background",
                            "options/labelSize", "options/labels"})
      desk.settings.setValue(QStringLiteral("export/") + QLatin1String(key),
                             QStringLiteral("nonsense"));
    desk.settings.setValue(QStringLiteral("export/width"), 1e30);
    desk.show();
    QCOMPARE(desk.part<QDoubleSpinBox>("export-labelSize").value(), 10.0);
    QVERIFY(desk.part<QDoubleSpinBox>("exportWidth").value() <= 5000.0);
    QCOMPARE(desk.part<QComboBox>("export-background").currentText(), QStringLiteral("White"));
  }

  void oneDialogAtATime() {
    Desk desk;
    ExportDialog& dialog = desk.show();
    desk.control<QAction>("export").trigger();
    QCOMPARE(desk.window.findChildren<ExportDialog*>(), QList<ExportDialog*>{&dialog});
  }

  void nothingToExport() {
    WindowFixture empty;
    QVERIFY(!empty.control<QAction>("export").isEnabled());
    empty.session.openEmpty(QStringLiteral("Untitled"));
    QVERIFY(!empty.control<QAction>("export").isEnabled());
    Desk desk;
    desk.session.apply(QStringLiteral("hide"), model::withOnlyVisible(desk.session.scene(), {}));
    desk.show();
    QVERIFY(desk.part<QLabel>("exportDoubt").text().contains(QStringLiteral("empty")));
  }

  void textsHaveRoom_data() {
    QTest::addColumn<QString>("speaks");
    for (const widgets::InterfaceLanguage& language : widgets::interfaceLanguages())
      QTest::newRow(qPrintable(language.id)) << language.id;
  }
  void textsHaveRoom() {
    QFETCH(QString, speaks);
    Desk desk;
    widgets::LanguageSwitch language;
    language.use(speaks);
    QCoreApplication::sendPostedEvents();
    desk.control<QAction>("export").trigger();
    QVERIFY(desk.dialog());
    QVERIFY(desk.dialog()->width() <= 1280 && desk.dialog()->height() <= 760);
    QStringList clipped;
    for (const render::ExportFormat& format : render::exportFormats()) {
      desk.chooseKind(QLatin1String(format.id));
      QVERIFY(desk.previewed());
      clipped << clippedTexts(*desk.dialog());
      keep(*desk.dialog(), QStringLiteral("export-%1-%2").arg(QLatin1String(format.id), speaks));
    }
    clipped.removeDuplicates();
    language.use(QStringLiteral("en"));
    QVERIFY2(clipped.isEmpty(), qPrintable('\n' + clipped.join('\n')));
  }

  /// The renderer's table has no translations of its own.
  void kindsAreTranslated_data() { kinds(); }
  void kindsAreTranslated() {
    QFETCH(QString, kind);
    const render::ExportFormat& format = *widgets::formatOf(kind);
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/translations/sline_de.qm")) ||
            german.load(QStringLiteral(":/i18n/sline_de.qm")));
    for (const char* text : {format.title, format.help})
      QVERIFY2(!german.translate("sline::render::ExportFormat", text).isEmpty(), text);
  }
};

}  // namespace sline::test

QTEST_MAIN(sline::test::ExportDialogTest)
#include "export_dialog_test.moc"
