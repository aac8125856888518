// SPDX-License-Identifier: Apache-2.0
// Tests that handles stand where the plane is drawn, and that drags follow the mouse.
#include <QTest>
#include <glm/geometric.hpp>

#include "model/camera/camera_moves.h"
#include "tests/support/suite.h"
#include "widgets/sections/section_handles.h"

using namespace sline;
using namespace sline::widgets;

namespace {

constexpr glm::vec2 size(900.0f, 700.0f);
const model::Box body{{-100.0f, -60.0f, -200.0f}, {100.0f, 60.0f, 200.0f}};

model::Camera camera(float turn, float tilt,
                     model::Projection projection = model::Projection::perspective) {
  model::Camera c = model::anatomicalCamera(model::AnatomicalView::anterior, body, size.x / size.y);
  c.projection = projection;
  c.heightMm = 450.0f;
  return orbited(c, {}, turn, tilt);
}

SectionDrag drag(SectionGrip grip, const SectionFrame& frame, const model::Camera& c,
                 const glm::vec2& pixel) {
  return SectionDrag({.grip = grip, .pixel = pixel, .frame = frame, .camera = c, .size = size});
}

}  // namespace

class SectionHandlesTest : public QObject {
  Q_OBJECT
 private slots:
  void frameHoldsWhatIsCut() {
    const model::Plane plane{.normal = glm::normalize(glm::vec3(1, 2, 3)), .offset = 20.0f};
    const SectionFrame frame = sectionFrame(plane, body);
    QVERIFY(std::abs(plane.distance(frame.centre)) < 1e-3);
    QVERIFY(std::abs(glm::dot(frame.u, frame.v)) < 1e-5f);
    for (int i = 0; i < 8; ++i) {
      const glm::vec3 corner((i & 1) != 0 ? 100.0f : -100.0f, (i & 2) != 0 ? 60.0f : -60.0f,
                             (i & 4) != 0 ? 200.0f : -200.0f);
      QVERIFY(std::abs(glm::dot(corner - frame.centre, frame.u)) <= frame.halfU);
      QVERIFY(std::abs(glm::dot(corner - frame.centre, frame.v)) <= frame.halfV);
      const float along = glm::dot(corner, plane.normal);
      QVERIFY(along >= frame.lowest - 1e-3f && along <= frame.highest + 1e-3f);
    }
  }

  void handlesStandOnThePlane() {
    const model::Plane plane{.normal = {1, 0, 0}, .offset = 10.0f};
    const SectionFrame frame = sectionFrame(plane, body);
    const model::Camera c = zoomed(camera(-50.0f, 15.0f), {}, 0.8f);
    const auto handles = sectionHandles(frame, c, size);
    QVERIFY(handles);
    QCOMPARE(handles->outline.size(), std::size_t(4));
    const glm::vec2 top = *pixelOf(c, frame.centre + frame.halfV * frame.v, size);
    QVERIFY(glm::length(handles->slide - top) < 0.1f);
    // The arrow points to the part that is taken away.
    const glm::vec2 taken =
        *pixelOf(c, frame.centre + frame.halfV * frame.v + 20.0f * plane.normal, size);
    QVERIFY(glm::dot(glm::normalize(taken - top), glm::normalize(handles->tip - top)) > 0.99f);
    QVERIFY(!handles->endOn);
    QCOMPARE(int(gripAt(*handles, handles->slide + glm::vec2(3, 2))), int(SectionGrip::slide));
    QCOMPARE(int(gripAt(*handles, handles->tip)), int(SectionGrip::flip));
    QCOMPARE(int(gripAt(*handles, *handles->turnAboutU)), int(SectionGrip::turnAboutU));
    QCOMPARE(int(gripAt(*handles, *handles->turnAboutV)), int(SectionGrip::turnAboutV));
    QCOMPARE(int(gripAt(*handles, {20, 20})), int(SectionGrip::none));
  }

  void alwaysWithinReach() {
    // The eye is so near that the rectangle's edges are out of the picture; then it is inside the
    // body.
    const SectionFrame frame = sectionFrame({.normal = {1, 0, 0}, .offset = 0.0f}, body);
    const model::Camera close = zoomed(camera(-60.0f, 10.0f), {}, 6.0f);
    const auto handles = sectionHandles(frame, close, size);
    QVERIFY(handles);
    QVERIFY(handles->slide.x > 0 && handles->slide.x < size.x && handles->slide.y > 0 &&
            handles->slide.y < size.y);
    model::Camera away = camera(0.0f, 0.0f);
    away.target = 2.0f * away.eye;  // looks the other way
    QVERIFY(!sectionHandles(frame, away, size));
  }

