// SPDX-License-Identifier: Apache-2.0
// Tests export by hand: every kind of file there is, and what is chosen for it.
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>

#include "model/camera/camera_moves.h"
#include "model/scene/visible_structures.h"
#include "render/export/formats/export_formats.h"
#include "render/export/motion/film_options.h"
#include "tests/gui/export_desk.h"
#include "tests/gui/file_contents.h"
#include "tests/support/suite.h"
#include "widgets/export/export_files.h"

namespace sline::test {

namespace {

/// Tells whether the file begins as its kind does, by the kind's extension.
bool beginsRight(const QString& extension, const QByteArray& bytes) {
  static const std::map<QString, QList<QByteArray>> begins = {
      {"svg", {"<?xml", "<svg"}},
      {"png", {"\x89PNG\r\n\x1a\n"}},
      {"tif", {QByteArray("II*\0", 4), QByteArray("MM\0*", 4)}},
      {"tiff", {QByteArray("II*\0", 4), QByteArray("MM\0*", 4)}},
      {"exr", {"\x76\x2f\x31\x01"}},
      {"jpg", {"\xff\xd8\xff"}},
      {"jp2", {QByteArray("\0\0\0\x0cjP", 6)}},
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
    ExportDesk desk;
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
    ExportDesk desk;
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

  void inkAloneInVectors() {
    ExportDesk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.small();
    desk.click("export-pureInk");
    desk.target(desk.out.filePath(QStringLiteral("ink.svg")));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    static const QRegularExpression colour(QStringLiteral("\"(#[0-9a-fA-F]{6})\""));
    const QString svg = QString::fromUtf8(contents(desk.out.filePath(QStringLiteral("ink.svg"))));
    QSet<QString> colours;
    for (auto each = colour.globalMatch(svg); each.hasNext();)
      colours << each.next().captured(1);
    QCOMPARE(colours, (QSet<QString>{QStringLiteral("#000000"), QStringLiteral("#ffffff")}));
  }

  /// A film's page has letters fit for a screen, whatever paper was chosen before.
  void filmsHaveAPageOfTheirOwn() {
    widgets::ExportDraft draft;
    draft.kind = QStringLiteral("mp4");
    draft.target = QStringLiteral("/nowhere/a.mp4");
    for (const glm::vec2 size : {glm::vec2(841.0f, 594.0f), glm::vec2(60.0f, 85.0f)})
      for (const auto& [format, aspect] : {std::pair(render::FilmFormat::page, size.x / size.y),
                                           std::pair(render::FilmFormat::hd, 16.0f / 9.0f),
                                           std::pair(render::FilmFormat::square, 1.0f)}) {
        draft.order.page.sizeMm = size;
        draft.order.of<render::FilmOptions>().format = format;
        const glm::vec2 page = widgets::exportFiles(draft, {}).front().order.page.sizeMm;
        QCOMPARE(std::min(page.x, page.y), 106.0f);
        QVERIFY(std::abs(page.x / page.y - aspect) < 1e-4f);
      }
  }

  /// A page that is filled keeps its labels beside the anatomy, as the command line does.
  void filledPagesLeaveRoomForLabels() {
    ExportDesk desk;
    widgets::ExportDraft draft;
    draft.kind = QStringLiteral("svg");
    draft.target = QStringLiteral("/nowhere/a.svg");
    draft.filled = true;
    draft.order.page.sizeMm = {160.0f, 90.0f};
    const auto reach = [&](render::LabelMode mode) {
      draft.order.labels.mode = mode;
      const render::ExportPiece file =
          widgets::exportFiles(
              draft,
              {.scene = desk.session.scene(), .camera = desk.viewport().camera(), .aspect = 1.0f})
              .front();
      const render::ExportOrder ready = render::readyOrder(file);
      float most = 0.0f;
      for (const glm::vec3& p : model::visiblePoints(ready.scene)) {
        const auto place = model::pixelOf(ready.camera, p, ready.page.sizeMm);
        most = std::max(most, std::abs(2.0f * place->x / ready.page.sizeMm.x - 1.0f));
      }
      return most;
    };
    const float bare = reach(render::LabelMode::off);
    QVERIFY2(bare > 0.7f && bare < 0.91f, qPrintable(QString::number(double(bare))));
    QVERIFY(reach(render::LabelMode::on) < bare - 0.1f);
  }

  /// What a view says goes along where the view is exported or is just what is seen.
  void wordsOfViews() {
    widgets::ExportDraft draft;
    draft.kind = QStringLiteral("png");
    draft.target = QStringLiteral("/nowhere/a.png");
    widgets::ExportSource source{.scene = {}, .camera = {}, .title = {}, .seen = {}};
    model::View view{.name = "V", .camera = {.eye = {0.0f, -300.0f, 0.0f}}};
    view.words.text.text = "said";
    source.scene.setViews({view});
    QVERIFY(widgets::exportFiles(draft, source).front().order.words == model::ViewWords());
    source.camera = view.camera;
    QVERIFY(widgets::exportFiles(draft, source).front().order.words == view.words);
    source.camera = {};
    draft.subject = render::ViewSubject::all;
    QVERIFY(widgets::exportFiles(draft, source).front().order.words == view.words);
  }

  void textThatNoSheetHasIsTold() {
    ExportDesk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("pdf"));
    desk.pick("export-sheet", QStringLiteral("For teaching, with self-test"));
    auto& text = desk.part<QPlainTextEdit>("export-sheetText");
    text.setFocus();
    QTest::keyClicks(&text, QStringLiteral("Dear patient"));
    desk.pick("export-sheet", QStringLiteral("With title and legend"));
    const auto& doubt = desk.part<QLabel>("exportDoubt");
    QVERIFY2(doubt.isVisible() && doubt.text().contains(QStringLiteral("patient's sheet")),
             qPrintable(doubt.text()));
    desk.pick("export-sheet", QStringLiteral("For a patient"));
    QVERIFY2(!doubt.text().contains(QStringLiteral("patient's sheet")), qPrintable(doubt.text()));
  }

  /// Remarks on what the files lack come before, as far as the preview shows it, and after.
  void remarksBeforeAndAfter() {
    ExportDesk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("jpeg"));
    const auto& doubt = desk.part<QLabel>("exportDoubt");
    QVERIFY(desk.previewed());
    QVERIFY2(!doubt.isVisible(), qPrintable(doubt.text()));
    desk.small();
    desk.pick("export-background", QStringLiteral("Transparent"));
    QVERIFY2(doubt.text().contains(QStringLiteral("stands on white")), qPrintable(doubt.text()));
    desk.number("export-labelSize", 40);
    QVERIFY(desk.previewed());
    QVERIFY2(doubt.isVisible() && doubt.text().contains(QStringLiteral("2 labels found no room")),
             qPrintable(doubt.text()));
    QVERIFY2(desk.part<QPushButton>("exportButton").isEnabled(), "a remark stops nobody");
    desk.target(desk.out.filePath(QStringLiteral("small.jpg")));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    QVERIFY2(desk.message().contains(QStringLiteral("Exported small.jpg")),
             qPrintable(desk.message()));
    auto& all = desk.control<QPushButton>("messageDetails");
    QVERIFY2(all.isVisible(), qPrintable(desk.message()));
    QTest::mouseClick(&all, Qt::LeftButton);
    auto& dialog = desk.control<QDialog>("messageDialog");
    const QString text = dialog.findChild<QPlainTextEdit*>()->toPlainText();
    for (const char* says : {"2 labels found no room: “The left one”, “The right one”",
                             "stands on white", "smaller letters"})
      QVERIFY2(text.contains(QString::fromUtf8(says)), qPrintable(text));
    dialog.close();
    QTRY_VERIFY(!desk.window.findChild<QDialog*>(QStringLiteral("messageDialog")));
    QApplication::setActiveWindow(&desk.window);  // there is no window manager to do it
    // A file without faults gets the usual message.
    desk.show();
    desk.number("exportWidth", 160);
    desk.number("exportHeight", 90);
    desk.number("export-labelSize", 10);
    desk.pick("export-background", QStringLiteral("White"));
    desk.target(desk.out.filePath(QStringLiteral("fine.jpg")));
    QVERIFY(desk.previewed());
    QVERIFY2(!desk.part<QLabel>("exportDoubt").isVisible(),
             qPrintable(desk.part<QLabel>("exportDoubt").text()));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    QVERIFY(!desk.control<QPushButton>("messageDetails").isVisible());
    QVERIFY2(!desk.message().contains(QStringLiteral("room")), qPrintable(desk.message()));
  }

