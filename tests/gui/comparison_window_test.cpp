// SPDX-License-Identifier: Apache-2.0
// Tests the comparison of techniques by hand: one camera for all, thresholds, the sheet.
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWheelEvent>
#include <QtTest>
#include <glm/geometric.hpp>

#include "model/edit/look.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"
#include "widgets/comparison/comparison_dialog.h"

namespace sline::test {

namespace {

using widgets::ComparisonDialog;
using widgets::ComparisonPicture;

struct ComparisonDesk : WindowFixture {
  ComparisonDesk() {
    session.openMade(QStringLiteral("Ring"), [](const auto&, const auto&) {
      model::Scene scene;
      scene.append({.name = "ring", .mesh = torus(40.0f, 15.0f, 60, 24)});
      scene.append({.name = "ball", .mesh = moved(*sphere(10.0f, 2), 1.0f, {0, 0, 60})});
      return Result<widgets::LoadedDocument>(
          widgets::LoadedDocument{.scene = std::move(scene), .title = QStringLiteral("Ring")});
    });
    if (!settled())
      qFatal("the scene does not come");
  }
  ComparisonDialog& open() {
    control<QAction>("compareTechniques").trigger();
    auto* dialog = window.findChild<ComparisonDialog*>();
    if (!dialog || !QTest::qWaitForWindowExposed(dialog) || !drawn(*dialog))
      qFatal("the comparison does not come");
    return *dialog;
  }
  static bool drawn(ComparisonDialog& dialog) {
    return QTest::qWaitFor([&dialog] { return dialog.upToDate(); }, 60'000);
  }
};

std::vector<QImage> pictures(ComparisonDialog& dialog) {
  std::vector<QImage> all;
  for (const ComparisonPicture* picture : dialog.findChildren<ComparisonPicture*>())
    all.push_back(picture->image());
  return all;
}

int different(const std::vector<QImage>& a, const std::vector<QImage>& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += a[i] != b[i] ? 1 : 0;
  return count;
}

template <class T>
T& part(ComparisonDialog& dialog, const char* name) {
  T* found = dialog.findChild<T*>(QLatin1String(name));
  if (!found)
    qFatal("the dialog has no %s", name);
  return *found;
}

}  // namespace

class ComparisonWindowTest : public QObject {
  Q_OBJECT

