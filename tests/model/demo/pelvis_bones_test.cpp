// SPDX-License-Identifier: Apache-2.0
#include "model/demo/pelvis/bones.h"

#include <QDir>
#include <QFile>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include "model/demo/pelvis/hip_bone.h"
#include "model/geometry/bvh.h"
#include "model/geometry/spatial_order.h"
#include "model/geometry/surface.h"
#include "model/geometry/topology.h"
#include "tests/model/demo/demo_measures.h"
#include "tests/support/suite.h"

using namespace sline;
using test::inside;
using test::volumeOf;

namespace {
long eulerCharacteristic(const model::Mesh& mesh) {
  return long(mesh.vertexCount()) - long(mesh.triangleCount()) / 2;
}

}  // namespace

class PelvisBonesTest : public QObject {
  Q_OBJECT
 private:
  model::Scene m_male;
  model::Scene m_female;
  std::vector<model::DemoStructure> m_bones;

  static model::MeshPtr meshOf(const model::Scene& scene, const char* name) {
    return scene.find(scene.named(name).front())->mesh;
  }

 private slots:
  void initTestCase() {
    m_bones = model::pelvisBones(model::Sex::male);
    m_male = model::demoScene(m_bones);
    m_female = model::demoScene(model::pelvisBones(model::Sex::female));
  }

