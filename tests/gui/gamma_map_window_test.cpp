// SPDX-License-Identifier: Apache-2.0
// Tests Γ that varies over surfaces in the panel beside the picture, by mouse and keys on the real
// window.
#include <QComboBox>
#include <QToolButton>
#include <QtTest>
#include <cmath>

#include "model/edit/look.h"
#include "tests/gui/gamma_fixture.h"
#include "tests/gui/window_fixture.h"
#include "tests/support/suite.h"
#include "widgets/gamma/gamma_curve.h"

using namespace sline;
using namespace sline::test;
using model::GammaScalar;

namespace {

struct MapFixture : GammaPanelFixture {
  model::NodeId id;

  MapFixture() {
    unfold();
    id = named("bladder");
    session.select({id});
  }
  model::GammaMap map() { return session.scene().resolve(id).gammaMap; }
  QComboBox& scalar() { return control<QComboBox>("gammaMapScalar"); }
  QComboBox& target() { return control<QComboBox>("gammaMapTarget"); }
  widgets::GammaCurve& curve() { return control<widgets::GammaCurve>("gammaMapCurve"); }
  void choose(QComboBox& box, int place) {
    box.setCurrentIndex(place);
    emit box.activated(place);
    QCoreApplication::processEvents();
  }
};

}  // namespace

class GammaMapWindowTest : public QObject {
  Q_OBJECT
 private slots:
  void scalarsAreChosen();
  void pointsAreDragged();
  void pointsComeAndGo();
  void keysMovePoints();
  void targetsAreChosen();
  void severalAreSaid();
};

void GammaMapWindowTest::scalarsAreChosen() {
  MapFixture f;
  const int steps = f.steps();
  QCOMPARE(f.scalar().currentIndex(), 0);
  QVERIFY(!f.curve().isVisible());
  f.choose(f.scalar(), int(GammaScalar::occlusion));
  QCOMPARE(f.map().scalar, GammaScalar::occlusion);
  QVERIFY(f.map().curve == model::usualCurve(GammaScalar::occlusion));
  QVERIFY(f.curve().isVisible());
  QVERIFY(!f.target().isVisible());
  QVERIFY(f.steps() > steps);
  f.session.undo();
  QVERIFY(f.map() == model::GammaMap());
  QVERIFY(!f.curve().isVisible());
  f.choose(f.scalar(), int(GammaScalar::curvature));
  auto& reset = f.control<QToolButton>("gammaMapReset");
  QVERIFY(reset.isEnabled());
  f.click(reset);
  QVERIFY(!f.session.scene().find(f.id)->style.gammaMap);
  QVERIFY(!reset.isEnabled());
}

void GammaMapWindowTest::pointsAreDragged() {
  MapFixture f;
  f.choose(f.scalar(), int(GammaScalar::occlusion));
  widgets::GammaCurve& curve = f.curve();
  const model::GammaMap before = f.map();
  const int steps = f.steps();
  sendMouse(curve, QEvent::MouseButtonPress, curve.placeOf(before.curve[1]));
  sendMouse(curve, QEvent::MouseMove, curve.placeOf({0.6f, 2.0f}));
  // The scene follows while the drag goes on.
  QVERIFY(std::abs(f.map().curve[1].offset - 2.0f) < 0.06f);
  QVERIFY(std::abs(f.map().curve[1].scalar - 0.6f) < 0.02f);
  // No point passes its neighbour, and none leaves the field.
  sendMouse(curve, QEvent::MouseMove, curve.placeOf({0.0f, -4.0f}) + QPointF(-900.0, 900.0));
  QVERIFY(f.map().curve[1].scalar > f.map().curve[0].scalar);
  QCOMPARE(f.map().curve[1].offset, -5.0f);
  sendMouse(curve, QEvent::MouseMove, curve.placeOf({0.8f, 4.0f}));
  sendMouse(curve, QEvent::MouseButtonRelease, curve.placeOf({0.8f, 4.0f}));
  QVERIFY(std::abs(f.map().curve[1].offset - 4.0f) < 0.06f);
  QCOMPARE(f.steps(), steps + 1);
  // Escape takes a drag back.
  const model::GammaMap set = f.map();
  sendMouse(curve, QEvent::MouseButtonPress, curve.placeOf(set.curve[0]));
  sendMouse(curve, QEvent::MouseMove, curve.placeOf({0.1f, -2.0f}));
  QVERIFY(f.map() != set);
  QTest::keyClick(&curve, Qt::Key_Escape);
  QVERIFY(f.map() == set);
  QVERIFY(curve.points() == set.curve);
  QCOMPARE(f.steps(), steps + 1);
}

