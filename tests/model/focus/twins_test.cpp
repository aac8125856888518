// SPDX-License-Identifier: Apache-2.0
// Tests that versions and second bodies are found, and that neighbours in a row are not.
#include "model/focus/twins.h"

#include <QTest>

#include "model/edit/visibility.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {

class TwinsTest : public QObject {
  Q_OBJECT

  static NodeId add(Scene& scene, const std::string& name, float radius, const glm::vec3& at) {
    Node node{.name = name};
    node.mesh = test::moved(*test::sphere(radius, 3), 1.0f, at);
    return scene.append(std::move(node));
  }

 private slots:
  void versions_data() {
    QTest::addColumn<QString>("first");
    QTest::addColumn<QString>("second");
    QTest::addColumn<float>("apart");
    QTest::addColumn<bool>("twins");
    QTest::newRow("numbered by import") << "liver"
                                        << "liver 2" << 0.5f << true;
    QTest::newRow("versions") << "liver_v1"
                              << "liver_v2" << 0.5f << true;
    QTest::newRow("the other way round") << "liver 10"
                                         << "liver 9" << 0.5f << true;
    QTest::newRow("another structure") << "liver"
                                       << "spleen" << 0.5f << false;
    QTest::newRow("vertebrae in a row") << "vertebra 1"
                                        << "vertebra 2" << 25.0f << false;
    QTest::newRow("overlapping ribs") << "rib 8"
                                      << "rib 9" << 6.0f << false;
    QTest::newRow("sides") << "left kidney"
                           << "right kidney" << 0.5f << false;
    QTest::newRow("names that tell nothing") << "Segment_1"
                                             << "Segment_2" << 0.5f << false;
    QTest::newRow("names that are numbers") << "1"
                                            << "2" << 0.5f << false;
  }
  void versions() {
    QFETCH(QString, first);
    QFETCH(QString, second);
    QFETCH(float, apart);
    QFETCH(bool, twins);
    Scene scene;
    add(scene, first.toStdString(), 20.0f, {0, 0, 0});
    add(scene, second.toStdString(), 20.0f, {apart, 0, 0});
    const std::vector<Twins> found = twinsOf(scene);
    QCOMPARE(!found.empty(), twins);
    QCOMPARE(!twinsText(scene, found).empty(), twins);
    if (twins) {
      const bool turned = first == QLatin1String("liver 10");
      QCOMPARE(found.front().first, scene.nodes()[turned ? 1 : 0].id);
      QCOMPARE(found.front().second, scene.nodes()[turned ? 0 : 1].id);
    }
  }
  /// Organs of two bodies overlap without being alike.
  void bodies() {
    Scene scene;
    const std::array names{"liver", "spleen", "stomach", "bladder"};
    for (std::size_t i = 0; i < names.size(); ++i) {
      add(scene, names[i], 20.0f, {60.0f * float(i), 0, 0});
      add(scene, names[i] + std::string(" 2"), 15.0f, {60.0f * float(i) + 12.0f, 5, 5});
    }
    const std::vector<Twins> found = twinsOf(scene);
    QCOMPARE(found.size(), names.size());
    QVERIFY(twinsText(scene, found).find("3 others") != std::string::npos);
    for (const Twins& each : found)
      QVERIFY(scene.find(each.second)->name.ends_with(" 2"));
    // One overlapping pair among many structures is no second body.
    Scene single;
    add(single, "cyst", 20.0f, {0, 0, 0});
    add(single, "cyst 2", 15.0f, {12, 5, 5});
    add(single, "liver", 60.0f, {0, 0, 0});
    QVERIFY(twinsOf(single).empty());
  }
  void hiddenOnesAndMoleculesHaveNone() {
    Scene scene;
    add(scene, "liver", 20.0f, {0, 0, 0});
    const NodeId second = add(scene, "liver 2", 20.0f, {0, 0, 0});
    QCOMPARE(twinsOf(scene).size(), std::size_t(1));
    QVERIFY(twinsOf(withHidden(scene, {&second, 1}).scene).empty());
    std::vector<Node> nodes = scene.nodes();
    for (Node& node : nodes)
      node.provenance.frame = "file";
    scene.setNodes(std::move(nodes));
    QVERIFY(twinsOf(scene).empty());
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::TwinsTest)
#include "twins_test.moc"
