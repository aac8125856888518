// SPDX-License-Identifier: Apache-2.0
// Tests that an export begins as the window shows it and comes out so, that its preview is what is
// written, and that its size was told truly.
#include <QAction>
#include <QProcess>
#include <QPushButton>
#include <QStandardPaths>

#include <cmath>

#include "model/edit/look.h"
#include "render/export/formats/export_formats.h"
#include "render/export/order/common_options.h"
#include "tests/gui/export_desk.h"
#include "tests/gui/file_contents.h"
#include "tests/support/suite.h"
#include "widgets/export/size_gauge.h"

namespace sline::test {

namespace {

/// Returns the share of cells of 4 × 4 pixels whose mean greys differ by more than a tenth.
double unlike(const QImage& a, const QImage& b) {
  const QSize size = a.size() / 4;
  const auto cells = [&size](const QImage& image) {
    return image.convertToFormat(QImage::Format_RGB32)
        .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  };
  const QImage one = cells(a);
  const QImage other = cells(b);
  int count = 0;
  for (int y = 0; y < size.height(); ++y)
    for (int x = 0; x < size.width(); ++x)
      count += std::abs(qGray(one.pixel(x, y)) - qGray(other.pixel(x, y))) > 25 ? 1 : 0;
  return double(count) / double(size.width() * size.height());
}

/// Returns the share of pixels that are not paper.
double printed(const QImage& page) {
  int count = 0;
  for (int y = 0; y < page.height(); ++y)
    for (int x = 0; x < page.width(); ++x)
      count += qGray(page.pixel(x, y)) < 230 ? 1 : 0;
  return double(count) / double(page.width() * page.height());
}

/// Saves a picture to look at: SLINE_SCREENSHOTS names a folder that takes the pictures.
void keep(const QImage& picture, const QString& name) {
  const QString folder = qEnvironmentVariable("SLINE_SCREENSHOTS");
  if (!folder.isEmpty())
    QVERIFY(QDir().mkpath(folder) && picture.save(folder + '/' + name + ".png"));
}

}  // namespace

class ExportWindowTest : public QObject {
  Q_OBJECT

  static void close(ExportDesk& desk) {
    QTest::keyClick(desk.dialog(), Qt::Key_Escape);
    QTRY_VERIFY(!desk.dialog());
  }
  /// Opens the dialog again; there is no window manager that would give the window the keys back.
  static void again(ExportDesk& desk) {
    QApplication::setActiveWindow(&desk.window);
    desk.show();
  }