  void closedAndOfTheRightShape_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("holes");
    QTest::newRow("the obturator foramen") << "left hip bone" << 1;
    QTest::newRow("the obturator foramen, right") << "right hip bone" << 1;
    QTest::newRow("four pairs of foramina and the canal") << "sacrum" << 9;
    QTest::newRow("the vertebral foramen") << "fifth lumbar vertebra" << 1;
    QTest::newRow("left femur") << "left femur" << 0;
    QTest::newRow("right femur") << "right femur" << 0;
    QTest::newRow("disc") << "fifth lumbar intervertebral disc" << 0;
    QTest::newRow("symphysis") << "pubic symphysis" << 0;
  }
  void closedAndOfTheRightShape() {
    QFETCH(QString, name);
    QFETCH(int, holes);
    for (const model::Scene* scene : {&m_male, &m_female}) {
      const model::MeshPtr mesh = meshOf(*scene, name.toUtf8().constData());
      QVERIFY(model::prepareSurface(mesh)->closed);
      QCOMPARE(model::connectedComponents(*mesh).count, std::size_t(1));
      QVERIFY(volumeOf(*mesh) > 0.0);
      QCOMPARE(eulerCharacteristic(*mesh), 2L - 2L * holes);
    }
  }

  // The canal through the foramen is seen through: a line of sight that meets no bone.
  void obturatorForamenIsOpen() {
    const model::MeshPtr hip = meshOf(m_male, "left hip bone");
    const model::Bvh bvh(hip, model::spatialOrder(*hip));
    QVERIFY(!bvh.blocked({.origin = {300, -90, 853}, .direction = {-1, 0, 0}}));
    QVERIFY(bvh.blocked({.origin = {300, -55, 850}, .direction = {-1, 0, 0}}));
  }

  void leftAndRightMirror() {
    for (const char* name : {"hip bone", "femur"}) {
      const auto& left = *std::find_if(m_bones.begin(), m_bones.end(), [&](const auto& bone) {
        return bone.name == std::string("left ") + name;
      });
      const model::MeshPtr right = meshOf(m_male, (std::string("right ") + name).c_str());
      for (glm::vec3 p : right->positions()) {
        p.x = 2.0f * model::pelvisMiddle - p.x;
        QVERIFY(std::abs(left.field(p)) < 0.05f);
      }
    }
  }

  void lieWhereTheMeasuredBonesLie_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("file");
    QTest::addColumn<bool>("cut");
    QTest::newRow("left hip bone") << "left hip bone"
                                   << "*left_hip_bone.obj" << false;
    QTest::newRow("right hip bone") << "right hip bone"
                                    << "*right_hip_bone.obj" << false;
    QTest::newRow("sacrum") << "sacrum"
                            << "*_sacrum.obj" << false;
    QTest::newRow("L5") << "fifth lumbar vertebra"
                        << "*fifth_lumbar_vertebra.obj" << false;
    QTest::newRow("disc") << "fifth lumbar intervertebral disc"
                          << "*intervertebral_disk*" << false;
    // The demo's femora end below the lesser trochanter, so they are compared above the cut.
    QTest::newRow("left femur") << "left femur"
                                << "*left_femur.obj" << true;
    QTest::newRow("right femur") << "right femur"
                                 << "*right_femur.obj" << true;
  }
  void lieWhereTheMeasuredBonesLie() {
    QFETCH(QString, name);
    QFETCH(QString, file);
    QFETCH(bool, cut);
    const QDir folder(QString(SLINE_TEST_DATA) + "/pelvis/bodyparts3d");
    const QStringList found = folder.entryList({file});
    if (found.isEmpty())
      SLINE_ABSENT("the folder pelvis/bodyparts3d of the test data is absent");
    const model::Box made = meshOf(m_male, name.toUtf8().constData())->bounds();
    model::Box real =
        test::boundsOfObj(folder.filePath(found.front()).toStdString(), cut ? made.low.z : -1e9f);
    QVERIFY(!real.empty());
    if (cut)
      real.low.z = made.low.z;
    const glm::vec3 extent = real.size();
    QVERIFY(glm::all(glm::lessThan(glm::abs(made.size() - extent), 0.15f * extent)));
    QVERIFY(glm::all(glm::lessThan(glm::abs(made.centre() - real.centre()), 0.15f * extent)));
  }

  // Textbooks: the neck stands at some 127 degrees to the shaft and points forward by some 12; the
  // greater trochanter's tip is level with the middle of the head, and the lesser one stands out.
  void femurStandsAsInLife_data() {
    QTest::addColumn<bool>("woman");
    QTest::newRow("man") << false;
    QTest::newRow("woman") << true;
  }
  void femurStandsAsInLife() {
    QFETCH(const bool, woman);
    const model::MeshPtr femur = meshOf(woman ? m_female : m_male, "left femur");
    const auto placed = [woman](const glm::vec3& p) {
      return woman ? model::toFemalePelvis(p) : p;
    };
    const glm::vec3 head = placed(model::leftHipJoint);
    const auto middle = [&femur](const auto& counts) {
      glm::vec3 sum(0.0f);
      float count = 0.0f;
      for (const glm::vec3& p : femur->positions())
        if (counts(p)) {
          sum += p;
          ++count;
        }
      return sum / count;
    };
    const auto slab = [&](float low, float high) {
      return middle([low = placed({120, -90, low}).z, high = placed({120, -90, high}).z](
                        const glm::vec3& p) { return p.z > low && p.z < high; });
    };
    const glm::vec3 neck = middle([&head](const glm::vec3& p) {
      const float away = glm::distance(p, head);
      return away > 29.0f && away < 34.0f;
    });
    const glm::vec3 towardsHead = glm::normalize(head - neck);
    const glm::vec3 shaft = glm::normalize(slab(774, 778) - slab(790, 794));
    const float angle = glm::degrees(std::acos(glm::dot(towardsHead, shaft)));
    QVERIFY2(angle > 120.0f && angle < 134.0f, std::to_string(angle).c_str());
    const float forward = glm::degrees(std::atan2(-towardsHead.y, -towardsHead.x));
    QVERIFY2(forward > 5.0f && forward < 20.0f, std::to_string(forward).c_str());

    float tip = 0.0f;
    float knob = 1000.0f;  // the most medial place there
    float below = 1000.0f;
    for (const glm::vec3& p : femur->positions()) {
      if (p.x > head.x + 40.0f)
        tip = std::max(tip, p.z);
      if (std::abs(p.z - placed({105, -73, 809}).z) < 4.0f)
        knob = std::min(knob, p.x);
      if (std::abs(p.z - placed({105, -73, 788}).z) < 3.0f)
        below = std::min(below, p.x);
    }
    QVERIFY2(std::abs(tip - head.z) < 8.0f, std::to_string(tip - head.z).c_str());
    QVERIFY2(knob < below - 4.0f, std::to_string(below - knob).c_str());
  }

  // At most one point in a hundred of the smaller of two bones lies inside the other.
  void bonesDoNotOverlap() {
    for (const model::Scene* scene : {&m_male, &m_female})
      for (const model::Node& a : scene->nodes()) {
        if (a.isGroup())
          continue;
        const model::Bvh bvhA(a.mesh, model::spatialOrder(*a.mesh));
        for (const model::Node& b : scene->nodes()) {
          if (b.isGroup() || a.id >= b.id)
            continue;
          const glm::vec3 low = glm::max(a.mesh->bounds().low, b.mesh->bounds().low);
          const glm::vec3 high = glm::min(a.mesh->bounds().high, b.mesh->bounds().high);
          if (!glm::all(glm::lessThan(low, high)))
            continue;
          const model::Bvh bvhB(b.mesh, model::spatialOrder(*b.mesh));
          constexpr float step = 3.2f;
          int shared = 0;
          for (float z = low.z; z < high.z; z += step)
            for (float y = low.y; y < high.y; y += step)
              for (float x = low.x; x < high.x; x += step)
                shared += inside(bvhA, {x, y, z}) && inside(bvhB, {x, y, z});
          const double smaller = std::min(volumeOf(*a.mesh), volumeOf(*b.mesh));
          QVERIFY2(double(shared) * std::pow(double(step), 3) <= 0.01 * smaller,
                   (a.name + " and " + b.name).c_str());
        }
      }
  }

  void womansPelvisIsWiderAndLower() {
    // These are half the gap between the inferior rami at their middle, and half the width of the
    // inlet.
    const auto nearest = [](const model::Mesh& hip, float low, float high) {
      float x = 1e9f;
      for (const glm::vec3& p : hip.positions())
        if (p.z > low && p.z < high)
          x = std::min(x, p.x - model::pelvisMiddle);
      return x;
    };
    const model::MeshPtr male = meshOf(m_male, "left hip bone");
    const model::MeshPtr female = meshOf(m_female, "left hip bone");
    QVERIFY(nearest(*female, 830, 834) > 1.15f * nearest(*male, 830, 834));
    QVERIFY(nearest(*female, 918, 922) > 1.05f * nearest(*male, 918, 922));
    const glm::vec3 size = meshOf(m_female, "sacrum")->bounds().size();
    const glm::vec3 males = meshOf(m_male, "sacrum")->bounds().size();
    QVERIFY(size.z < 0.97f * males.z && size.x > 1.03f * males.x);
  }

  // The map leads to a woman's pelvis and back.
  void femaleMapHasAnInverse() {
    for (float x = -180; x <= 180; x += 40)
      for (float z = 720; z <= 1090; z += 30) {
        const glm::vec3 p(x, -0.5f * x, z);
        QVERIFY(glm::distance(model::fromFemalePelvis(model::toFemalePelvis(p)), p) < 0.01f);
      }
  }
};

SLINE_TEST(PelvisBonesTest)
#include "pelvis_bones_test.moc"
