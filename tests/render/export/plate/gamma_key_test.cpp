// SPDX-License-Identifier: Apache-2.0
// Tests what pictures say of Γ that varies over surfaces.
#include "render/export/plate/gamma_key.h"

#include <QTest>
#include <algorithm>

#include "render/export/plate/marks.h"
#include "render/lettering/typesetting.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

model::Scene keyScene(const char* frame = "LPS") {
  model::Scene scene;
  model::Node node;
  node.name = "Sphere";
  node.mesh = sphere(50.0f, 3);
  node.provenance.frame = frame;
  scene.append(std::move(node));
  return scene;
}

ExportOrder keyOrder(const model::Scene& scene, const char* view = "anterior") {
  ExportOrder order;
  order.scene = scene;
  order.viewName = view;
  if (const auto side = model::anatomicalViewNamed(view))
    order.camera = model::anatomicalCamera(*side, scene.visibleBounds(), 160.0f / 90.0f);
  return order;
}

QRectF keyBox(const LetteringItem& item) {
  QRectF box = item.text ? outlineOf(*item.text).boundingRect() : QRectF();
  for (const LetteringShape& shape : item.shapes)
    box |= painterPath(shape.path).boundingRect();
  return box;
}

}  // namespace

class GammaKeyTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    auto made = Typesetting::create();
    QVERIFY(made.ok());
    m_typesetting = std::move(*made);
  }

  /// Where Γ varies, the marks say by what and how, in the picture's language.
  void gammaKeys_data() {
    QTest::addColumn<int>("scalar");
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("title");
    QTest::addColumn<QString>("last");
    QTest::newRow("distance") << int(model::GammaScalar::distance) << "en"
                              << "Distance from Tumour (mm)"
                              << "40";
    QTest::newRow("auf Deutsch") << int(model::GammaScalar::distance) << "de"
                                 << "Abstand von: Tumor (mm)"
                                 << "40";
    QTest::newRow("cavities") << int(model::GammaScalar::occlusion) << "en"
                              << "Depth in cavities, 0 to 1"
                              << "0.8";
    QTest::newRow("Krümmung") << int(model::GammaScalar::curvature) << "de"
                              << "Krümmung (Kugel: 1)"
                              << "0,0";
    QTest::newRow("paint") << int(model::GammaScalar::painted) << "nb"
                           << "Som malt, 0 til 1"
                           << "1,0";
  }
  void gammaKeys() {
    QFETCH(int, scalar);
    QFETCH(QString, language);
    QFETCH(QString, title);
    QFETCH(QString, last);
    ExportOrder order = keyOrder(keyScene());
    order.labels.language = language.toStdString();
    const auto items = [&order] {
      std::vector<LetteringItem> found;
      for (LetteringItem& item : marksOf(order).lettering.items)
        if (item.name.starts_with("gamma"))
          found.push_back(std::move(item));
      return found;
    };
    QVERIFY(items().empty());
    order.scene.append({.name = "Tumour", .mesh = sphere(5.0f, 1)});
    std::vector<model::Node> nodes = order.scene.nodes();
    nodes[0].style.gamma = Gamma::clamped(1.0f);
    nodes[0].style.gammaMap = model::GammaMap{.scalar = model::GammaScalar(scalar),
                                              .curve = usualCurve(model::GammaScalar(scalar))};
    if (scalar == int(model::GammaScalar::distance))
      nodes[0].style.gammaMap->targets = {nodes[1].id};
    if (scalar == int(model::GammaScalar::painted))
      nodes[0].paint =
          std::make_shared<const model::Paint>(nodes[0].mesh->vertexCount(), std::uint8_t(9));
    order.scene.setNodes(nodes);
    const std::vector<LetteringItem> key = items();
    QCOMPARE(key.size(), std::size_t(7));
    QCOMPARE(plainText(key[0].text->lines, QChar('\n')), title);
    QCOMPARE(plainText(key.back().text->lines, QChar('\n')), last);
    // More is drawn where Γ is higher, and all of it lies on the page.
    const bool rises =
        scalar != int(model::GammaScalar::distance) && scalar != int(model::GammaScalar::curvature);
    const LetteringItem& low = rises ? key[1] : key[6];
    const LetteringItem& high = rises ? key[6] : key[1];
    QVERIFY(high.shapes.size() > low.shapes.size());
    for (const LetteringItem& item : key)
      QVERIFY(QRectF(0, 0, 160, 90).contains(keyBox(item)));
    order.marks.gammaKey = false;
    QVERIFY(items().empty());
    order.marks.gammaKey = true;
    order.page.sizeMm = {30.0f, 20.0f};
    for (const LetteringItem& item : items())
      QVERIFY(QRectF(0, 0, 30, 20).contains(keyBox(item)));
  }

 private:
  std::unique_ptr<Typesetting> m_typesetting;
};

}  // namespace sline::test

SLINE_TEST(sline::test::GammaKeyTest)
#include "gamma_key_test.moc"