  /// The point of the plane under the mouse stays under the mouse.
  void slideFollows_data() {
    QTest::addColumn<float>("turn");
    QTest::addColumn<float>("tilt");
    QTest::addColumn<int>("projection");
    const int perspective = int(model::Projection::perspective);
    const int parallel = int(model::Projection::orthographic);
    QTest::newRow("from the front") << 0.0f << 0.0f << perspective;
    QTest::newRow("oblique") << -40.0f << 20.0f << perspective;
    QTest::newRow("nearly along") << -65.0f << 5.0f << perspective;
    QTest::newRow("parallel") << 30.0f << -20.0f << parallel;
  }
  void slideFollows() {
    QFETCH(float, turn);
    QFETCH(float, tilt);
    QFETCH(int, projection);
    const model::Plane plane{.normal = {1, 0, 0}, .offset = -15.0f};
    const SectionFrame frame = sectionFrame(plane, body);
    const model::Camera c = camera(turn, tilt, model::Projection(projection));
    const glm::vec3 held = frame.centre + frame.halfV * frame.v;
    const glm::vec2 from = *pixelOf(c, held, size);
    const SectionDrag slide = drag(SectionGrip::slide, frame, c, from);
    QVERIFY(std::abs(slide.at(from, false).offset - plane.offset) < 1e-3f);
    for (const float way : {-60.0f, 12.5f, 80.0f}) {
      const glm::vec2 to = *pixelOf(c, held + way * plane.normal, size);
      const model::Plane moved = slide.at(to, false);
      QVERIFY(moved.normal == plane.normal);
      QVERIFY2(std::abs(moved.offset - (plane.offset + way)) < 0.2f,
               qPrintable(QString::number(moved.offset)));
    }
    // The plane moves in whole steps, and not out of the body.
    const glm::vec2 to = *pixelOf(c, held + 33.0f * plane.normal, size);
    const float snapped = slide.at(to, true).offset;
    QVERIFY(std::abs(snapped - 18.0f) < 2.6f && std::abs(std::remainder(snapped, 2.0f)) < 1e-3f);
    const glm::vec2 far = *pixelOf(c, held + 150.0f * plane.normal, size);
    QCOMPARE(slide.at(far, false).offset, 100.0f);
  }

  void slideAlongTheSight() {
    // There is no direction to follow on screen: up leads away from the eye.
    const model::Plane plane{.normal = {0, -1, 0}, .offset = 0.0f};
    const SectionFrame frame = sectionFrame(plane, body);
    const SectionDrag slide = drag(SectionGrip::slide, frame, camera(0.0f, 0.0f), {450.0f, 300.0f});
    QVERIFY(slide.at({450.0f, 250.0f}, false).offset < -5.0f);
    QVERIFY(slide.at({450.0f, 350.0f}, false).offset > 5.0f);
  }

  void turnsFollow_data() {
    QTest::addColumn<int>("grip");
    QTest::newRow("about u") << int(SectionGrip::turnAboutU);
    QTest::newRow("about v") << int(SectionGrip::turnAboutV);
  }
  void turnsFollow() {
    QFETCH(int, grip);
    const model::Plane plane{.normal = {1, 0, 0}, .offset = 10.0f};
    const SectionFrame frame = sectionFrame(plane, body);
    const model::Camera c = camera(-40.0f, 10.0f);
    const auto handles = sectionHandles(frame, c, size);
    const bool aboutU = SectionGrip(grip) == SectionGrip::turnAboutU;
    const glm::vec2 ring = aboutU ? *handles->turnAboutU : *handles->turnAboutV;
    const SectionDrag turn = drag(SectionGrip(grip), frame, c, ring);
    QVERIFY(std::abs(turn.turnAt(ring, false)) < 1e-6);
    const glm::vec2 to = ring + glm::vec2(12.0f, 0.0f);
    const model::Plane tilted = turn.at(to, false);
    QVERIFY(std::abs(glm::length(tilted.normal) - 1.0f) < 1e-5f);
    QVERIFY(std::abs(tilted.distance(frame.centre)) < 1e-2);
    const glm::vec3 axis = aboutU ? frame.u : frame.v;
    QVERIFY(std::abs(glm::dot(tilted.normal, axis)) < 1e-5f);
    // The ring itself, on the tilted plane, is nearer to the mouse than it was.
    const glm::vec3 arm = aboutU ? -frame.halfV * frame.v : frame.halfU * frame.u;
    const glm::vec3 turned = frame.centre + arm - glm::dot(arm, tilted.normal) * tilted.normal;
    QVERIFY(glm::length(*pixelOf(c, turned, size) - to) < 7.0f);
    QVERIFY(std::abs(turn.turnAt(to, false)) > 2.0);
    const double snapped = turn.turnAt(ring + glm::vec2(60.0f, 0.0f), true);
    QVERIFY(std::abs(std::remainder(snapped, 15.0)) < 1e-9 && snapped != 0.0);
  }

  void turnSeenAlongTheNormal() {
    // The ring goes away from the eye when it is pushed to the middle.
    const model::Plane plane{.normal = {0, -1, 0}, .offset = 0.0f};
    const SectionFrame frame = sectionFrame(plane, body);
    const model::Camera c = camera(0.0f, 0.0f);
    const auto handles = sectionHandles(frame, c, size);
    QVERIFY(handles->endOn);
    const glm::vec2 ring = *handles->turnAboutV;
    const glm::vec2 inwards = 0.5f * size - ring;
    const SectionDrag turn = drag(SectionGrip::turnAboutV, frame, c, ring);
    const model::Plane tilted = turn.at(ring + 0.3f * inwards, false);
    const glm::vec3 arm = frame.halfU * frame.u;
    const glm::vec3 turned = arm - glm::dot(arm, tilted.normal) * tilted.normal;
    QVERIFY(glm::dot(turned, model::cameraFrame(c).back) < -1.0f);
  }
};

SLINE_TEST(SectionHandlesTest)
#include "section_handles_test.moc"
