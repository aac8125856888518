// SPDX-License-Identifier: Apache-2.0
// Tests what is counted of the writing over pictures, and counts it in products of the demos, in
// colour and in ink. `sline-bench FILES --plates 50` does so with other scenes.
#include "render/export/plate/writing_proof.h"

#include <QDir>
#include <QtTest>

#include "model/demo/demo.h"
#include "render/lettering/typesetting.h"
#include "render/picture/headless/headless_picture.h"
#include "tests/support/plate_products.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

using Kind = WritingFault::Kind;

constexpr glm::vec2 page{100.0f, 50.0f};

/// A picture whose left half is anatomy.
Image halfDrawn() {
  Image image{.width = 400, .height = 200, .rgba = {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (const int c : {0, 0, 0, x < 200 ? 255 : 0})
        image.rgba.push_back(std::uint8_t(c));
  return image;
}

LetteringItem markAt(const char* name, const glm::vec2& at) {
  return {.name = name,
          .shapes = {},
          .text = LetteringText{.lines = {QString("R")}, .at = at, .points = 10.0f}};
}

/// A label whose leader goes from its dot to its box along those places.
void tell(FigurePlate& plate, std::uint64_t id, const char* text, const Leader& leader) {
  if (!plate.labels)
    plate.labels.emplace();
  LabelPlate& labels = *plate.labels;
  ShownLabel label;
  label.item.id = {id};
  label.item.places = {leader.front()};
  label.text = text;
  labels.labels.push_back(label);
  labels.texts.push_back({.lines = {QString(text)}});
  PlacedLabel placed;
  placed.id = {id};
  placed.post = LabelPost::right;
  placed.box = {leader.back() - glm::vec2(0.0f, 2.0f), leader.back() + glm::vec2(12.0f, 2.0f)};
  placed.leader = leader;
  labels.layout.labels.push_back(placed);
}

}  // namespace

class WritingProofTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    Result<std::unique_ptr<Typesetting>> made = Typesetting::create();
    QVERIFY(made.ok());
    m_typesetting = std::move(*made);
  }

  void marksOverAnatomy() {
    FigurePlate plate;
    plate.marks.lettering.items = {markAt("over", {20.0f, 20.0f}),
                                   markAt("beside", {70.0f, 20.0f})};
    WritingProof proof = provedWriting(plate, page, halfDrawn());
    QCOMPARE(proof.marks, std::size_t(2));
    QCOMPARE(proof.count(Kind::overAnatomy), 1);
    QCOMPARE(proof.faults.front().item, std::string("over"));
    // A capital of 10 points is some 2.5 mm high and as wide; there are 4 pixels to a millimetre.
    QVERIFY2(proof.pixels() > 60 && proof.pixels() < 140,
             qPrintable(QString::number(proof.pixels())));
    // What is cut off is no anatomy any more.
    cutOffAt(plate.marks, {{0.0f, 10.0f}, page});
    proof = provedWriting(plate, page, halfDrawn());
    QCOMPARE(proof.marks, std::size_t(2));
    QVERIFY(proof.faults.empty());
  }

  void leadersThroughOthers() {
    FigurePlate plate;
    tell(plate, 1, "long", {{55.0f, 10.0f}, {80.0f, 10.0f}});
    tell(plate, 2, "met", {{60.0f, 10.2f}, {80.0f, 30.0f}});
    tell(plate, 3, "below", {{90.0f, 40.0f}, {86.0f, 20.0f}, {86.0f, 5.0f}});
    const WritingProof proof = provedWriting(plate, page, halfDrawn());
    QCOMPARE(proof.labels, std::size_t(3));
    QCOMPARE(proof.count(Kind::throughDot), 1);
    QCOMPARE(proof.count(Kind::throughText), 2);  // those of "long" and "met", by "below"
    for (const WritingFault& fault : proof.faults)
      QCOMPARE(fault.item, std::string(fault.kind == Kind::throughText ? "below" : "long"));
  }

  void whatStandsElsewhere() {
    FigurePlate one;
    one.marks.lettering.items = {markAt("same", {20.0f, 20.0f}), markAt("moved", {70.0f, 20.0f}),
                                 markAt("gone", {70.0f, 30.0f})};
    tell(one, 1, "label", {{55.0f, 10.0f}, {80.0f, 10.0f}});
    FigurePlate other = one;
    QVERIFY(writtenElsewhere(one, other).empty());
    other.marks.lettering.items[1] = markAt("moved", {71.0f, 20.0f});
    other.marks.lettering.items.pop_back();
    other.labels->layout.labels.front().leader.front().x = 56.0f;
    const std::vector<std::string> expected{"gone: in the first alone", "moved: elsewhere",
                                            "label: elsewhere"};
    QVERIFY(writtenElsewhere(one, other) == expected);
  }

  /// Products of the demos, each of another kind and from another side: no letter or mark lies over
  /// anatomy, no leader passes another's dot or text, and black ink has all in the same places.
  void products_data() {
    QTest::addColumn<int>("demo");
    QTest::addColumn<int>("index");
    for (const auto& [name, demo] :
         {std::pair("kidney", model::DemoName::kidney), {"pelvis", model::DemoName::pelvis}})
      for (const int index : {0, 8, 13, 20, 3, 29})
        QTest::addRow("%s, product %d", name, index) << int(demo) << index;
    QTest::newRow("kidney, cut") << int(model::DemoName::kidney) << 11;
  }
  void products() {
    QFETCH(int, demo);
    QFETCH(int, index);
    const model::Scene scene =
        model::demo(model::DemoName(demo), model::Sex::female, QDir::tempPath().toStdString());
    ProductTools tools;
    const Result<Product> product = productOf(scene, index, tools);
    QVERIFY(product.ok());
    auto picture = HeadlessPicture::create();
    QVERIFY(picture.ok());
    const DrawPicture draw = [&](const model::Scene& shown, const model::Camera& camera,
                                 const PictureSettings& settings) {
      return (*picture)->render(shown, camera, settings);
    };
    const Result<ProductProof> proof = proved(*product, draw, {}, tools);
    QVERIFY(proof.ok());
    for (const std::string& line : proof->lines)
      qWarning("%s", line.c_str());
    QVERIFY(proof->labels > 0);
    QVERIFY(proof->marks > 0);
    QVERIFY(proof->clean());
  }

 private:
  std::unique_ptr<Typesetting> m_typesetting;
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::WritingProofTest)
#include "writing_proof_test.moc"
