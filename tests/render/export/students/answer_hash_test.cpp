// SPDX-License-Identifier: Apache-2.0
// Tests how typed answers are compared.
#include "render/export/students/answer_hash.h"

#include <QtTest>

#include "tests/support/suite.h"

namespace sline::test {

class AnswerHashTest : public QObject {
  Q_OBJECT

 private slots:
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

SLINE_TEST(sline::test::AnswerHashTest)
#include "answer_hash_test.moc"
