// SPDX-License-Identifier: Apache-2.0
// Tests composing a figure by hand: panels, an inset by dragging, saving, exporting, and that
// nothing is lost on closing.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>
#include <QtTest>

#include "model/edit/views.h"
#include "model/figure/figure_file.h"
#include "model/figure/figure_keys.h"
#include "model/scene/visible_structures.h"
#include "render/export/figure/figure_options.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/figure/figure_dialog.h"
#include "widgets/figure/figure_preview.h"

namespace sline::test {

namespace {

using widgets::FigureDialog;
using widgets::FigurePreview;

struct FigureDesktop : WindowFixture {
  FigureDesktop() {
    model::Scene scene;
    scene.append({.name = "ring", .mesh = torus(40.0f, 15.0f, 60, 24)});
    scene.append({.name = "ball", .mesh = moved(*sphere(10.0f, 2), 1.0f, {0, 0, 60})});
    std::vector<model::View> views;
    for (const char* name : {"One", "Two"}) {
      views.push_back({.name = name});
      views.back().camera = model::fittedView(
          scene, views.size() == 1 ? model::AnatomicalView::anterior : model::AnatomicalView::left,
          1.3f);
    }
    scene.setViews(views);
    file = folder.filePath("rings.sline");
    if (!model::writeSceneFile(file.toStdString(), {.scene = scene}).ok() || !drop(file) ||
        !settled())
      qFatal("the scene does not come");
  }
  FigureDialog& open() {
    control<QAction>("composeFigure").trigger();
    auto* dialog = window.findChild<FigureDialog*>();
    if (!dialog || !QTest::qWaitForWindowExposed(dialog) || !drawn(*dialog))
      qFatal("the figure does not come");
    return *dialog;
  }
  static bool drawn(FigureDialog& dialog) {
    return QTest::qWaitFor([&dialog] { return dialog.upToDate(); }, 60'000);
  }

  QTemporaryDir folder;
  QString file;
};

template <class T>
T& part(QObject& dialog, const char* name) {
  T* found = dialog.findChild<T*>(QLatin1String(name));
  if (!found)
    qFatal("there is no %s", name);
  return *found;
}

QString problem(FigureDialog& dialog) {
  return part<QLabel>(dialog, "figureTold").text();
}

}  // namespace

class FigureWindowTest : public QObject {
  Q_OBJECT

 private slots:
  /// It begins with the saved views; a drag in one adds a part of it.
  void panelsAndInsets() {
    FigureDesktop desk;
    FigureDialog& dialog = desk.open();
    auto& list = part<QListWidget>(dialog, "figurePanels");
    auto& preview = part<FigurePreview>(dialog, "figurePreview");
    QCOMPARE(list.count(), 2);
    QVERIFY(list.item(1)->text().contains("Two"));
    QVERIFY(!preview.picture().isNull());
    const QImage before = preview.picture();
    dragMouse(preview, preview.onScreen({30, 20}).toPoint(), preview.onScreen({60, 40}).toPoint());
    QTRY_COMPARE(list.count(), 3);
    QVERIFY(desk.drawn(dialog));
    QVERIFY(preview.picture() != before);
    const model::PanelInset inset = *dialog.figure().panels[2].inset;
    QCOMPARE(inset.of, std::string("a"));
    QVERIFY(std::abs(inset.part.at.x - 30.0f) < 1.0f && std::abs(inset.part.size.x - 30.0f) < 1.0f);
    QVERIFY2(problem(dialog).isEmpty(), qPrintable(problem(dialog)));
    // The first panel moves down; the inset stays with it.
    list.setCurrentRow(0);
    part<QToolButton>(dialog, "figureDown").click();
    QTRY_COMPARE(dialog.figure().panels[0].view, std::string("Two"));
    QCOMPARE(dialog.figure().panels[2].inset->of, std::string("b"));
    QVERIFY(desk.drawn(dialog));
    part<QToolButton>(dialog, "figureRemove").click();
    QTRY_COMPARE(list.count(), 1);
  }

