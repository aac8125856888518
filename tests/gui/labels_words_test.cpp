// SPDX-License-Identifier: Apache-2.0
// Tests the words of labels in the picture: typed, edited in place, marked up and pasted.
#include <QApplication>
#include <QClipboard>
#include <QMimeData>

#include "tests/gui/labels_fixture.h"
#include "tests/support/suite.h"

namespace sline::test {

using model::AnnotationKind;

class LabelsWordsTest : public QObject {
  Q_OBJECT

 private slots:
  void escapeForgetsWhatWasTyped() {
    Labels f;
    const int before = f.steps();
    f.key(Qt::Key_T);
    f.click(f.middleOf(f.liver));
    QVERIFY(f.typing());
    QTest::keyClicks(&f.editor(), QStringLiteral("nothing"));
    QTest::keyClick(&f.editor(), Qt::Key_Escape);
    QVERIFY(!f.editor().isOpen());
    QVERIFY(f.annotations().empty());
    QCOMPARE(f.steps(), before);
    // Beside the structures there is nothing to label.
    f.click({8, 300});
    QTest::qWait(150);
    QVERIFY(!f.editor().isOpen());
    // An empty label is not made.
    f.click(f.middleOf(f.liver));
    QVERIFY(f.typing());
    QTest::keyClick(&f.editor(), Qt::Key_Delete);
    QTest::keyClick(&f.editor(), Qt::Key_Return);
    QVERIFY(f.annotations().empty());
    // Turning with the tool in hand makes no label either.
    const model::Camera camera = f.viewport().camera();
    dragMouse(f.viewport(), f.middleOf(f.liver), f.middleOf(f.liver) + QPoint(60, 0));
    QVERIFY(f.viewport().camera() != camera);
    QVERIFY(!f.editor().isOpen());
  }

  void clickElsewhereTakesWordsOver() {
    Labels f;
    f.key(Qt::Key_T);
    f.click(f.middleOf(f.liver));
    QVERIFY(f.typing());
    QTest::keyClicks(&f.editor(), QStringLiteral("first"));
    f.viewport().setFocus(Qt::MouseFocusReason);  // as a click does
    f.click(f.middleOf(f.bladder));
    QVERIFY(f.typing());
    QTest::keyClick(&f.editor(), Qt::Key_Return);
    QCOMPARE(f.annotations().size(), std::size_t(2));
    QCOMPARE(f.annotations().front().text, std::string("first"));
  }

  void wordsAreEditedInPlace() {
    Labels f;
    f.make(f.liver, {});
    const model::AnnotationId id = f.only().id;
    QTest::mouseDClick(&f.viewport(), Qt::LeftButton, {}, f.textAt(id));
    QVERIFY(f.typing());
    QCOMPARE(f.editor().toPlainText(), QStringLiteral("liver"));
    QTest::keyClicks(&f.editor(), QStringLiteral("hepar"));
    QTest::keyClick(&f.editor(), Qt::Key_Return);
    QCOMPARE(f.only().text, std::string("hepar"));
    QCOMPARE(f.shownLines(), QStringList{QStringLiteral("hepar")});
    f.undo();
    QCOMPARE(f.only().text, std::string("liver"));
    f.redo();
    QCOMPARE(f.only().text, std::string("hepar"));
    // A key edits, too; unchanged words are no step.
    const int before = f.steps();
    f.key(Qt::Key_F2);
    QVERIFY(f.typing());
    QTest::keyClick(&f.editor(), Qt::Key_Return);
    QCOMPARE(f.steps(), before);
    QVERIFY(f.viewport().hasFocus());
  }

  void calloutsHaveLines() {
    Labels f;
    f.key(Qt::Key_T, Qt::ShiftModifier);
    f.click(f.middleOf(f.liver));
    QVERIFY(f.typing());
    QTest::keyClicks(&f.editor(), QStringLiteral("one"));
    QTest::keyClick(&f.editor(), Qt::Key_Return, Qt::ShiftModifier);
    QTest::keyClicks(&f.editor(), QStringLiteral("two"));
    QTest::keyClick(&f.editor(), Qt::Key_Return);
    QCOMPARE(f.only().text, std::string("one\ntwo"));
    QCOMPARE(f.shownLines(), QStringList{QStringLiteral("one/two")});
  }