  /// Exports what is chosen; the summary must have told its size within a factor of two.
  static void sizeIsTrue(ExportDesk& desk, const QString& kind) {
    desk.target(desk.out.filePath(kind));
    const auto summary = [&desk] { return desk.part<QLabel>("exportSummary").text(); };
    QTRY_VERIFY_WITH_TIMEOUT(summary().contains(QStringLiteral("About")), 240'000);
    static const QRegularExpression about(QStringLiteral("About ([0-9.,]+) (bytes|kB|MB)"));
    const QRegularExpressionMatch match = about.match(summary());
    QVERIFY2(match.hasMatch(), qPrintable(summary()));
    const double unit = match.captured(2) == "MB" ? 1e6 : match.captured(2) == "kB" ? 1e3 : 1.0;
    const double said = unit * QLocale().toDouble(match.captured(1));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    const QStringList written = desk.written().filter(kind.left(3));
    QCOMPARE(written.size(), 1);
    const auto there = double(QFileInfo(desk.out.filePath(written.front())).size());
    qInfo("%s: said %.0f bytes, there are %.0f", qPrintable(kind), said, there);
    QVERIFY(said > 0.5 * there && said < 2.0 * there);
  }

 private slots:
  /// The ground, the labels and the scale bar are the window's, until another choice is made; that
  /// holds until the window shows something else.
  void beginsWithWhatTheWindowShows() {
    ExportDesk desk;
    auto& preferences = desk.window.preferences();
    preferences.set("picture/background", "dark");
    preferences.set("labels/language", "de");
    preferences.set("labels/points", 14);
    desk.control<QAction>("showScaleBar").trigger();
    desk.show();
    const auto chosen = [&desk](const char* name) {
      return desk.part<QComboBox>(name).currentText();
    };
    QCOMPARE(chosen("export-background"), QStringLiteral("Dark"));
    QCOMPARE(chosen("export-labels"), QStringLiteral("Texts"));
    QCOMPARE(chosen("export-language"), QStringLiteral("German"));
    QCOMPARE(desk.part<QDoubleSpinBox>("export-labelSize").value(), 14.0);
    QVERIFY(!desk.part<QAbstractButton>("export-scaleBar").isChecked());
    desk.pick("export-background", QStringLiteral("White"));
    close(desk);
    preferences.set("labels/mode", "numbers");
    again(desk);
    QCOMPARE(chosen("export-background"), QStringLiteral("White"));
    QCOMPARE(chosen("export-labels"), QStringLiteral("Numbers"));
    close(desk);
    // The choice outlives the document, but no change of the window.
    desk.open(2);
    again(desk);
    QCOMPARE(chosen("export-background"), QStringLiteral("White"));
    close(desk);
    preferences.set("picture/background", "paper");
    preferences.set("labels/mode", "off");
    again(desk);
    QCOMPARE(chosen("export-background"), QStringLiteral("Paper"));
    QCOMPARE(chosen("export-labels"), QStringLiteral("None"));
    close(desk);
    desk.open(2);
    again(desk);
    QCOMPARE(chosen("export-background"), QStringLiteral("Paper"));
  }

  /// A window that was never changed exports as the command line does without flags. Two things are
  /// the window's own: its ground, and the language that it speaks.
  void defaultsAreThoseOfTheCommandLine() {
    ExportDesk desk;
    desk.settings.remove(QStringLiteral("export"));
    desk.show();
    render::ExportOrder order;
    order.labels.mode = render::LabelMode::on;
    int compared = 0;
    for (const render::ExportFormat& format : render::exportFormats()) {
      desk.chooseKind(QLatin1String(format.id));
      for (const render::ExportOption* option : render::exportOptions()) {
        auto* control = desk.dialog()->findChild<QWidget*>(QStringLiteral("export-") +
                                                           QLatin1String(option->id));
        if (!control || !format.has(*option) || option == &render::backgroundOption ||
            option == &render::languageOption)
          continue;
        const render::OptionValue standard = option->field.read(order);
        ++compared;
        if (const auto* box = qobject_cast<QComboBox*>(control))
          QCOMPARE(box->currentData().toString().toStdString(),
                   render::optionText(*option, standard));
        else if (const auto* tick = qobject_cast<QAbstractButton*>(control))
          QCOMPARE(tick->isChecked(), std::get<bool>(standard));
        else if (const auto* number = qobject_cast<QDoubleSpinBox*>(control))
          QCOMPARE(number->value(),
                   std::visit(
                       [](const auto& value) {
                         if constexpr (std::is_arithmetic_v<std::decay_t<decltype(value)>>)
                           return double(value);
                         else
                           return std::nan("");
                       },
                       standard));
        else
          --compared;
      }
    }
    QVERIFY(compared > 50);
    QCOMPARE(desk.part<QDoubleSpinBox>("exportDpi").value(), double(order.page.dpi));
  }

  /// Fills, ground and words are in the files as they are on screen.
  void comesOutAsTheWindowShows() {
    ExportDesk desk;
    desk.window.preferences().set("picture/background", "dark");
    desk.window.preferences().set("labels/language", "de");
    model::Style tint;
    tint.fill = model::Fill::tint;
    std::vector<model::NodeId> all;
    for (const model::Node& node : desk.session.scene().nodes())
      all.push_back(node.id);
    desk.session.apply(QStringLiteral("tint"), model::withLook(desk.session.scene(), all, tint));
    QVERIFY(desk.settled());
    const QImage window = desk.picture();
    desk.show();
    desk.chooseKind(QStringLiteral("png"));
    desk.pick("exportUnit", QStringLiteral("px"));
    desk.number("exportDpi", 96);
    desk.number("exportWidth", desk.viewport().width());
    desk.number("exportHeight", desk.viewport().height());
    desk.target(desk.out.filePath(QStringLiteral("same.png")));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    const QImage file(desk.out.filePath(QStringLiteral("same.png")));
    QCOMPARE(file.size(), window.size());
    for (const model::NodeId id : all) {
      const QPoint below = desk.areaOf(id).center() + QPoint(0, desk.areaOf(id).height() / 4);
      const QColor shown = window.pixelColor(below);
      const QColor written = file.pixelColor(below);
      QVERIFY2(std::abs(shown.red() - written.red()) <= 4 &&
                   std::abs(shown.green() - written.green()) <= 4 &&
                   std::abs(shown.blue() - written.blue()) <= 4,
               qPrintable(shown.name() + ' ' + written.name()));
    }
    QCOMPARE(file.pixelColor(2, 2), window.pixelColor(2, 2));
    again(desk);
    desk.chooseKind(QStringLiteral("svg"));
    desk.target(desk.out.filePath(QStringLiteral("same.svg")));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    const QByteArray svg = contents(desk.out.filePath(QStringLiteral("same.svg")));
    QVERIFY(svg.contains("Die linke") && !svg.contains("The left one"));
    QVERIFY(svg.contains(window.pixelColor(2, 2).name().toLatin1()));
  }

  /// The preview of a sheet has the pages that the file has, and they look the same.
  void theSheetsPreviewIsTheSheet_data() {
    QTest::addColumn<QString>("sheet");
    QTest::addColumn<int>("pages");
    QTest::newRow("figure") << QStringLiteral("With title and legend") << 1;
    QTest::newRow("teaching") << QStringLiteral("For teaching, with self-test") << 3;
    QTest::newRow("patient") << QStringLiteral("For a patient") << 1;
  }
  void theSheetsPreviewIsTheSheet() {
    QFETCH(QString, sheet);
    QFETCH(int, pages);
    const QString rasteriser = QStandardPaths::findExecutable("pdftoppm");
    if (rasteriser.isEmpty())
      SLINE_ABSENT("poppler-utils are not installed");
    ExportDesk desk;
    // The balls' size does not depend on how the window frames them.
    const float aspect = float(desk.viewport().width()) / float(desk.viewport().height());
    desk.viewport().setCamera(model::anatomicalCamera(
        model::AnatomicalView::anterior, desk.session.scene().visibleBounds(), 0.5f * aspect));
    QVERIFY(desk.settled());
    desk.show();
    desk.chooseKind(QStringLiteral("pdf"));
    desk.pick("export-sheet", sheet);
    QTest::keyClicks(&desk.part<QLineEdit>("export-sheetTitle"), QStringLiteral("Two balls"));
    QVERIFY(desk.previewed());
    QCOMPARE(desk.dialog()->preview().pages(), std::size_t(pages));
    QVERIFY2(desk.part<QLabel>("exportSummary").text().contains(QStringLiteral("210 × 297 mm")),
             qPrintable(desk.part<QLabel>("exportSummary").text()));
    std::vector<QImage> shown;
    for (int page = 0; page < pages; ++page) {
      if (page > 0)
        desk.click("exportPageOn");
      shown.push_back(desk.dialog()->preview().picture());
    }
    desk.target(desk.out.filePath(QStringLiteral("sheet.pdf")));
    desk.click("exportButton");
    QVERIFY(desk.finished());
    for (int page = 0; page < pages; ++page) {
      const QImage& preview = shown[std::size_t(page)];
      QVERIFY(std::abs(preview.height() * 210.0 / 297.0 - preview.width()) <= 1.0);
      const QString png = desk.out.filePath(QStringLiteral("page"));
      const QString number = QString::number(page + 1);
      QCOMPARE(QProcess::execute(rasteriser, {"-png", "-singlefile", "-f", number, "-l", number,
                                              "-scale-to-x", QString::number(preview.width()),
                                              "-scale-to-y", QString::number(preview.height()),
                                              desk.out.filePath(QStringLiteral("sheet.pdf")), png}),
               0);
      const QImage written(png + QStringLiteral(".png"));
      const double ink = printed(written);
      const double differs = unlike(preview, written);
      qInfo("page %d: %.2f %% of it is printed, %.3f %% differs", page + 1, 100.0 * ink,
            100.0 * differs);
      keep(preview, QStringLiteral("preview-%1-%2").arg(QTest::currentDataTag()).arg(page + 1));
      keep(written, QStringLiteral("written-%1-%2").arg(QTest::currentDataTag()).arg(page + 1));
      QVERIFY(ink > 0.005);
      QVERIFY(differs < 0.003);
      for (int other = 0; other < pages; ++other)
        if (other != page)
          QVERIFY2(unlike(shown[std::size_t(other)], written) > 2.0 * differs,
                   "the measure tells pages apart");
    }
  }

  /// What the summary says of the size is true within a factor of two.
  void sizesAreTrue_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("option");
    for (const char* kind : {"glb", "png", "svg", "pdf", "tiff", "jpeg", "webp-picture"})
      QTest::newRow(kind) << QString(kind) << QString();
    QTest::newRow("a sheet") << QStringLiteral("pdf") << QStringLiteral("sheet");
  }
  void sizesAreTrue() {
    QFETCH(QString, kind);
    QFETCH(QString, option);
    ExportDesk desk(5);
    desk.show();
    desk.chooseKind(kind);
    if (!option.isEmpty())
      desk.pick("export-sheet", QStringLiteral("With title and legend"));
    sizeIsTrue(desk, kind);
  }

