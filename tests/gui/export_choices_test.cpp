// SPDX-License-Identifier: Apache-2.0
// Tests the export dialog itself: preview and summary follow what is chosen, choices are
// remembered, and all can be read in every language.
#include <QAction>
#include <QClipboard>
#include <QRadioButton>
#include <QTranslator>

#include "model/edit/visibility.h"
#include "render/export/formats/export_formats.h"
#include "tests/gui/export_desk.h"
#include "tests/gui/text_fit.h"
#include "tests/support/suite.h"
#include "widgets/export/export_files.h"
#include "widgets/language/language_switch.h"
#include "widgets/language/languages.h"

namespace sline::test {

namespace {

/// Saves a picture to look at: SLINE_SCREENSHOTS names a folder that takes the pictures.
void keep(QWidget& widget, const QString& name) {
  const QString folder = qEnvironmentVariable("SLINE_SCREENSHOTS");
  if (!folder.isEmpty())
    QVERIFY(QDir().mkpath(folder) && widget.grab().save(folder + '/' + name + ".png"));
}

}  // namespace

class ExportChoicesTest : public QObject {
  Q_OBJECT

 private slots:
  void pixelsAndMillimetresAreLinked() {
    QString pixels;
    for (const render::ExportFormat& format : render::exportFormats())
      if (widgets::pageUseOf(QLatin1String(format.id)) == render::PageUse::pixels &&
          pixels.isEmpty())
        pixels = QLatin1String(format.id);
    if (pixels.isEmpty())
      QSKIP("no kind is made of pixels");
    ExportDesk desk;
    desk.show();
    desk.chooseKind(pixels);
    desk.number("exportDpi", 254);
    desk.number("exportWidth", 100);
    desk.number("exportHeight", 50);
    const QString other = desk.part<QLabel>("exportOtherSize").text();
    QVERIFY2(other.contains(QStringLiteral("1,000 × 500")), qPrintable(other));
    desk.pick("exportUnit", QStringLiteral("px"));
    QCOMPARE(desk.part<QDoubleSpinBox>("exportWidth").value(), 1000.0);
    desk.number("exportWidth", 2000);
    QVERIFY(desk.part<QLabel>("exportOtherSize").text().contains(QStringLiteral("200 × 50")));
    desk.number("exportDpi", 508);
    QCOMPARE(desk.part<QDoubleSpinBox>("exportWidth").value(), 2000.0);
    QVERIFY(desk.part<QLabel>("exportOtherSize").text().contains(QStringLiteral("100 × 25")));
  }

