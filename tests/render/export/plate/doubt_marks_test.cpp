// SPDX-License-Identifier: Apache-2.0
// Tests that what was assumed of the body's sides is no fact in letters, titles and sections.
#include <QStringList>
#include <QtTest>
#include <memory>

#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "render/export/plate/figure_plate.h"
#include "render/export/plate/legend.h"
#include "render/export/plate/marks.h"
#include "render/lettering/lettering.h"
#include "render/lettering/typesetting.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

class DoubtMarksTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    Result<std::unique_ptr<render::Typesetting>> made = render::Typesetting::create();
    QVERIFY(made.ok());
    m_typesetting = std::move(*made);
  }
  void doubtIsMarked_data() {
    using enum model::Evidence;
    QTest::addColumn<int>("sides");
    QTest::addColumn<int>("front");
    QTest::addColumn<QString>("view");
    QTest::addColumn<QStringList>("told");  // letters, title, end of the section's text
    const auto row = [](model::Evidence sides, model::Evidence front, const char* view,
                        const QStringList& told) {
      QTest::addRow("%s, %s, %s", model::evidenceNames[std::size_t(sides)].data(),
                    model::evidenceNames[std::size_t(front)].data(), view)
          << int(sides) << int(front) << QString(view) << told;
    };
    row(voted, voted, "left", {"A P S I", "Left lateral view", "left part kept"});
    row(settled, settled, "anterior", {"R L S I", "Anterior view", "left part kept"});
    row(assumed, known, "left", {"A P S I", "Left lateral view (?)", "left part kept (?)"});
    row(assumed, assumed, "left", {"A? P? S I", "Left lateral view (?)", "left part kept (?)"});
    row(conflict, conflict, "anterior", {"R? L? S I", "Anterior view (?)", "left part kept (?)"});
    row(assumed, known, "anterior", {"R? L? S I", "Anterior view", "left part kept (?)"});
    row(assumed, assumed, "superior", {"L? R? A? P?", "Superior view", "left part kept (?)"});
  }
  void doubtIsMarked() {
    QFETCH(int, sides);
    QFETCH(int, front);
    QFETCH(QString, view);
    QFETCH(QStringList, told);
    ExportOrder order;
    model::Node node;
    node.name = "Sphere";
    node.mesh = sphere(50.0f, 3);
    node.provenance.frame = "LPS";
    node.provenance.evidence = {model::Evidence(sides), model::Evidence(front)};
    order.scene.append(std::move(node));
    model::Section cut;
    cut.plane = model::anatomicalPlane(model::AnatomicalView::left, 12.0f);
    order.scene.appendSection(cut);
    order.viewName = view.toStdString();
    order.camera = model::anatomicalCamera(*model::anatomicalViewNamed(order.viewName),
                                           order.scene.visibleBounds(), 160.0f / 90.0f);
    QStringList letters;
    QString title;
    QString section;
    for (const LetteringItem& item : marksOf(order).lettering.items) {
      const QString text = item.text ? plainText(item.text->lines.front()) : QString();
      if (item.name.starts_with("side "))
        letters << text;
      else if (item.name == "view")
        title = text;
      else if (item.name == "section 1")
        section = text;
    }
    QCOMPARE(letters.join(' '), told[0]);
    QCOMPARE(title, told[1]);
    QVERIFY2(section.endsWith(told[2]), qPrintable(section));
  }

  /// A name that may be of the other side is no fact in labels and legends.
  void doubtedNamesAreMarked_data() {
    QTest::addColumn<int>("evidence");
    QTest::addColumn<QString>("mark");
    QTest::newRow("known") << int(model::Evidence::known) << "";
    QTest::newRow("conflict") << int(model::Evidence::conflict) << " (?)";
    QTest::newRow("settled") << int(model::Evidence::settled) << "";
  }
  void doubtedNamesAreMarked() {
    QFETCH(int, evidence);
    QFETCH(QString, mark);
    ExportOrder order;
    model::Node node;
    node.name = "left kidney";
    node.mesh = sphere(50.0f, 3);
    node.style.colour = Colour{200, 100, 90};
    node.provenance.frame = "LPS";
    node.provenance.nameEvidence = model::Evidence(evidence);
    const model::NodeId id = order.scene.append(std::move(node));
    for (const auto kind : {model::AnnotationKind::label, model::AnnotationKind::pin,
                            model::AnnotationKind::callout}) {
      model::Annotation label{.kind = kind, .text = "left kidney", .texts = {{"de", "Niere"}}};
      label.anchors = {model::SurfacePoint{.structure = id}};
      label.found = true;
      order.scene.appendAnnotation(label);
    }
    order.labels.mode = LabelMode::on;
    order.legend = LegendList::all;
    order.camera = model::anatomicalCamera(model::AnatomicalView::anterior,
                                           order.scene.visibleBounds(), 160.0f / 90.0f);
    model::MeshTrees trees;
    const FigurePlate plate = figurePlate(order, trees);
    QCOMPARE(plate.labels->labels.size(), std::size_t(3));
    for (const ShownLabel& label : plate.labels->labels)
      QCOMPARE(QString::fromStdString(label.text), "left kidney" + mark);
    QStringList said;
    for (const LetteringItem& item : plate.marks.lettering.items)
      if (item.text)
        said << plainText(item.text->lines.front());
    QVERIFY2(said.contains("left kidney" + mark), qPrintable(said.join('|')));
    order.labels.language = "de+la";
    QVERIFY(structureName(*order.scene.find(id), "de").ends_with(mark.toStdString()));
    QCOMPARE(model::writtenIn(order.scene, order.scene.annotations()[0], "de+la"),
             "Niere" + mark.toStdString());
  }

 private:
  std::unique_ptr<render::Typesetting> m_typesetting;
};

}  // namespace sline::test

SLINE_TEST(sline::test::DoubtMarksTest)
#include "doubt_marks_test.moc"