void GammaMapWindowTest::pointsComeAndGo() {
  MapFixture f;
  f.choose(f.scalar(), int(GammaScalar::occlusion));
  widgets::GammaCurve& curve = f.curve();
  const QPointF place = curve.placeOf({0.5f, -1.0f});
  QTest::mouseDClick(&curve, Qt::LeftButton, {}, place.toPoint());
  QCOMPARE(f.map().curve.size(), std::size_t(3));
  QVERIFY(std::abs(f.map().curve[1].offset + 1.0f) < 0.15f);
  // The new one is chosen.
  QTest::keyClick(&curve, Qt::Key_Delete);
  QCOMPARE(f.map().curve.size(), std::size_t(2));
  QTest::keyClick(&curve, Qt::Key_Delete);
  QCOMPARE(f.map().curve.size(), std::size_t(2));  // a curve has two at least
  QVERIFY(f.session.scene().find(f.id));           // and no key reaches the structure
  for (int i = 0; i < 20; ++i)
    QTest::keyClick(&curve, Qt::Key_Insert);
  QVERIFY(f.map().curve.size() > 2 && f.map().curve.size() <= model::mostGammaPoints);
  QVERIFY(!model::gammaMapFault(f.map()));
}

void GammaMapWindowTest::keysMovePoints() {
  MapFixture f;
  f.choose(f.scalar(), int(GammaScalar::occlusion));
  widgets::GammaCurve& curve = f.curve();
  curve.setFocus();
  QTest::keyClick(&curve, Qt::Key_Space);
  QTest::keyClick(&curve, Qt::Key_Up);
  QTest::keyClick(&curve, Qt::Key_Right);
  QVERIFY(std::abs(f.map().curve[1].offset - 3.05f) < 1e-3f);
  QVERIFY(std::abs(f.map().curve[1].scalar - 0.77f) < 1e-3f);
  QTest::keyClick(&curve, Qt::Key_PageDown);
  QVERIFY(std::abs(f.map().curve[1].offset - 2.05f) < 1e-3f);
  QVERIFY(curve.accessibleDescription().contains(QStringLiteral("2")));
}

void GammaMapWindowTest::targetsAreChosen() {
  MapFixture f;
  f.choose(f.scalar(), int(GammaScalar::distance));
  QVERIFY(f.target().isVisible());
  QCOMPARE(f.map().targets.size(), std::size_t(1));
  QVERIFY(f.map().targets.front() != f.id);
  f.target().showPopup();
  f.target().hidePopup();
  const model::NodeId aorta = f.named("aorta");
  f.choose(f.target(), f.target().findData(qulonglong(aorta.value)));
  QCOMPARE(f.map().targets, std::vector<model::NodeId>{aorta});
  QCOMPARE(f.target().currentData().toULongLong(), qulonglong(aorta.value));
}

void GammaMapWindowTest::severalAreSaid() {
  MapFixture f;
  f.choose(f.scalar(), int(GammaScalar::curvature));
  f.session.select({f.id, f.named("aorta")});
  QCOMPARE(f.scalar().currentIndex(), -1);
  QVERIFY(!f.curve().isVisible());
  f.choose(f.scalar(), int(GammaScalar::occlusion));
  QCOMPARE(f.session.scene().resolve(f.named("aorta")).gammaMap.scalar, GammaScalar::occlusion);
  QCOMPARE(f.map().scalar, GammaScalar::occlusion);
}

SLINE_TEST_WITH_WIDGETS(GammaMapWindowTest)
#include "gamma_map_window_test.moc"