  void fieldsChangeTheFigure() {
    FigureDesktop desk;
    FigureDialog& dialog = desk.open();
    auto& width = part<QComboBox>(dialog, "figureWidth");
    width.setCurrentIndex(width.findData("single"));
    QCOMPARE(dialog.figure().widthMm, 85.0f);
    QVERIFY(desk.drawn(dialog));
    QTRY_COMPARE(part<QDoubleSpinBox>(dialog, "figureWidthMm").value(), 85.0);
    auto& list = part<QListWidget>(dialog, "figurePanels");
    list.setCurrentRow(1);
    auto& camera = part<QComboBox>(dialog, "panelCamera");
    camera.setCurrentIndex(camera.findData("like a"));
    QCOMPARE(dialog.figure().panels[1].camera->like, std::string("a"));
    QVERIFY(desk.drawn(dialog));
    // 5 pt letters: told with their panel, and nothing is written.
    part<QDoubleSpinBox>(dialog, "figurePoints").setValue(5.0);
    QVERIFY(desk.drawn(dialog));
    QVERIFY2(problem(dialog).contains("4 pt"), qPrintable(problem(dialog)));
    QVERIFY(!part<QPushButton>(dialog, "figureExport").isEnabled());
    const QString target = desk.folder.filePath("no.pdf");
    dialog.exportFile(target);
    QTRY_VERIFY(problem(dialog).contains("pt"));
    QVERIFY(!QFile::exists(target));
  }

  /// What each field does is said under the mouse.
  void fieldsAreTold() {
    FigureDesktop desk;
    FigureDialog& dialog = desk.open();
    part<QListWidget>(dialog, "figurePanels").setCurrentRow(1);
    for (const char* name :
         {"figureWidth",     "figureWidthMm",      "figureHeightMm",      "figureColumns",
          "figureLetters",   "figureLetterPoints", "figurePoints",        "figurePen",
          "figureLegend",    "figureProjection",   "figureThinLines",     "figureLabels",
          "figureScaleBars", "figureSides",        "figureBlackAndWhite", "panelView",
          "panelCamera",     "panelColumns",       "panelRows",           "panelLabels",
          "panelScaleBar"})
      QVERIFY2(!part<QWidget>(dialog, name).toolTip().isEmpty(), name);
  }

  /// The window can set what the figure's file can say, except what is laid out by hand, and has
  /// the command line's options with the same defaults.
  void asTheCommandLine() {
    FigureDesktop desk;
    FigureDialog& dialog = desk.open();
    auto& list = part<QListWidget>(dialog, "figurePanels");
    list.setCurrentRow(1);
    auto& camera = part<QComboBox>(dialog, "panelCamera");
    camera.setCurrentIndex(camera.findData("like a"));
    QVERIFY(desk.drawn(dialog));
    const QStringList byHand{"figure sline_figure", "figure scene", "figure panels", "figure rows",
                             "panel scene",         "panel inset",  "panel at",      "camera fit",
                             "camera like",         "inset of",     "inset part",    "inset inside",
                             "inset lines"};
    for (const model::FigureKeyNote& key : model::figureKeyNotes()) {
      const QString object = QLatin1String(key.object);
      if (byHand.contains(object + ' ' + QLatin1String(key.id)))
        continue;
      QString name = object == "figure" ? "figure" : "panel";
      for (QString word : QString::fromLatin1(key.id).split('_'))
        name += word.replace(0, 1, word.front().toUpper());
      if (name == "figureHeight")
        name += "Mm";
      QVERIFY2(dialog.findChild<QWidget*>(name), qPrintable(name));
    }
    const render::ExportOrder usual = render::usualFigureOrder();
    for (const render::ExportOption* option : render::figureOptions()) {
      const QString name = QStringLiteral("export-") + QLatin1String(option->id);
      auto& control = part<QWidget>(dialog, qPrintable(name));
      const render::OptionValue value = option->field.read(usual);
      const QString text = QString::fromStdString(render::optionText(*option, value));
      if (auto* box = qobject_cast<QComboBox*>(&control))
        QCOMPARE(box->currentData().toString(), text);
      if (auto* number = qobject_cast<QDoubleSpinBox*>(&control))
        QCOMPARE(number->value(), text.toDouble());
    }
    QCOMPARE(part<QDoubleSpinBox>(dialog, "export-dpi").value(), 600.0);
  }

  /// One scale bar says the scale that all panels have, and a panel may have its own.
  void sameScale() {
    FigureDesktop desk;
    FigureDialog& dialog = desk.open();
    part<QCheckBox>(dialog, "figureSameScale").click();
    QVERIFY(dialog.figure().sameScale);
    QVERIFY(desk.drawn(dialog));
    part<QListWidget>(dialog, "figurePanels").setCurrentRow(1);
    auto& bar = part<QCheckBox>(dialog, "panelScaleBar");
    QVERIFY(!bar.isChecked());
    bar.click();
    QCOMPARE(dialog.figure().panels[1].scaleBar, std::optional(true));
  }

