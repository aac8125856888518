// SPDX-License-Identifier: Apache-2.0
// Tests finding one's way in the picture: keys, presets, orientation cube, scale bar, flights, and
// another window.
#include <QGridLayout>
#include <QLabel>
#include <QLayout>
#include <QtTest>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "render/labels/orientation_letters.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

class ViewportNavigationTest : public QObject {
  Q_OBJECT

  QTemporaryDir m_body;

  static glm::vec3 back(WindowFixture& f) { return model::cameraFrame(f.viewport().camera()).back; }
  /// Returns the kidney's place on screen and its size.
  static QRect kidney(WindowFixture& f) {
    return f.areaOf(f.session.scene().named("left kidney").front());
  }

 private slots:
  void initTestCase() { writeBody(m_body.path()); }

  void keysMoveTheCamera() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    f.viewport().setFocus();
    const model::Camera before = f.viewport().camera();
    const auto press = [&](Qt::Key key, Qt::KeyboardModifiers with = {}) {
      QTest::keyClick(&f.viewport(), key, with);
    };
    press(Qt::Key_Right);
    const float turned =
        glm::degrees(std::acos(glm::dot(back(f), model::cameraFrame(before).back)));
    QVERIFY2(std::abs(turned - 5.0f) < 0.1f, qPrintable(QString::number(turned)));
    press(Qt::Key_Left);
    press(Qt::Key_Up);
    press(Qt::Key_Down);
    QVERIFY(glm::length(f.viewport().camera().eye - before.eye) < 0.5f);
    const QRect place = kidney(f);
    press(Qt::Key_Right, Qt::ControlModifier);
    QVERIFY(std::abs(kidney(f).center().x() - place.center().x() - 40) <= 2);
    press(Qt::Key_Left, Qt::ControlModifier);
    press(Qt::Key_Plus);
    QVERIFY(kidney(f).width() > place.width() * 1.1);
    press(Qt::Key_Minus);
    QVERIFY(std::abs(kidney(f).width() - place.width()) <= 2);
    QVERIFY(f.settled());
  }

  void zoomToTheSelection() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    QVERIFY(!f.control<QAction>("zoomTo").isEnabled());
    const model::NodeId id = f.session.scene().named("left kidney").front();
    f.session.select({id});
    QTest::keyClick(&f.window, Qt::Key_Period);
    QVERIFY(f.settled());
    const QRect area = kidney(f);
    const QRect picture = f.viewport().rect();
    QVERIFY(picture.contains(area));
    // The kidney's box fills nine tenths, and its near side is larger than the ball.
    QVERIFY(area.width() > 0.6 * std::min(picture.width(), picture.height()));
    QVERIFY((area.center() - picture.center()).manhattanLength() < 20);
    QVERIFY(glm::length(f.viewport().pivot() - glm::vec3(60, 0, 0)) < 1.0f);
    QTest::keyClick(&f.window, Qt::Key_Home);
    QVERIFY(f.settled());
    QVERIFY(kidney(f).height() < 0.5 * picture.height());
  }

  /// The wheel over a place beside the pivot zoomed on between two floats, and no way led back.
  void zoomHasEndsAndComesBack_data() {
    QTest::addColumn<int>("notch");
    QTest::addColumn<bool>("orthographic");
    QTest::newRow("in") << 120 << false;
    QTest::newRow("out") << -120 << false;
    QTest::newRow("in, orthographic") << 120 << true;
    QTest::newRow("out, orthographic") << -120 << true;
  }
  void zoomHasEndsAndComesBack() {
    QFETCH(int, notch);
    QFETCH(bool, orthographic);
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    if (orthographic) {
      model::Camera camera = f.viewport().camera();
      camera.projection = model::Projection::orthographic;
      f.viewport().setCamera(camera);
    }
    const QPointF mouse = f.viewport().rect().center() + QPoint(90, 60);
    const auto turn = [&](int angle) {
      QWheelEvent wheel(mouse, f.viewport().mapToGlobal(mouse), {}, {0, angle}, Qt::NoButton,
                        Qt::NoModifier, Qt::NoScrollPhase, false);
      QCoreApplication::sendEvent(&f.viewport(), &wheel);
    };
    const auto shown = [&] {
      return model::millimetresPerPixel(f.viewport().camera(), f.viewport().pivot(), 1.0f);
    };
    for (int i = 0; i < 250; ++i)
      turn(notch);
    const float whole = glm::length(f.session.scene().visibleBounds().size());
    const float end = notch > 0 ? 1e-4f * whole : 100.0f * whole;
    QVERIFY2(std::abs(shown() / end - 1.0f) < 0.05f, qPrintable(QString::number(shown() / whole)));
    turn(notch);
    QVERIFY(std::abs(shown() / end - 1.0f) < 0.05f);
    turn(-notch);
    const float back = notch > 0 ? 1.15f : 1.0f / 1.15f;
    QVERIFY(std::abs(shown() / (back * end) - 1.0f) < 0.05f);
    QTest::keyClick(&f.window, Qt::Key_Home);
    QVERIFY(f.settled());
    QVERIFY(shown() > 0.3f * whole && shown() < 3.0f * whole);
    QVERIFY(f.viewport().rect().contains(kidney(f)));
  }

  void presetsChangeTheHand() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const QPoint middle = f.viewport().rect().center();
    const model::Camera before = f.viewport().camera();
    QVERIFY(f.window.preferences().set("navigation/mouse", "blender"));
    dragMouse(f.viewport(), middle, middle + QPoint(60, 30));
    QVERIFY(f.viewport().camera() == before);
    dragMouse(f.viewport(), middle, middle + QPoint(60, 30), Qt::MiddleButton);
    QVERIFY(back(f) != model::cameraFrame(before).back);
    QVERIFY(f.window.preferences().set("navigation/mouse", "slicer"));
    const glm::vec3 direction = back(f);
    const glm::vec3 eye = f.viewport().camera().eye;
    dragMouse(f.viewport(), middle, middle - QPoint(0, 80), Qt::RightButton);
    QVERIFY(glm::length(back(f) - direction) < 1e-3f);
    QVERIFY(glm::length(f.viewport().camera().eye - f.viewport().pivot()) <
            glm::length(eye - f.viewport().pivot()));
    QVERIFY(f.settled());
  }

  void escapeGivesTheCameraBack() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    f.viewport().setFocus();
    const model::Camera before = f.viewport().camera();
    const QPoint middle = f.viewport().rect().center();
    sendMouse(f.viewport(), QEvent::MouseButtonPress, middle);
    sendMouse(f.viewport(), QEvent::MouseMove, middle + QPoint(80, 30));
    QVERIFY(!(f.viewport().camera() == before));
    QTest::keyClick(&f.viewport(), Qt::Key_Escape);
    QVERIFY(f.viewport().camera() == before);
    sendMouse(f.viewport(), QEvent::MouseMove, middle + QPoint(90, 30));
    sendMouse(f.viewport(), QEvent::MouseButtonRelease, middle);
    QVERIFY(f.viewport().camera() == before);
    QVERIFY(f.settled());
  }

  void cubeLooksFromItsSides() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    auto& cube = f.control<widgets::CubeMark>("orientationCube");
    QVERIFY(cube.isVisible());
    QVERIFY(f.viewport().rect().contains(cube.geometry()));
    const auto click = [&](const widgets::CubeDirection& part) {
      QTest::mouseClick(&cube, Qt::LeftButton, {}, cube.placeOf(part)->toPoint());
    };
    // From the front the right edge leads to the patient's left.
    click({1, -1, 0});
    QVERIFY(glm::length(back(f) - glm::normalize(glm::vec3(1, -1, 0))) < 1e-4f);
    click({1, 0, 0});
    QVERIFY(glm::length(back(f) - glm::vec3(1, 0, 0)) < 1e-4f);
    QCOMPARE(f.control<QLabel>("letterRight").text(), QStringLiteral("P"));
    click({1, 0, 1});
    click({0, 0, 1});
    QVERIFY(glm::length(back(f) - glm::vec3(0, 0, 1)) < 1e-4f);
    QCOMPARE(f.control<QLabel>("letterRight").text(), QStringLiteral("R"));
    QVERIFY(f.settled());

    // A drag on the cube turns the scene; Escape turns it back.
    const model::Camera before = f.viewport().camera();
    const QPoint middle = cube.rect().center();
    sendMouse(cube, QEvent::MouseButtonPress, middle);
    sendMouse(cube, QEvent::MouseMove, middle + QPoint(30, -12));
    QVERIFY(!(f.viewport().camera() == before));
    QTest::keyClick(&f.viewport(), Qt::Key_Escape);
    QVERIFY(f.viewport().camera() == before);
    sendMouse(cube, QEvent::MouseButtonRelease, middle + QPoint(30, -12));
    QVERIFY(f.viewport().camera() == before);
    f.control<QAction>("showCube").trigger();
    QVERIFY(!cube.isVisible());
    QVERIFY(f.settled());
  }

  void scaleBarAndTime() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    auto& mark = f.control<widgets::ScaleBarMark>("scaleBar");
    QVERIFY(mark.isVisible() && mark.bar());
    // The kidneys are 120 mm from each other, at the pivot's depth or nearly.
    const QRect left = f.areaOf(f.session.scene().named("left kidney").front());
    const QRect right = f.areaOf(f.session.scene().named("right kidney").front());
    const double pixels = std::abs(left.center().x() - right.center().x());
    const double scale = mark.bar()->millimetres / mark.bar()->drawn;
    QVERIFY2(std::abs(pixels * scale - 120.0) < 4.0, qPrintable(QString::number(pixels * scale)));
    f.control<QAction>("showScaleBar").trigger();
    QVERIFY(!mark.isVisible());
    QLabel& time = f.control<QLabel>("frameTime");
    QVERIFY(!time.isVisible());
    f.control<QAction>("showFrameTime").trigger();
    QVERIFY(time.isVisible());
    QVERIFY2(time.text().contains("ms"), qPrintable(time.text()));
    QVERIFY(f.viewport().rect().contains(time.geometry()));
  }

  /// The bar is true in the middle of what is visible, whatever the camera turns around: the same
  /// picture has the same bar.
  void scaleBarIsTrueInEveryView() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    auto& mark = f.control<widgets::ScaleBarMark>("scaleBar");
    const auto scale = [&] { return mark.bar()->millimetres / mark.bar()->drawn; };
    const auto truth = [&] {
      return double(model::millimetresPerPixel(f.viewport().camera(),
                                               f.session.scene().visibleBounds().centre(),
                                               float(f.viewport().height())));
    };
    QVERIFY(mark.bar());
    QVERIFY2(mark.accessibleName().contains("mid-depth"), qPrintable(mark.accessibleName()));
    QCOMPARE(scale(), truth());
    const double before = scale();

    model::Camera nearer = f.viewport().camera();
    QVERIFY(nearer.projection == model::Projection::perspective);
    nearer.target = glm::mix(nearer.target, nearer.eye, 0.3f);
    f.viewport().setPivot(nearer.target);
    QVERIFY(f.settled());
    QCOMPARE(scale(), before);
    f.viewport().travelTo(nearer, f.session.scene(), f.session.scene());
    QVERIFY(f.settled());
    QVERIFY2(std::abs(scale() / before - 1.0) < 1e-4, qPrintable(QString::number(scale())));

    nearer.eye = glm::mix(nearer.eye, nearer.target, 0.4f);
    f.viewport().travelTo(nearer, f.session.scene(), f.session.scene());
    QVERIFY(f.settled());
    QVERIFY(scale() < 0.9 * before);
    QCOMPARE(scale(), truth());
  }

  /// A flight ends at its view, and grasping the picture ends it before.
  void flightsCanBeInterrupted() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    QVERIFY(f.window.preferences().set("navigation/flights", true));
    const model::Camera before = f.viewport().camera();
    QTest::keyClick(&f.window, Qt::Key_L);
    QVERIFY(f.viewport().camera() == before);  // on its way
    QVERIFY(f.settled());
    QVERIFY(glm::length(back(f) - glm::vec3(1, 0, 0)) < 1e-4f);
    QTest::keyClick(&f.window, Qt::Key_A);
    const QPoint middle = f.viewport().rect().center();
    sendMouse(f.viewport(), QEvent::MouseButtonPress, middle);
    const model::Camera held = f.viewport().camera();
    QTest::qWait(300);
    QVERIFY(f.viewport().camera() == held);
    sendMouse(f.viewport(), QEvent::MouseButtonRelease, middle);
    QVERIFY(f.settled());
  }

  /// The same picture is drawn in another window, which has another context.
  void pictureSurvivesAnotherWindow() {
    WindowFixture f;
    QVERIFY(f.drop(m_body.path()));
    QVERIFY(f.settled());
    const QImage before = f.picture();
    const QSize size = f.viewport().size();
    QWidget* home = f.viewport().parentWidget();
    QWidget other;
    f.viewport().setParent(&other);
    f.viewport().setGeometry(QRect(QPoint(), size));
    other.resize(size);
    f.viewport().show();
    other.show();
    QVERIFY(QTest::qWaitForWindowExposed(&other));
    QVERIFY(f.settled());
    QCOMPARE(difference(before, f.picture()), QRect());
    f.viewport().setParent(home);
    static_cast<QGridLayout*>(home->layout())->addWidget(&f.viewport(), 1, 0);
    f.viewport().show();
    other.hide();
    QTRY_COMPARE(f.viewport().size(), size);
    QVERIFY(f.settled());
    QCOMPARE(difference(before, f.picture()), QRect());
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ViewportNavigationTest)
#include "viewport_navigation_test.moc"