 private slots:
  /// Mouse, wheel and keys over one picture turn all of them.
  void turningOneTurnsAll() {
    ComparisonDesk desk;
    ComparisonDialog& dialog = desk.open();
    std::vector<QImage> before = pictures(dialog);
    QCOMPARE(before.size(), std::size_t(9));
    for (const QImage& image : before)
      QVERIFY(!image.isNull() && image.size() == before.front().size());
    const auto allTurned = [&] {
      if (!desk.drawn(dialog))
        return false;
      const std::vector<QImage> now = pictures(dialog);
      const bool all = different(before, now) == 9;
      before = now;
      return all;
    };
    auto& picture = part<widgets::ComparisonPicture>(dialog, "compared_laplacian");
    const QPoint middle = picture.rect().center();
    const model::Camera first = dialog.camera();
    dragMouse(picture, middle, middle + QPoint(30, 20));
    QVERIFY(dialog.camera().eye != first.eye);
    QVERIFY(allTurned());
    const float distance = glm::distance(dialog.camera().eye, dialog.camera().target);
    QWheelEvent notch(middle, picture.mapToGlobal(middle), {}, {0, 120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&picture, &notch);
    QVERIFY(glm::distance(dialog.camera().eye, dialog.camera().target) < distance);
    QVERIFY(allTurned());
    const model::Camera second = dialog.camera();
    QTest::keyClick(&part<widgets::ComparisonPicture>(dialog, "compared_ridges"), Qt::Key_Left);
    QVERIFY(dialog.camera().eye != second.eye);
    const auto distanceOf = [](const model::Camera& camera) {
      return glm::distance(camera.eye, camera.target);
    };
    QVERIFY(std::abs(distanceOf(dialog.camera()) / distanceOf(second) - 1.0f) < 1e-3f);
    QVERIFY(allTurned());
  }

  /// A threshold that is typed changes its own picture, and the scene not at all.
  void thresholdsRedraw() {
    ComparisonDesk desk;
    const model::Scene scene = desk.session.scene();
    ComparisonDialog& dialog = desk.open();
    const std::vector<QImage> before = pictures(dialog);
    auto& slope = part<QDoubleSpinBox>(dialog, "laplacian.slope");
    QCOMPARE(slope.value(), 2.0);
    slope.setFocus();
    slope.selectAll();
    QTest::keyClicks(&slope, QStringLiteral("900"));
    QTest::keyClick(&slope, Qt::Key_Tab);
    QCOMPARE(slope.value(), 900.0);
    QVERIFY(desk.drawn(dialog));
    QCOMPARE(different(before, pictures(dialog)), 1);
    QVERIFY(dialog.order().thresholds.of("laplacian.slope") == 900.0f);
    part<QPushButton>(dialog, "comparisonReset").click();
    QCOMPARE(slope.value(), 2.0);
    QVERIFY(desk.drawn(dialog));
    QCOMPARE(different(before, pictures(dialog)), 0);
    QVERIFY(desk.session.scene() == scene);
  }

  /// What is selected is compared alone; roughened it is drawn in place of itself and saved beside.
  void selectionIsComparedAndRoughened() {
    ComparisonDesk desk;
    desk.session.select({desk.session.scene().nodes()[1].id});
    ComparisonDialog& dialog = desk.open();
    QCOMPARE(dialog.order().models.size(), std::size_t(1));
    QCOMPARE(dialog.order().models.front().scene.nodes().size(), std::size_t(1));
    QCOMPARE(dialog.order().models.front().name, std::string("ball"));
    const std::vector<QImage> before = pictures(dialog);
    QTest::keyClick(&part<QComboBox>(dialog, "comparedSurface"), Qt::Key_Down);
    QVERIFY(desk.drawn(dialog));
    QVERIFY(different(before, pictures(dialog)) > 0);
    QCOMPARE(dialog.order().models.size(), std::size_t(2));
    QVERIFY(QString::fromStdString(dialog.order().models.back().note).startsWith("staircase"));
  }

  /// Of several that are selected each has a row, all turned alike and framed by themselves.
  void eachHasItsRow() {
    ComparisonDesk desk;
    const auto& nodes = desk.session.scene().nodes();
    desk.session.select({nodes[0].id, nodes[1].id});
    ComparisonDialog& dialog = desk.open();
    QCOMPARE(pictures(dialog).size(), std::size_t(18));
    auto models = dialog.order().models;
    QCOMPARE(models.size(), std::size_t(2));
    QCOMPARE(models[1].name, std::string("ball"));
    const auto direction = [](const model::Camera& camera) {
      return glm::normalize(camera.eye - camera.target);
    };
    const auto distance = [](const model::Camera& camera) {
      return glm::distance(camera.eye, camera.target);
    };
    const float ratio = distance(models[0].camera) / distance(models[1].camera);
    QVERIFY(ratio > 3.0f);
    QVERIFY(glm::distance(models[1].camera.target, glm::vec3(0, 0, 60)) < 1.0f);
    // The ball's picture turns the ring, too.
    const std::vector<QImage> before = pictures(dialog);
    auto* ball = dialog.findChildren<ComparisonPicture*>(QStringLiteral("compared_laplacian"))[1];
    QTest::keyClick(ball, Qt::Key_Left);
    QTest::keyClick(ball, Qt::Key_Plus);
    QVERIFY(desk.drawn(dialog));
    models = dialog.order().models;
    QVERIFY(glm::distance(direction(models[0].camera), direction(models[1].camera)) < 1e-4f);
    QVERIFY(std::abs(distance(models[0].camera) / distance(models[1].camera) / ratio - 1.0f) <
            1e-3f);
    QVERIFY(different(before, pictures(dialog)) >= 9);
    // Together they are one model.
    part<QCheckBox>(dialog, "comparedApart").click();
    QVERIFY(desk.drawn(dialog));
    QCOMPARE(pictures(dialog).size(), std::size_t(9));
    QCOMPARE(dialog.order().models.size(), std::size_t(1));
    QCOMPARE(dialog.order().models.front().scene.nodes().size(), std::size_t(2));
  }

  /// The panel has the thresholds of the selection's technique.
  void panelSetsThresholds() {
    ComparisonDesk desk;
    const model::NodeId ring = desk.session.scene().nodes()[0].id;
    desk.session.apply(QStringLiteral("technique"),
                       model::withLook(desk.session.scene(), std::array{ring},
                                       {.technique = model::Technique::laplacian}));
    desk.session.select({ring});
    auto& slope = desk.control<QDoubleSpinBox>("threshold_laplacian.slope");
    auto& margin = desk.control<QDoubleSpinBox>("threshold_confis.margin");
    QVERIFY(!slope.isHidden() && !slope.parentWidget()->isHidden());
    QVERIFY(margin.parentWidget()->isHidden());
    QVERIFY(desk.settled());
    const QImage before = desk.picture();
    const int steps = desk.session.history().count();
    slope.setValue(900.0);
    QCOMPARE(desk.session.history().count(), steps + 1);
    QVERIFY(desk.session.scene().resolve(ring).lineThresholds.of("laplacian.slope") == 900.0f);
    QVERIFY(desk.settled());
    QVERIFY(!difference(before, desk.picture()).isEmpty());
    desk.session.history().undo();
    QCOMPARE(slope.value(), 2.0);
    QVERIFY(desk.session.scene().resolve(ring).lineThresholds.empty());
  }

  void sheetsAreSaved() {
    ComparisonDesk desk;
    ComparisonDialog& dialog = desk.open();
    QTest::keyClick(&part<QPushButton>(dialog, "comparisonSave"), Qt::Key_Space);
    auto* files = dialog.findChild<QFileDialog*>(QStringLiteral("comparisonFileDialog"));
    QVERIFY(files);
    files->reject();
    const QString svg = desk.folder.filePath(QStringLiteral("sheet.svg"));
    dialog.save(svg);
    QVERIFY(!part<QPushButton>(dialog, "comparisonSave").isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(part<QPushButton>(dialog, "comparisonSave").isEnabled(), 120'000);
    QVERIFY(part<QLabel>(dialog, "comparisonTold").text().contains(QStringLiteral("sheet.svg")));
    QFile file(svg);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QVERIFY(text.contains("cell-1-9") && text.contains("Lawonn et al. 2013"));
    dialog.save(desk.folder.filePath(QStringLiteral("sheet.gif")));
    QVERIFY(part<QLabel>(dialog, "comparisonTold").text().contains(QStringLiteral("svg")));
    // Who closes the window at once gets the sheet all the same, and waits for nothing.
    const QString later = desk.folder.filePath(QStringLiteral("later.pdf"));
    dialog.save(later);
    QTest::keyClick(&dialog, Qt::Key_Escape);
    QVERIFY(!dialog.isVisible() && !QFile::exists(later));
    QTRY_VERIFY(!desk.window.findChild<ComparisonDialog*>());
    QVERIFY(desk.settled());
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(later), 120'000);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ComparisonWindowTest)
#include "comparison_window_test.moc"