  void sizesAreTrueOfAnatomy_data() {
    QTest::addColumn<QString>("scene");
    QTest::newRow("pelvis") << SLINE_TEST_DATA "/pelvis/bodyparts3d";
    QTest::newRow("abdomen") << SLINE_TEST_DATA
        "/abdomen/AbdominalAtlas-2015Sept-Slicer4-4Version.mrml";
  }
  void sizesAreTrueOfAnatomy() {
    QFETCH(QString, scene);
    if (!QFileInfo::exists(scene))
      SLINE_ABSENT("there is no real anatomy to export");
    ExportDesk desk;
    desk.session.openPaths({scene.toStdString()});
    QVERIFY(desk.settled());
    for (const char* kind : {"glb", "svg", "pdf", "png"}) {
      again(desk);
      desk.chooseKind(QLatin1String(kind));
      sizeIsTrue(desk, QLatin1String(kind));
    }
  }

  /// A legend lists what was asked for, in drawings and in the preview.
  void legendsListWhatIsAsked() {
    ExportDesk desk;
    // One of the two loses its label.
    std::vector<model::Annotation> labels = desk.session.scene().annotations();
    model::Scene scene = desk.session.scene();
    labels[1].visible = false;
    scene.setAnnotations(labels);
    desk.session.apply(QStringLiteral("hide"), {scene, true});
    desk.show();
    desk.chooseKind(QStringLiteral("svg"));
    QVERIFY(desk.previewed());
    const QImage without = desk.dialog()->preview().picture();
    const auto listed = [&desk](const QString& choice) {
      if (!desk.dialog())
        again(desk);
      desk.pick("export-legend", choice);
      const QString file = desk.out.filePath(QStringLiteral("legend.svg"));
      QFile::remove(file);
      desk.target(file);
      desk.click("exportButton");
      if (!desk.finished())
        qFatal("nothing is written");
      const QByteArray svg = contents(file);
      return QStringList{svg.contains("legend: left ball") ? "left" : "",
                         svg.contains("legend: right ball") ? "right" : ""};
    };
    desk.pick("export-legend", QStringLiteral("All structures"));
    QVERIFY(desk.previewed());
    QVERIFY(desk.dialog()->preview().picture() != without);
    QCOMPARE(listed(QStringLiteral("All structures")), (QStringList{"left", "right"}));
    QCOMPARE(listed(QStringLiteral("Those with a label")), (QStringList{"left", ""}));
    QCOMPARE(listed(QStringLiteral("On sheets alone")), (QStringList{"", ""}));
    model::Focus focus;
    focus.targets = {desk.session.scene().nodes()[1].id};
    scene.setFocus(focus);
    desk.session.apply(QStringLiteral("focus"), {scene, true});
    QCOMPARE(listed(QStringLiteral("Those in focus")), (QStringList{"", "right"}));
  }

