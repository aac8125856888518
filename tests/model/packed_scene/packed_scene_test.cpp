// SPDX-License-Identifier: Apache-2.0
#include "model/packed_scene/packed_scene.h"

#include <QtTest>
#include <glm/geometric.hpp>

#include "tests/model/scene_file/sample_scene.h"
#include "tests/support/mutator.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::model;

namespace {
Scene unpackedFrom(const std::vector<std::string>& parts) {
  UnpackedScene unpacked;
  for (const std::string& part : parts)
    if (const Status taken = unpacked.take(part); !taken)
      qWarning("%s", taken.error().text().c_str());
  return unpacked.scene();
}

std::set<NodeId> structuresOf(const Scene& scene) {
  std::set<NodeId> all;
  for (const Node& node : scene.nodes())
    if (!node.isGroup())
      all.insert(node.id);
  return all;
}
}  // namespace

class PackedSceneTest : public QObject {
  Q_OBJECT
 private slots:
  void sameScene() {
    const Scene scene = test::sampleScene();
    const PackedScene packed = packedScene(scene);
    QVERIFY(packed.rest.empty());
    const Scene again = unpackedFrom({packed.first});
    QCOMPARE(again.nodes().size(), scene.nodes().size());
    for (std::size_t i = 0; i < scene.nodes().size(); ++i) {
      const Node& a = scene.nodes()[i];
      const Node& b = again.nodes()[i];
      QCOMPARE(b.id, a.id);
      QCOMPARE(b.name, a.name);
      QCOMPARE(b.isGroup(), a.isGroup());
      QVERIFY(b.style == a.style);
      QCOMPARE(bool(b.paint), bool(a.paint));
      if (a.mesh)
        QCOMPARE(b.mesh->triangleCount(), a.mesh->triangleCount());
    }
    QCOMPARE(again.views().size(), scene.views().size());
    QVERIFY(again.sections() == scene.sections());
    QVERIFY(again.scans().empty());
  }

  void placesMoveWithTheirTriangles() {
    const Scene scene = test::sampleScene();
    const Scene again = unpackedFrom({packedScene(scene).first});
    QCOMPARE(again.annotations().size(), scene.annotations().size());
    bool onSurface = false;
    for (std::size_t i = 0; i < scene.annotations().size(); ++i)
      for (std::size_t k = 0; k < scene.annotations()[i].anchors.size(); ++k) {
        const auto before = scene.placeOf(scene.annotations()[i].anchors[k]);
        const auto after = again.placeOf(again.annotations()[i].anchors[k]);
        QCOMPARE(bool(after), bool(before));
        if (!before)
          continue;
        onSurface = onSurface || scene.annotations()[i].anchors[k].index() == 1;
        QVERIFY(glm::length(*after - *before) < 0.01f);
      }
    QVERIFY(onSurface);
  }

  void theRestComesLater() {
    const Scene scene = test::sampleScene();
    const std::set<NodeId> all = structuresOf(scene);
    QVERIFY(all.size() > 1);
    const std::set<NodeId> later(std::next(all.begin()), all.end());
    const PackedScene packed = packedScene(scene, {.later = later});
    const Scene first = unpackedFrom({packed.first});
    for (const NodeId id : all)
      QCOMPARE(first.find(id)->mesh->triangleCount() == 0, later.contains(id));
    const Scene both = unpackedFrom({packed.first, packed.rest});
    const Scene whole = unpackedFrom({packedScene(scene).first});
    QVERIFY(test::difference(both, whole).empty());
  }

  void namesAreLeftOut() {
    Scene scene = test::sampleScene();
    std::vector<Node> nodes = scene.nodes();
    for (Node& node : nodes) {
      node.name = "secretname";
      node.provenance.file = "secretname.stl";
      node.provenance.credit.source = "secretname";
    }
    scene.setNodes(nodes);
    std::vector<Annotation> annotations = scene.annotations();
    for (Annotation& annotation : annotations) {
      annotation.text = "secretname";
      annotation.texts = {{"la", "secretname"}};
    }
    scene.setAnnotations(annotations);
    std::vector<View> views = scene.views();
    for (View& view : views)
      view.name = view.words.text.text = view.words.notes.text = "secretname";
    scene.setViews(views);
    QVERIFY(packedScene(scene).first.find("secretname") != std::string::npos);
    QCOMPARE(packedScene(scene, {.names = false}).first.find("secretname"), std::string::npos);
  }

  void speakersNotesAndFilesStayAtHome() {
    Scene scene = test::sampleScene();
    std::vector<View> views = scene.views();
    for (View& view : views)
      view.words.notes.text = "athome";
    scene.setViews(views);
    std::vector<Node> nodes = scene.nodes();
    for (Node& node : nodes)
      node.provenance.file = node.provenance.part = node.unread = "{\"a\":\"athome\"}";
    scene.setNodes(nodes);
    scene.setUnread("{\"b\":\"athome\"}");
    QCOMPARE(packedScene(scene).first.find("athome"), std::string::npos);
  }

  void spoiledBytes() {
    const QByteArray good = QByteArray::fromStdString(packedScene(test::sampleScene()).first);
    test::Mutator mutate(5, {});
    int refused = 0;
    for (int i = 0; i < 600; ++i) {
      UnpackedScene unpacked;
      if (const Status taken = unpacked.take(mutate(good).toStdString()); !taken) {
        ++refused;
        QVERIFY(unpacked.scene() == Scene());
      }
    }
    QVERIFY(refused > 200);
  }
};

SLINE_TEST(PackedSceneTest)
#include "packed_scene_test.moc"
