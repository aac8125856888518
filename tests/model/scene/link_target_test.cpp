// SPDX-License-Identifier: Apache-2.0
#include "model/scene/link_target.h"

#include <QtTest>

#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline::model;

namespace {

/// Says "structure 2" or "view 1", as people count.
QString saidOf(const std::optional<LinkTarget>& target) {
  if (!target)
    return QStringLiteral("nothing");
  if (const auto* id = std::get_if<NodeId>(&*target))
    return QStringLiteral("structure %1").arg(id->value);
  return QStringLiteral("view %1").arg(std::get<std::size_t>(*target) + 1);
}

}  // namespace

class LinkTargetTest : public QObject {
  Q_OBJECT

 private slots:
  void targets_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("found");
    const auto row = [](const char* text, const char* found) {
      QTest::newRow(text) << QString::fromUtf8(text) << found;
    };
    row("[a](#structure=left ureter)", "structure 2");
    row("[a](#structure=Left_Ureter)", "structure 2");
    row("[a](#structure=Ureter sinister)", "structure 2");
    row("[a](#structure=kidneys)", "structure 1");
    row("[a](#structure=heart)", "nothing");
    row("[a](#structure=)", "nothing");
    row("[a](#structure=2)", "nothing");
    row("[a](#view=2)", "view 2");
    row("[a](#view=from-behind)", "view 2");
    row("[a](#view=Von hinten)", "view 2");
    row("[a](#view=From the back)", "view 2");
    row("[a](#view=3)", "nothing");
    row("[a](#view=0)", "nothing");
    row("[a](#view=-1)", "nothing");
    row("[a](#view=2x)", "nothing");
    row("[a](#view=)", "nothing");
    row("[a](#view=99999999999999999999999)", "nothing");
  }
  void targets() {
    QFETCH(QString, text);
    QFETCH(QString, found);
    Scene scene;
    const NodeId group = scene.append({.name = "Kidneys"});
    scene.append({.parent = group, .name = "left ureter", .mesh = sline::test::sphere(1.0f, 1)});
    View behind{.name = "From behind"};
    behind.words.title.text = "From the back";
    behind.words.title.texts["de"] = "Von hinten";
    scene.setViews({{.name = "Front"}, behind});
    const std::vector<MarkedLine> lines = markedLines(text.toStdString());
    const std::optional<MarkupLink> link = lines.at(0).runs.at(0).link;
    QVERIFY(link);
    const auto others = [](const std::string& name) {
      return std::vector<std::string>{name == "left ureter" ? "ureter sinister" : ""};
    };
    QCOMPARE(saidOf(linkTarget(*link, scene, others)), found);
    if (text.contains("sinister"))
      QCOMPARE(saidOf(linkTarget(*link, scene)), QString("nothing"));
  }
};

SLINE_TEST(LinkTargetTest)
#include "link_target_test.moc"