  /// TIFF at the chosen resolution, in single bits where the figure is black and white.
  void printsLineArt() {
    FigureDesktop desk;
    FigureDialog& dialog = desk.open();
    part<QDoubleSpinBox>(dialog, "export-dpi").setValue(100.0);
    auto& depth = part<QComboBox>(dialog, "export-bits");
    depth.setCurrentIndex(depth.findData("1"));
    QTRY_VERIFY_WITH_TIMEOUT(problem(dialog).contains("1 bit"), 60'000);
    QVERIFY(!part<QPushButton>(dialog, "figureExport").isEnabled());
    part<QCheckBox>(dialog, "figureBlackAndWhite").click();
    QVERIFY(desk.drawn(dialog));
    QTRY_VERIFY(part<QPushButton>(dialog, "figureExport").isEnabled());
    const QString picture = desk.folder.filePath("ink.png");
    dialog.exportFile(picture);
    QTRY_VERIFY_WITH_TIMEOUT(problem(dialog).contains("ink.png"), 60'000);
    QCOMPARE(QImage(picture).format(), QImage::Format_Mono);
    QCOMPARE(QImage(picture).width(), 685);
    const QString tiff = desk.folder.filePath("ink.tiff");
    dialog.exportFile(tiff);
    QTRY_VERIFY_WITH_TIMEOUT(problem(dialog).contains("ink.tiff"), 60'000);
    QVERIFY2(QFile::exists(tiff), qPrintable(problem(dialog)));
  }

  /// Writing shows how far it is; Cancel, and closing, leave what was there before.
  void writingCanBeStopped_data() {
    QTest::addColumn<QString>("button");
    QTest::newRow("cancel") << "figureCancel";
    QTest::newRow("close") << "figureClose";
  }
  void writingCanBeStopped() {
    QFETCH(QString, button);
    FigureDesktop desk;
    FigureDialog& dialog = desk.open();
    part<QDoubleSpinBox>(dialog, "export-dpi").setValue(2600.0);
    const QString target = desk.folder.filePath("large.png");
    const QStringList before = QDir(desk.folder.path()).entryList(QDir::AllEntries | QDir::Hidden);
    auto& bar = part<QProgressBar>(dialog, "figureProgress");
    QVERIFY(!bar.isVisible());
    dialog.exportFile(target);
    QTRY_VERIFY_WITH_TIMEOUT(bar.isVisible() && bar.value() > 500, 60'000);
    part<QPushButton>(dialog, qPrintable(button)).click();
    QTRY_VERIFY_WITH_TIMEOUT(problem(dialog).contains("Stopped"), 60'000);
    QVERIFY(!bar.isVisible() && dialog.isVisible());
    QCOMPARE(QDir(desk.folder.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
    QVERIFY(part<QPushButton>(dialog, "figureExport").isEnabled());
  }

  /// A page that is not the figure as it is says so until it is drawn anew, or for as long as it
  /// cannot be drawn; it follows its scenes, the window's and those of other files.
  void staleIsSaid() {
    FigureDesktop desk;
    FigureDialog& dialog = desk.open();
    auto& preview = part<FigurePreview>(dialog, "figurePreview");
    QVERIFY(preview.stale().isEmpty());
    part<QDoubleSpinBox>(dialog, "figureHeightMm").setValue(90.0);
    QVERIFY(!preview.stale().isEmpty() && !dialog.upToDate());
    QVERIFY(desk.drawn(dialog));
    QVERIFY(preview.stale().isEmpty());
    // Panels of 2 mm do not exist: what is shown stays, and is said to be old.
    const QImage shown = preview.picture();
    part<QDoubleSpinBox>(dialog, "figureWidthMm").setValue(60.0);
    part<QDoubleSpinBox>(dialog, "figureColumns").setValue(12.0);
    QVERIFY(desk.drawn(dialog));
    QVERIFY(!problem(dialog).isEmpty());
    QCOMPARE(preview.picture(), shown);
    QVERIFY(!preview.stale().isEmpty());
    part<QDoubleSpinBox>(dialog, "figureWidthMm").setValue(174.0);
    part<QDoubleSpinBox>(dialog, "figureColumns").setValue(2.0);
    QVERIFY(desk.drawn(dialog));
    QVERIFY(preview.stale().isEmpty());
    const QImage before = preview.picture();
    model::Scene scene = desk.session.scene();
    std::vector<model::Node> nodes = scene.nodes();
    nodes.back().style.visible = false;
    scene.setNodes(nodes);
    QVERIFY(desk.session.apply("hide", {scene, true}));
    QVERIFY(!dialog.upToDate() && !preview.stale().isEmpty());
    QVERIFY(desk.drawn(dialog));
    QVERIFY(preview.picture() != before);
  }

  /// A panel follows the file of its scene, too, if the window has another one open.
  void followsOtherFiles() {
    FigureDesktop desk;
    const std::string other = desk.folder.filePath("other.sline").toStdString();
    QVERIFY(model::writeSceneFile(other, {.scene = desk.session.scene()}).ok());
    const QString file = desk.folder.filePath("two.json");
    QFile figure(file);
    QVERIFY(figure.open(QIODevice::WriteOnly));
    figure.write(R"({"sline_figure": 1, "panels": [{"scene": "rings.sline", "view": "One"},
                    {"scene": "other.sline", "view": "One"}]})");
    figure.close();
    FigureDialog& dialog = desk.open();
    dialog.openFile(file);
    QTRY_VERIFY_WITH_TIMEOUT(dialog.figure().panels[1].scene == "other.sline", 60'000);
    QVERIFY(desk.drawn(dialog));
    auto& preview = part<FigurePreview>(dialog, "figurePreview");
    const QImage before = preview.picture();
    model::Scene scene = desk.session.scene();
    std::vector<model::Node> nodes = scene.nodes();
    nodes.back().style.visible = false;
    scene.setNodes(nodes);
    QVERIFY(model::writeSceneFile(other, {.scene = scene}).ok());
    QTRY_VERIFY_WITH_TIMEOUT(!preview.stale().isEmpty(), 60'000);
    QTRY_VERIFY_WITH_TIMEOUT(preview.stale().isEmpty() && preview.picture() != before, 60'000);
  }

  void savedOpenedExported() {
    FigureDesktop desk;
    FigureDialog& dialog = desk.open();
    auto& add = part<QMenu>(dialog, "figureAddMenu");
    emit add.aboutToShow();
    add.actions().first()->trigger();
    QTRY_COMPARE(dialog.figure().panels.size(), std::size_t(3));
    // Its scene does not lie there.
    QTemporaryDir elsewhere;
    QVERIFY(!dialog.saveFile(elsewhere.filePath("figure.json")));
    QVERIFY(!problem(dialog).isEmpty());
    const QString figure = desk.folder.filePath("figure.json");
    QVERIFY2(dialog.saveFile(figure), qPrintable(problem(dialog)));
    const Result<model::Figure> read = model::readFigure(figure.toStdString());
    QVERIFY(read.ok());
    QVERIFY(*read == dialog.figure());
    const QString target = desk.folder.filePath("figure.svg");
    QVERIFY(desk.drawn(dialog));
    dialog.exportFile(target);
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(target), 60'000);
    part<QToolButton>(dialog, "figureRemove").click();
    QTRY_COMPARE(dialog.figure().panels.size(), std::size_t(2));
    dialog.openFile(figure);
    QTRY_COMPARE_WITH_TIMEOUT(dialog.figure().panels.size(), std::size_t(3), 60'000);
    QVERIFY(*read == dialog.figure());
  }

  /// Closing asks where work is in no file, and closes at once where none is.
  void closingAsks() {
    FigureDesktop desk;
    QPointer<FigureDialog> dialog = &desk.open();
    part<QDoubleSpinBox>(*dialog, "figureColumns").setValue(1.0);
    part<QPushButton>(*dialog, "figureClose").click();
    auto* box = dialog->findChild<QMessageBox*>(QStringLiteral("figureAsk"));
    QVERIFY(box && dialog->isVisible());
    box->button(QMessageBox::Cancel)->click();
    QTRY_VERIFY(!dialog->findChild<QMessageBox*>(QStringLiteral("figureAsk")));
    QVERIFY(dialog->isVisible());
    QVERIFY(dialog->saveFile(desk.folder.filePath("kept.json")));
    part<QPushButton>(*dialog, "figureClose").click();
    QTRY_VERIFY(!dialog);
    dialog = &desk.open();
    part<QDoubleSpinBox>(*dialog, "figureColumns").setValue(1.0);
    part<QPushButton>(*dialog, "figureClose").click();
    part<QPushButton>(*dialog, "figureAskDiscard").click();
    QTRY_VERIFY(!dialog);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::FigureWindowTest)
#include "figure_window_test.moc"
