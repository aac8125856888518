// SPDX-License-Identifier: Apache-2.0
// Tests where links lie in texts that were set.
#include "render/lettering/link_places.h"

#include <QtTest>

#include "render/lettering/caption.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

constexpr CaptionPlace page{.middle = 80.0f, .foot = 85.0f, .width = 112.0f, .height = 60.0f};
constexpr CaptionPlace column{.middle = 20.0f, .foot = 85.0f, .width = 26.0f, .height = 80.0f};
const LabelStyle linkStyle{.mode = LabelMode::on, .language = {}};

/// A text that was set, and its links.
struct Set {
  Caption caption;
  std::vector<LinkPlace> links;

  explicit Set(const char* markup, const CaptionPlace& place = page)
      : caption(captionOf(markup, linkStyle, place).value()),
        links(linkPlaces(markup, *caption.item.text)) {}
  const LetteringText& text() const { return *caption.item.text; }
  QString names() const {
    QStringList all;
    for (const LinkPlace& one : links)
      all << QString::fromStdString(one.link.name);
    return all.join('|');
  }
  /// The box of some words of a line that is one run.
  LabelBox boxOf(std::size_t line, const QString& before, const QString& words) const {
    const float left = text().at.x + textWidthMm(TextLine(before), text().points);
    const float baseline = text().at.y + float(line) * text().leading;
    return {{left, baseline}, {left + textWidthMm(TextLine(words), text().points), baseline}};
  }
};

bool isAt(const LinkPlace& place, const LabelBox& box) {
  constexpr float kerning = 0.15f;  // millimetres
  return qAbs(place.box.low.x - box.low.x) < kerning &&
         qAbs(place.box.high.x - box.high.x) < kerning &&
         qAbs(place.baseline - box.low.y) < 1e-3f && place.box.low.y < place.baseline &&
         place.box.high.y > place.baseline;
}

}  // namespace

class LinkPlacesTest : public QObject {
  Q_OBJECT

 private slots:
  void inALine() {
    const Set set("See the [left ureter](#structure=x) and [this](#view=2).");
    QCOMPARE(set.text().lines.size(), std::size_t(1));
    QCOMPARE(plainText(set.text().lines), QString("See the left ureter and this."));
    QCOMPARE(set.names(), QString("x|2"));
    QVERIFY(isAt(set.links[0], set.boxOf(0, "See the ", "left ureter")));
    QVERIFY(isAt(set.links[1], set.boxOf(0, "See the left ureter and ", "this")));
    QVERIFY(set.caption.box.contains(set.links[0].box.middle()));
  }

  /// A link that a line divides is in both; bullets and blanks are in none.
  void overLines() {
    const Set set("- one\n- the [left ureter of the kidney](#structure=x)", column);
    QVERIFY(set.text().lines.size() >= 3);
    QVERIFY(set.links.size() >= 2);
    QCOMPARE(set.links.size(), set.text().lines.size() - 1);
    for (std::size_t i = 0; i + 1 < set.links.size(); ++i)
      QVERIFY(set.links[i].baseline < set.links[i + 1].baseline);
    for (const LinkPlace& place : set.links)
      QVERIFY(set.caption.box.contains(place.box.middle()));
  }

  /// Hyphens that divide a word are not of the text, and letters behind them are found all the
  /// same.
  void overHyphens() {
    const Set set("Sternocleidomastoideus-Pterygopalatinum-Ligamentum [b](#view=7)", column);
    QVERIFY(set.text().lines.size() >= 3);
    QCOMPARE(set.names(), QString("7"));
  }

  /// Each style is a run of its own.
  void inStyles() {
    const Set set("**a [b *c* d](#view=1)** e");
    QCOMPARE(set.names(), QString("1|1|1"));
    QVERIFY(set.links[0].box.high.x <= set.links[1].box.low.x + 0.01f);
    QVERIFY(set.links[1].box.high.x <= set.links[2].box.low.x + 0.01f);
  }

  void fromTheRight() {
    const Set set("\u05db\u05dc\u05d9\u05d4 [\u05e9\u05dc](#view=1) \u05d9\u05de\u05d9\u05df");
    QCOMPARE(set.names(), QString("1"));
    QVERIFY(set.links[0].box.size().x > 0.5f);
    QVERIFY(set.caption.box.contains(set.links[0].box.middle()));
  }

  void nothingOfWhatFoundNoRoom() {
    const Set set("a\nb\nc\nd\n[e](#view=1)",
                  {.middle = 80.0f, .foot = 85.0f, .width = 60.0f, .height = 12.0f});
    QVERIFY(set.caption.shortened);
    QVERIFY(set.links.empty());
  }

  void noLinks() { QVERIFY(Set("**a** [b](c)").links.empty()); }
};

}  // namespace sline::test

SLINE_TEST_WITH_GUI(sline::test::LinkPlacesTest)
#include "link_places_test.moc"
