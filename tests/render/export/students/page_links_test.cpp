// SPDX-License-Identifier: Apache-2.0
// Tests links in texts, and how typed answers are compared.
#include "render/export/students/page_links.h"
#include "render/export/students/answer_hash.h"
#include "tests/render/export/slides/lesson.h"
#include "tests/support/suite.h"

namespace sline::test {

class PageLinksTest : public QObject {
  Q_OBJECT

 private slots:
  void links_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("pieces");
    const auto row = [](const char* text, const char* pieces) {
      QTest::newRow(text) << text << pieces;
    };
    row("plain", "plain");
    row("the [ureter](#structure=left-ureter) ends", "the |ureter=1| ends");
    row("[a](#structure=Left_Ureter)[b](#view=2)", "a=1|b@2");
    row("go [there](#view=from-behind)", "go |there@2");
    row("to [none](#structure=heart), [none](#view=3), [none](#view=0)", "to none, none, none");
    row("[page](https://example.org)", "[page](https://example.org)");
    row("[page](javascript:alert(1))", "[page](javascript:alert(1))");
    row("a [bracket] (and) more", "a [bracket] (and) more");
    row("[](#view=1)", "[](#view=1)");
    row("[open](#view=1", "[open](#view=1");
    row("[over\nlines](#view=1)", "[over\nlines](#view=1)");
    row("[[x](#view=1)", "[x@1");
    row("", "");
  }
  void links() {
    QFETCH(QString, text);
    QFETCH(QString, pieces);
    render::ExportOrder order = lessonOf({"left ureter", "spleen"});
    std::vector<model::View> views;
    addView(order, views, "Front");
    addView(order, views, "From behind");
    order.scene.setViews(views);
    QStringList found;
    for (const render::LinkedPiece& piece : render::linkedPieces(text.toStdString(), order.scene))
      found << QString::fromStdString(piece.text) +
                   (piece.structure ? "=" + QString::number(piece.structure->value) : QString()) +
                   (piece.view ? "@" + QString::number(*piece.view) : QString());
    QCOMPARE(found.join('|'), pieces);
  }

  /// The page's script has the same rows (tests/page).
  void normalised_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("compared");
    const auto row = [](const char* name, const char* compared) {
      QTest::newRow(name) << QString::fromUtf8(name) << QString::fromUtf8(compared);
    };
    row("Left Kidney", "leftkidney");
    row("Vena cava inf.", "venacavainf");
    row("Äußere Beckenvene", "außerebeckenvene");
    row("trac\u0301he\u0301e", "trachee");
    row("høyre lårbein", "høyrelarbein");
    row("L4–L5", "l4l5");
    row("\u2163. nerve", "ivnerve");
    row("x\u00b2", "x2");
    row("肝臓 (右)", "肝臓右");
    row(" -/… ", "");
  }
  void normalised() {
    QFETCH(QString, name);
    QFETCH(QString, compared);
    QCOMPARE(QString::fromStdString(render::normalisedAnswer(name.toStdString())), compared);
  }

  void hashes() {
    // From coreutils: printf 'saltleftkidney' | sha256sum
    QCOMPARE(render::answerHash("salt", "Left kidney"), std::string("6d3c54919ae6c72d"));
    QCOMPARE(render::answerHash("salt", "left-KIDNEY"), render::answerHash("salt", "Left kidney"));
    QVERIFY(render::answerHash("other", "left kidney") !=
            render::answerHash("salt", "left kidney"));
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::PageLinksTest)
#include "page_links_test.moc"