  /// A credit is typed for one file; it is neither remembered nor taken from the account.
  void creditIsTyped() {
    ExportDesk desk;
    // An older program left this.
    desk.settings.setValue(QStringLiteral("export/options/sheetText"), QStringLiteral("Mrs Roe"));
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.small();
    QCOMPARE(desk.part<QLineEdit>("export-author").text(), QString());
    QCOMPARE(desk.part<QLineEdit>("export-copyright").text(), QString());
    const auto summary = [&desk] { return desk.part<QLabel>("exportSummary").text(); };
    QVERIFY(!summary().contains(QStringLiteral("as you typed")));
    QTest::keyClicks(&desk.part<QLineEdit>("export-author"), QStringLiteral("Jane Roe"));
    QTest::keyClicks(&desk.part<QLineEdit>("export-copyright"), QStringLiteral("CC BY 4.0"));
    QVERIFY2(summary().contains(QStringLiteral("as you typed")), qPrintable(summary()));
    desk.target(desk.out.filePath(QStringLiteral("mine.svg")));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    const QByteArray svg = contents(desk.out.filePath(QStringLiteral("mine.svg")));
    QVERIFY(svg.contains("<dc:title>Jane Roe</dc:title>") && svg.contains("CC BY 4.0"));
    for (const QString& key : desk.settings.allKeys())
      QVERIFY2(!desk.settings.value(key).toString().contains(QStringLiteral("Roe")),
               qPrintable(key));
    // Another document begins without a credit.
    desk.open(2);
    desk.show();
    QCOMPARE(desk.part<QLineEdit>("export-author").text(), QString());
    for (const render::ExportFormat& format : render::exportFormats()) {
      desk.chooseKind(QLatin1String(format.id));
      QVERIFY2(desk.part<QLineEdit>("export-author").isVisibleTo(desk.dialog()), format.id);
    }
  }