  void previewFollows() {
    ExportDesk desk;
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

  void eachOfSeveralFilesIsPreviewed() {
    ExportDesk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.target(desk.out.filePath(QStringLiteral("balls.svg")));
    const auto& name = desk.part<QLabel>("exportPageName");
    QVERIFY2(!name.isVisibleTo(desk.dialog()), "there is one file");
    desk.click("exportSavedViews");
    QVERIFY(name.isVisibleTo(desk.dialog()));
    QCOMPARE(name.text(), QStringLiteral("balls - 1 Front- 心.svg (1 of 2)"));
    QVERIFY(!desk.part<QAbstractButton>("exportPageBack").isEnabled());
    QVERIFY(desk.previewed());
    const QImage first = desk.dialog()->preview().picture();
    desk.click("exportPageOn");
    QCOMPARE(name.text(), QStringLiteral("balls - 2 front- 心.svg (2 of 2)"));
    QVERIFY(!desk.part<QAbstractButton>("exportPageOn").isEnabled());
    QVERIFY(desk.previewed());
    QVERIFY(desk.dialog()->preview().picture() != first);
    // The page stays whatever else is chosen, and going back shows the first file again.
    desk.pick("export-labels", QStringLiteral("None"));
    QVERIFY(name.text().endsWith(QStringLiteral("(2 of 2)")));
    desk.click("exportPageBack");
    desk.pick("export-labels", QStringLiteral("Texts"));
    QVERIFY(desk.previewed());
    QCOMPARE(desk.dialog()->preview().picture(), first);
    desk.click("exportSeen");
    QVERIFY(!name.isVisibleTo(desk.dialog()));
  }

  void summaryTellsWhatWillBe() {
    ExportDesk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.pick("exportPaper", QStringLiteral("A4"));
    const auto text = [&desk] { return desk.part<QLabel>("exportSummary").text(); };
    QVERIFY(text().contains(QStringLiteral("2 structures")));
    QVERIFY(text().contains(QStringLiteral("297 × 210 mm")));
    QVERIFY(text().contains(QStringLiteral("2 labels")));
    QVERIFY(text().contains(QStringLiteral("Names of structures")));
    QTRY_VERIFY_WITH_TIMEOUT(text().contains(QStringLiteral("About")), 60'000);
    desk.pick("export-language", QStringLiteral("German"));
    QVERIFY(text().contains(QStringLiteral("German")));
    desk.pick("export-labels", QStringLiteral("None"));
    QVERIFY(text().contains(QStringLiteral("No labels")));
  }

  void slidesHaveAPageOfTheirOwn() {
    ExportDesk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("pptx"));
    const auto text = [&desk] { return desk.part<QLabel>("exportSummary").text(); };
    QVERIFY(!desk.part<QWidget>("exportPaper").isEnabled());
    QVERIFY2(text().contains(QStringLiteral("2 slides, one for each saved view.")),
             qPrintable(text()));
    QVERIFY2(text().contains(QStringLiteral("338.7 × 190.5 mm")), qPrintable(text()));
    QVERIFY2(text().contains(QStringLiteral("texts and notes")), qPrintable(text()));
    QVERIFY(desk.previewed());
    const QImage wide = desk.dialog()->preview().picture();
    keep(*desk.dialog(), QStringLiteral("slides"));
    desk.pick("export-slideShape", QStringLiteral("4 : 3"));
    desk.click("exportSeen");
    QVERIFY(desk.previewed());
    const QImage standard = desk.dialog()->preview().picture();
    QVERIFY(wide.width() * standard.height() > standard.width() * wide.height());
    QVERIFY2(text().contains(QStringLiteral("254 × 190.5 mm")), qPrintable(text()));
    QVERIFY2(text().contains(QStringLiteral("2 structures")), qPrintable(text()));
  }

  /// What a slide says beside its figure, or has as its title, is not in the preview of the figure.
  void slidesArePreviewedWithoutACaption() {
    widgets::ExportSource source;
    model::View view{.name = "Front"};
    view.words.title.text = "From the front";
    view.words.text.text = "Words";
    view.words.description.text = "A ball";
    source.scene.setViews({view});
    widgets::ExportDraft draft;
    draft.subject = render::ViewSubject::all;
    for (const char* kind : {"svg", "pptx"}) {
      draft.kind = QLatin1String(kind);
      const auto pages = widgets::previewedFiles(draft, widgets::exportFiles(draft, source));
      QCOMPARE(pages.size(), std::size_t(1));
      const model::ViewWords& words = pages[0].order.words;
      QCOMPARE(words.title.empty() && words.text.empty(), kind == QByteArray("pptx"));
      QCOMPARE(words.description.text, std::string("A ball"));
    }
  }

  /// One file of all views: what it will be is told, each view can be looked at, and the command
  /// line's defaults are those of the dialog.
  void allViewsInOneFile() {
    ExportDesk desk;
    desk.show();
    const auto text = [&desk] { return desk.part<QLabel>("exportSummary").text(); };
    for (const char* kind : {"png", "svg", "pdf", "anki", "pptx"}) {
      desk.chooseKind(QLatin1String(kind));
      const bool all = desk.part<QRadioButton>("exportSavedViews").isChecked();
      QCOMPARE(all, kind == QByteArray("pptx"));
    }
    desk.chooseKind(QStringLiteral("pdf"));
    QVERIFY(!desk.part<QWidget>("export-sheetPaper").isEnabled());
    desk.click("exportSavedViews");
    QVERIFY(desk.part<QWidget>("export-sheetPaper").isEnabled());
    QVERIFY(!desk.part<QWidget>("exportFilled").isEnabled());
    QVERIFY2(text().contains(QStringLiteral("2 views on about 4 pages")), qPrintable(text()));
    QVERIFY2(text().contains(QStringLiteral("210 × 297 mm")), qPrintable(text()));
    const auto& name = desk.part<QLabel>("exportPageName");
    QVERIFY2(name.text().endsWith(QStringLiteral("(1 of 2)")), qPrintable(name.text()));
    QVERIFY(desk.previewed());
    const QImage first = desk.dialog()->preview().picture();
    desk.click("exportPageOn");
    QVERIFY(desk.previewed());
    QVERIFY(desk.dialog()->preview().picture() != first);
    QTRY_VERIFY_WITH_TIMEOUT(text().contains(QStringLiteral("About")), 60'000);
    keep(*desk.dialog(), QStringLiteral("lesson"));
    desk.pick("export-sheet", QStringLiteral("For teaching, with self-test"));
    QVERIFY2(text().contains(QStringLiteral("on about 8 pages")), qPrintable(text()));
    desk.chooseKind(QStringLiteral("anki"));
    QVERIFY2(text().contains(QStringLiteral("At most 8 cards, in a deck for each view")),
             qPrintable(text()));
    desk.click("export-cardsFind");
    QVERIFY2(text().contains(QStringLiteral("At most 4 cards")), qPrintable(text()));
    desk.chooseKind(QStringLiteral("svg"));
    QVERIFY2(text().contains(QStringLiteral("balls")) || text().contains(QStringLiteral("Balls")),
             qPrintable(text()));
    desk.chooseKind(QStringLiteral("pdf"));
    desk.target(desk.out.filePath(QStringLiteral("lesson.pdf")));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    QCOMPARE(desk.written(), QStringList{QStringLiteral("lesson.pdf")});
  }

  void choicesAreRemembered() {
    ExportDesk desk;
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

  void pictureOnTheClipboard() {
    ExportDesk desk;
    QGuiApplication::clipboard()->clear();
    QTest::keyClick(&desk.viewport(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_VERIFY_WITH_TIMEOUT(!QGuiApplication::clipboard()->image().isNull(), 60'000);
    const QImage copied =
        QGuiApplication::clipboard()->image().convertToFormat(QImage::Format_RGB32);
    QCOMPARE(copied.size(), 2 * desk.viewport().size());
    // The copy shows what is on screen, finer, and its labels besides.
    const QImage shown = desk.picture();
    const QImage coarse =
        copied.scaled(shown.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    // Through the balls, below the leaders of their labels, which part the outlines.
    const int row = shown.rect().center().y() + 20;
    const auto dark = [&coarse, row](int x) { return qGray(coarse.pixel(x, row)) < 200; };
    int both = 0;
    int ink = 0;
    for (int x = 1; x + 1 < shown.width(); ++x) {
      const bool there = qGray(shown.pixel(x, row)) < 160;
      ink += there ? 1 : 0;
      // A finer line may lie in the neighbouring pixel.
      both += there && (dark(x - 1) || dark(x) || dark(x + 1)) ? 1 : 0;
    }
    QVERIFY(ink > 0);
    QCOMPARE(both, ink);
    QVERIFY(!desk.control<QAction>("copyPicture").text().isEmpty());
  }

  void firstPageIsPaper() {
    ExportDesk desk;
    desk.settings.remove(QStringLiteral("export/width"));
    desk.show();
    QCOMPARE(desk.part<QComboBox>("exportPaper").currentText(), QStringLiteral("A4"));
    const bool lies = desk.part<QDoubleSpinBox>("exportWidth").value() >
                      desk.part<QDoubleSpinBox>("exportHeight").value();
    QCOMPARE(lies, desk.viewport().width() > desk.viewport().height());
  }

  void badSettingsAreIgnored() {
    ExportDesk desk;
    for (const char* key : {"kind", "subject", "width", "height", "dpi", "options/background",
                            "options/labelSize", "options/labels"})
      desk.settings.setValue(QStringLiteral("export/") + QLatin1String(key),
                             QStringLiteral("nonsense"));
    desk.settings.setValue(QStringLiteral("export/width"), 1e30);
    desk.show();
    QCOMPARE(desk.part<QDoubleSpinBox>("export-labelSize").value(), 10.0);
    QVERIFY(desk.part<QDoubleSpinBox>("exportWidth").value() <= 5000.0);
    QCOMPARE(desk.part<QComboBox>("export-background").currentText(), QStringLiteral("Paper"));
  }

  void oneDialogAtATime() {
    ExportDesk desk;
    ExportDialog& dialog = desk.show();
    desk.control<QAction>("export").trigger();
    QCOMPARE(desk.window.findChildren<ExportDialog*>(), QList<ExportDialog*>{&dialog});
  }

  void nothingToExport() {
    WindowFixture empty;
    QVERIFY(!empty.control<QAction>("export").isEnabled());
    empty.session.openEmpty(QStringLiteral("Untitled"));
    QVERIFY(!empty.control<QAction>("export").isEnabled());
    ExportDesk desk;
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
    ExportDesk desk;
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

  /// Tests the renderer's table, which has no translations of its own.
  void kindsAreTranslated_data() {
    QTest::addColumn<QString>("kind");
    for (const render::ExportFormat& format : render::exportFormats())
      QTest::newRow(format.id) << format.id;
  }
  void kindsAreTranslated() {
    QFETCH(QString, kind);
    const render::ExportFormat& format = *widgets::formatOf(kind);
    // Title and help are read in the window, where there are no flags.
    QVERIFY2(!QByteArray(format.help).contains("--"), format.help);
    QTranslator german;
    QVERIFY(german.load(QStringLiteral(":/translations/sline_de.qm")));
    for (const char* text : {format.title, format.help})
      QVERIFY2(!german.translate("sline::render::ExportFormat", text).isEmpty(), text);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ExportChoicesTest)
#include "export_choices_test.moc"
