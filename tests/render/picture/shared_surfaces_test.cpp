// SPDX-License-Identifier: Apache-2.0
// Tests scenes that have one surface thousands of times.
#include <QtTest>
#include <utility>
#include <vector>

#include "tests/render/picture/scenes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::test;
using render::PictureSettings;

class SharedSurfacesTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void oneSurfaceManyTimes_data();
  void oneSurfaceManyTimes();

 private:
  Studio m_studio;
};

namespace {

const PictureSettings settings{.width = 640, .height = 480};

model::Scene sceneOf(std::vector<model::Node> nodes) {
  model::Scene scene;
  scene.setNodes(std::move(nodes));
  return scene;
}

model::Camera camera() {
  model::Camera c;
  c.eye = {60.0f, -420.0f, 90.0f};
  return c;
}

}  // namespace

void SharedSurfacesTest::initTestCase() {
  m_studio = openStudio();
  if (!m_studio.absent.empty())
    QSKIP(m_studio.absent.c_str());
  QVERIFY2(m_studio.fault.empty(), m_studio.fault.c_str());
}

void SharedSurfacesTest::oneSurfaceManyTimes_data() {
  QTest::addColumn<float>("gamma");
  QTest::addColumn<float>("opacity");
  QTest::addColumn<int>("fill");
  QTest::addColumn<int>("showing");  // of all, more would change nothing
  QTest::newRow("lines") << 2.0f << 1.0f << int(model::Fill::none) << 1;
  QTest::newRow("lines on paper") << 3.0f << 1.0f << int(model::Fill::paper) << 1;
  QTest::newRow("glass") << 2.0f << 0.7f << int(model::Fill::paper) << 6;
  QTest::newRow("a surface") << 5.0f << 1.0f << int(model::Fill::none) << 1;
}

/// It was refused: five thousand layers, of which one shows, did not fit.
void SharedSurfacesTest::oneSurfaceManyTimes() {
  QFETCH(float, gamma);
  QFETCH(float, opacity);
  QFETCH(int, fill);
  QFETCH(int, showing);
  model::Node node;
  node.mesh = sphere(60.0f, 3);
  node.style = gammaStyle(gamma);
  node.style.opacity = Opacity::clamped(opacity);
  node.style.fill = model::Fill(fill);
  const auto sceneWith = [&](int copies) {
    std::vector<model::Node> nodes(std::size_t(copies), node);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      nodes[i].id = {i + 1};
      nodes[i].style.colour =
          Colour{200, std::uint8_t(i % std::size_t(showing) * 30), std::uint8_t(100)};
    }
    return sceneOf(std::move(nodes));
  };
  const auto many = m_studio.picture->render(sceneWith(5000), camera(), settings);
  QVERIFY2(many.ok(), many.ok() ? "" : many.error().text().c_str());
  QVERIFY(m_studio.picture->timings().layersDrawn <= showing);
  const auto few = m_studio.picture->render(sceneWith(showing), camera(), settings);
  QVERIFY(few.ok());
  QVERIFY(difference(*many, *few).largest <= 1);
  // One of another look is seen among them: those that are alike hide each other alone.
  model::Scene other = sceneWith(5000);
  std::vector<model::Node> nodes = other.nodes();
  nodes.back().mesh = moved(*nodes.back().mesh, 1.2f, {});
  other.setNodes(std::move(nodes));
  const auto larger = m_studio.picture->render(other, camera(), settings);
  QVERIFY(larger.ok());
  QVERIFY(difference(*larger, *few).largest > 100);
}

SLINE_TEST_WITH_EVENTS(SharedSurfacesTest)
#include "shared_surfaces_test.moc"