  /// Where nothing is typed the field has what the file will say; what is typed is said once.
  void whatTheFileSays() {
    ExportDesk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.small();
    auto* field = &desk.part<QPlainTextEdit>("export-altText");
    QTRY_VERIFY2(field->placeholderText().startsWith(QStringLiteral("Drawing of")),
                 qPrintable(field->placeholderText()));
    QVERIFY(desk.part<QLabel>("exportSummary").text().contains(QStringLiteral("in words")));
    QTest::keyClicks(field, QStringLiteral("off"));
    QVERIFY(!desk.part<QLabel>("exportSummary").text().contains(QStringLiteral("in words")));
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("Balls <&>"));
    desk.target(desk.out.filePath(QStringLiteral("told.svg")));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    const QByteArray svg = contents(desk.out.filePath(QStringLiteral("told.svg")));
    QVERIFY(svg.contains(">Balls &lt;&amp;&gt;</desc>"));
    QApplication::setActiveWindow(&desk.window);
    desk.show();
    QCOMPARE(desk.part<QPlainTextEdit>("export-altText").toPlainText(), QString());
  }

  void eachSavedViewIsAFile() {
    ExportDesk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    desk.small();
    desk.click("exportSavedViews");
    QVERIFY(desk.part<QLabel>("exportSummary").text().contains(QStringLiteral("2 files")));
    desk.target(desk.out.filePath(QStringLiteral("balls.svg")));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    QCOMPARE(desk.written(), (QStringList{QStringLiteral("balls - 1 Front- 心.svg"),
                                          QStringLiteral("balls - 2 front- 心.svg")}));
    QVERIFY(contents(desk.out.filePath(desk.written()[0])) !=
            contents(desk.out.filePath(desk.written()[1])));
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ExportDialogTest)
#include "export_dialog_test.moc"