  /// Films are as many pixels as was chosen, whatever the page is.
  void filmsAreAsLargeAsChosen() {
    ExportDesk desk;
    desk.show();
    desk.chooseKind(QStringLiteral("frames"));
    const auto& width = desk.part<QDoubleSpinBox>("export-filmWidth");
    const auto& height = desk.part<QDoubleSpinBox>("export-filmHeight");
    QVERIFY(!width.isEnabled() && height.isEnabled());
    QVERIFY(desk.part<QDoubleSpinBox>("exportWidth").isEnabled());
    for (const auto& [choice, size] :
         {std::pair(QStringLiteral("1280 × 720, HD"), QSize(1280, 720)),
          std::pair(QStringLiteral("1920 × 1080, Full HD"), QSize(1920, 1080)),
          std::pair(QStringLiteral("1080 × 1080, square"), QSize(1080, 1080)),
          std::pair(QStringLiteral("Another size"), QSize(200, 120))}) {
      if (!desk.dialog())
        again(desk);
      desk.pick("export-filmFormat", choice);
      QVERIFY(!desk.part<QDoubleSpinBox>("exportWidth").isEnabled());
      if (choice == QStringLiteral("Another size")) {
        desk.number("export-filmWidth", size.width());
        desk.number("export-filmHeight", size.height());
      } else {
        QVERIFY(!desk.part<QDoubleSpinBox>("export-filmWidth").isEnabled());
      }
      desk.number("export-seconds", 0.2);
      QVERIFY(desk.previewed());
      const QSize shown = desk.dialog()->preview().picture().size();
      QVERIFY(std::abs(double(shown.width()) / shown.height() -
                       double(size.width()) / size.height()) < 0.02);
      const QLocale locale;
      QVERIFY2(
          desk.part<QLabel>("exportSummary")
              .text()
              .contains(QStringLiteral("%1 × %2 pixels")
                            .arg(locale.toString(size.width()), locale.toString(size.height()))),
          qPrintable(desk.part<QLabel>("exportSummary").text()));
      const QString folder = desk.out.filePath(QStringLiteral("f%1").arg(size.width()));
      desk.target(folder);
      desk.click("exportButton");
      QVERIFY(desk.finished());
      QCOMPARE(QImage(QDir(folder).filePath(QDir(folder).entryList(QDir::Files).value(0))).size(),
               size);
    }
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ExportWindowTest)
#include "export_window_test.moc"
