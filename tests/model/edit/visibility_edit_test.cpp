// SPDX-License-Identifier: Apache-2.0
// Tests showing and hiding in a tree A ( B ( b c ) a ) d.
#include <QTest>

#include "model/edit/visibility.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::model {
namespace {

class Sample {
 public:
  Sample() {
    const MeshPtr ball = test::sphere(1.0f, 0);
    add("A", rootId, nullptr);
    add("B", id("A"), nullptr);
    add("b", id("B"), ball);
    add("c", id("B"), ball);
    add("a", id("A"), ball);
    add("d", rootId, ball);
  }
  NodeId id(const QString& name) const {
    for (const Node& node : scene.nodes())
      if (name.toStdString() == node.name)
        return node.id;
    return NodeId{12345};
  }
  std::vector<NodeId> ids(const QString& names) const {
    std::vector<NodeId> found;
    for (const QString& name : names.split(' ', Qt::SkipEmptyParts))
      found.push_back(id(name));
    return found;
  }
  /// Shows B for "+B" and hides b for "-b", in turn.
  void edit(const QString& steps) {
    for (const QString& step : steps.split(' ', Qt::SkipEmptyParts)) {
      const std::vector<NodeId> one{id(step.mid(1))};
      scene = (step.startsWith('+') ? withShown(scene, one) : withHidden(scene, one)).scene;
    }
  }
  QString visible() const {
    QStringList names;
    for (const Node& node : scene.nodes())
      if (!node.isGroup() && scene.resolve(node.id).visible)
        names << QString::fromStdString(node.name);
    return names.join(' ');
  }

  Scene scene;

 private:
  void add(const char* name, NodeId parent, const MeshPtr& mesh) {
    scene.append({.parent = parent, .name = name, .mesh = mesh});
  }
};

}  // namespace

class VisibilityEditTest : public QObject {
  Q_OBJECT
 private slots:
  void steps_data() {
    QTest::addColumn<QString>("steps");
    QTest::addColumn<QString>("visible");
    QTest::newRow("nothing") << ""
                             << "b c a d";
    QTest::newRow("a structure hidden") << "-b"
                                        << "c a d";
    QTest::newRow("and shown") << "-b +b"
                               << "b c a d";
    QTest::newRow("a group hidden") << "-A"
                                    << "d";
    QTest::newRow("comes back as it was") << "-b -A +A"
                                          << "c a d";
    QTest::newRow("a part shown becomes all") << "-b -A +A +A"
                                              << "b c a d";
    QTest::newRow("would show nothing, shows all") << "-b -c -B +B"
                                                   << "b c a d";
    QTest::newRow("all hidden one by one") << "-b -c +B"
                                           << "b c a d";
    QTest::newRow("in a hidden group, alone") << "-A +b"
                                              << "b d";
    QTest::newRow("in two hidden groups, alone") << "-B -A +c"
                                                 << "c d";
    QTest::newRow("one of two hidden groups") << "-B +c"
                                              << "c a d";
    QTest::newRow("then its group") << "-A +b +B"
                                    << "b c d";
    QTest::newRow("unknown") << "-x +x"
                             << "b c a d";
  }
  void steps() {
    QFETCH(QString, steps);
    QFETCH(QString, visible);
    Sample s;
    s.edit(steps);
    QCOMPARE(s.visible(), visible);
  }

  /// Showing several together is the same as showing one after the other, whatever was hidden
  /// before.
  void manyAtOnceAreOneByOne() {
    const QStringList names{"A", "B", "a", "b", "c", "d"};
    for (unsigned hidden = 0; hidden < 64; ++hidden)
      for (unsigned wanted = 0; wanted < 64; ++wanted) {
        Sample together;
        for (int i = 0; i < 6; ++i)
          if ((hidden >> i & 1u) != 0)
            together.edit("-" + names[i]);
        Sample apart = together;
        std::vector<NodeId> ids;
        for (int i = 0; i < 6; ++i)
          if ((wanted >> i & 1u) != 0) {
            ids.push_back(together.id(names[i]));
            apart.edit("+" + names[i]);
          }
        together.scene = withShown(together.scene, ids).scene;
        QCOMPARE(together.visible(), apart.visible());
        QVERIFY(together.scene == apart.scene);
      }
  }

  void saysWhetherAnythingChanged() {
    Sample s;
    QVERIFY(!withShown(s.scene, s.ids("A d")).changed);
    QVERIFY(withHidden(s.scene, s.ids("A")).changed);
    s.edit("-A");
    QVERIFY(!withHidden(s.scene, s.ids("A")).changed);
    QVERIFY(withShown(s.scene, s.ids("A")).changed);
  }

  void threeStates() {
    Sample s;
    QVERIFY(visibilityOf(s.scene, s.id("A")) == Visibility::all);
    s.edit("-b");
    QVERIFY(visibilityOf(s.scene, s.id("A")) == Visibility::some);
    QVERIFY(visibilityOf(s.scene, s.id("b")) == Visibility::none);
    s.edit("-A");
    QVERIFY(visibilityOf(s.scene, s.id("B")) == Visibility::none);
    QVERIFY(visibilityOf(s.scene, rootId) == Visibility::some);
  }

  void hidesOthers_data() {
    QTest::addColumn<QString>("before");
    QTest::addColumn<QString>("ids");
    QTest::addColumn<QString>("visible");
    QTest::newRow("a structure") << ""
                                 << "b"
                                 << "b";
    QTest::newRow("a group") << ""
                             << "B"
                             << "b c";
    QTest::newRow("a group and one beside it") << ""
                                               << "B d"
                                               << "b c d";
    QTest::newRow("a group and one in it") << ""
                                           << "A b"
                                           << "b c a";
    QTest::newRow("what is hidden stays hidden") << "-b"
                                                 << "B"
                                                 << "c";
    QTest::newRow("itself hidden") << "-d"
                                   << "d"
                                   << "";
    QTest::newRow("none") << ""
                          << ""
                          << "b c a d";
    QTest::newRow("the unknown") << ""
                                 << "x"
                                 << "b c a d";
  }
  void hidesOthers() {
    QFETCH(QString, before);
    QFETCH(QString, ids);
    QFETCH(QString, visible);
    Sample s;
    s.edit(before);
    const QString shownBefore = s.visible();
    const Edited edited = withOthersHidden(s.scene, s.ids(ids));
    s.scene = edited.scene;
    QCOMPARE(s.visible(), visible);
    QCOMPARE(edited.changed, visible != shownBefore);
    QVERIFY(!withOthersHidden(s.scene, s.ids(ids)).changed);
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::VisibilityEditTest)
#include "visibility_edit_test.moc"