  /// Ctrl+B and Ctrl+I mark words up, though Ctrl+I imports files elsewhere in the window.
  void calloutsAreMarkedUp() {
    Labels f;
    f.key(Qt::Key_T, Qt::ShiftModifier);
    f.click(f.middleOf(f.liver));
    QVERIFY(f.typing());
    QVERIFY(f.editor().toolTip().contains("**bold** (Ctrl+B)"));
    const auto press = [&f](Qt::Key key, Qt::KeyboardModifiers keys = {}) {
      QTest::keyClick(&f.editor(), key, keys);
      return f.editor().toPlainText();
    };
    QTest::keyClicks(&f.editor(), QStringLiteral("Ren dexter"));
    press(Qt::Key_Home);
    press(Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);  // with the blank behind it
    QCOMPARE(press(Qt::Key_B, Qt::ControlModifier), QStringLiteral("**Ren** dexter"));
    QCOMPARE(f.editor().textCursor().selectedText(), QStringLiteral("Ren"));
    QCOMPARE(press(Qt::Key_Z, Qt::ControlModifier), QStringLiteral("Ren dexter"));
    QCOMPARE(press(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier),
             QStringLiteral("**Ren** dexter"));
    press(Qt::Key_Home);
    press(Qt::Key_End, Qt::ShiftModifier);
    QCOMPARE(press(Qt::Key_I, Qt::ControlModifier), QStringLiteral("***Ren** dexter*"));
    QVERIFY(!QApplication::activeModalWidget());
    QCOMPARE(press(Qt::Key_I, Qt::ControlModifier), QStringLiteral("**Ren** dexter"));
    press(Qt::Key_End);
    press(Qt::Key_Return, Qt::ShiftModifier);
    press(Qt::Key_B, Qt::ControlModifier);
    QTest::keyClicks(&f.editor(), QStringLiteral("x"));
    QCOMPARE(press(Qt::Key_Return), QStringLiteral("**Ren** dexter\n**x**"));
    QCOMPARE(f.only().text, std::string("**Ren** dexter\n**x**"));
    QCOMPARE(f.shownLines(), QStringList{QStringLiteral("Ren dexter/x")});
    const render::TextLine& line = f.sheet().plate.texts.front().lines.front();
    QVERIFY(line.runs.front() == (render::TextRun{"Ren", {.bold = true}}));
    // The same words that are not bold look different.
    const QImage heavy = f.whole();
    f.change([](model::Annotation& annotation) { annotation.text = "Ren dexter\nx"; });
    QCOMPARE(f.shownLines(), QStringList{QStringLiteral("Ren dexter/x")});
    QVERIFY(f.whole() != heavy);
    f.undo();
    f.undo();
    QVERIFY(f.annotations().empty());
  }

  /// A label's asterisks are not markup.
  void labelsAreNotMarkedUp() {
    Labels f;
    f.key(Qt::Key_T);
    f.click(f.middleOf(f.liver));
    QVERIFY(f.typing());
    QVERIFY(!f.editor().toolTip().contains("bold"));
    f.editor().selectAll();
    QTest::keyClick(&f.editor(), Qt::Key_B, Qt::ControlModifier);
    QCOMPARE(f.editor().toPlainText(), QStringLiteral("liver"));
    QTest::keyClicks(&f.editor(), QStringLiteral("**L5**"));
    QTest::keyClick(&f.editor(), Qt::Key_Return);
    QCOMPARE(f.shownLines(), QStringList{QStringLiteral("**L5**")});
  }

  void pastedTextIsPlain_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("html");
    QTest::addColumn<QString>("pasted");
    const QString html = QStringLiteral(
        "<html><body><p><b>Ren</b> <span style='color:red'>dexter</span></p><p>&lt;i&gt;<img "
        "src='file:///etc/passwd'></p></body></html>");
    QTest::newRow("word processor") << "Ren dexter\r\nx\vy" << html << "Ren dexter\nx\ny";
    QTest::newRow("html alone") << QString() << html << "Ren dexter\n<i>";
    QTest::newRow("html as text") << "<b>Ren</b>" << QString() << "<b>Ren</b>";
  }
  void pastedTextIsPlain() {
    QFETCH(QString, text);
    QFETCH(QString, html);
    QFETCH(QString, pasted);
    Labels f;
    f.key(Qt::Key_T, Qt::ShiftModifier);
    f.click(f.middleOf(f.liver));
    QVERIFY(f.typing());
    auto data = std::make_unique<QMimeData>();
    if (!text.isNull())
      data->setText(text);
    if (!html.isNull())
      data->setHtml(html);
    QGuiApplication::clipboard()->setMimeData(data.release());
    QTest::keyClick(&f.editor(), Qt::Key_V, Qt::ControlModifier);
    QCOMPARE(f.editor().toPlainText(), pasted);
    QTest::keyClick(&f.editor(), Qt::Key_Return);
    QCOMPARE(f.only().text, pasted.toStdString());
  }

  /// HTML is not interpreted, wherever words are shown.
  void wordsArePlain() {
    Labels f;
    const QString words = QStringLiteral("<b>x</b><img src=/etc/passwd>");
    f.make(f.liver, words, Qt::Key_T, Qt::ShiftModifier);
    QCOMPARE(f.only().text, words.toStdString());
    // The words are as typed, except where lines end.
    QCOMPARE(f.shownLines().join(QString()).remove('/').remove(' '),
             QString(words).remove('/').remove(' '));
    f.key(Qt::Key_F2);
    QVERIFY(f.typing());
    QCOMPARE(f.editor().toPlainText(), words);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::LabelsWordsTest)
#include "labels_words_test.moc"
