// SPDX-License-Identifier: Apache-2.0
// Tests links in presented texts by the mouse: in a view's text, in a callout and in the notes.
#include <QPlainTextEdit>
#include <QTextBlock>
#include <algorithm>

#include "model/edit/annotations.h"
#include "model/edit/views.h"
#include "model/edit/visibility.h"
#include "tests/gui/views_fixture.h"
#include "tests/support/suite.h"
#include "widgets/views/presented_links.h"
#include "widgets/views/presenter_window.h"

namespace sline::test {

namespace {

/// Three views of two balls; the first says something with links, the last hides the right ball.
struct Linked : Views {
  model::Scene before;

  Linked() {
    model::Annotation callout{.kind = model::AnnotationKind::callout,
                              .text = "The **right** one: [behind](#view=2)"};
    callout.anchors = {model::SurfacePoint{right, 0, {0.3f, 0.3f}}};
    session.apply(QStringLiteral("callout"), model::withAnnotation(scene(), callout));
    addThree();
    showAllLabels();
    session.apply(QStringLiteral("hide"), model::withHidden(scene(), std::array{right}));
    session.apply(
        QStringLiteral("view"),
        model::withViewUpdated(scene(), 2, model::viewOf(scene(), viewport().camera(), "")));
    session.apply(QStringLiteral("show"), model::withShown(scene(), std::array{right}));
    say(0, "See the [left one](#structure=left_ball), then [behind](#view=2), [no](#structure=no)",
        "Say [right](#structure=right ball)\nand [last](#view=View 3)");
    say(2, "What about the [right one](#structure=right ball)?", "");
    before = presentedFrom(0);
  }
  ~Linked() { window.close(); }

  void say(std::size_t index, const char* text, const char* notes) {
    model::ViewWords words;
    words.text.text = text;
    words.notes.text = notes;
    session.apply(QStringLiteral("words"), model::withViewWords(scene(), index, words));
  }
  widgets::PresentedLinks& links() {
    return *viewport().findChild<widgets::PresentedLinks*>(QStringLiteral("presentedLinks"));
  }
  /// Clicks the link of that number, in the order of texts.
  void follow(std::size_t number) {
    const std::vector<QRectF> areas = links().areas();
    if (number >= areas.size())
      qFatal("there are %d links", int(areas.size()));
    QTest::mouseClick(&viewport(), Qt::LeftButton, {}, areas[number].center().toPoint());
    if (!settled())
      qFatal("no picture");
  }
  QImage picture() { return viewport().picture(); }
  int at() { return presented().section(' ', 0, 0).toInt(); }
};

}  // namespace

class PresentedLinksTest : public QObject {
  Q_OBJECT

 private slots:
  /// Only what leads somewhere is a link, in the caption's place or the callout's.
  void areWhereTheirWordsAre() {
    Linked f;
    const std::vector<QRectF> areas = f.links().areas();
    QCOMPARE(areas.size(), std::size_t(3));
    const QRectF caption(f.control<QWidget>("presentedText").geometry());
    QVERIFY(caption.contains(areas[0].center()) && caption.contains(areas[1].center()));
    QVERIFY(!caption.contains(areas[2].center()));
    QVERIFY(f.viewport().labels().layer().sheet());
    QCOMPARE(f.control<QWidget>("presentedText").accessibleName(),
             QString("See the left one, then behind, no"));
  }

  void lightStructuresUp() {
    Linked f;
    const QImage dark = f.picture();
    f.follow(0);
    QCOMPARE(f.at(), 1);
    const QImage lit = f.picture();
    QVERIFY(lit != dark);
    f.follow(0);
    QVERIFY(f.picture() == dark);
    f.follow(0);
    // The next view has no part in it.
    QTest::keyClick(&f.viewport(), Qt::Key_Right);
    QTest::keyClick(&f.viewport(), Qt::Key_Left);
    QVERIFY(f.settled());
    QVERIFY(f.picture() == dark);
    QVERIFY(f.scene() == f.before);
  }

  /// What the view hides is there while it is lit.
  void showWhatIsHidden() {
    Linked f;
    QTest::keyClick(&f.viewport(), Qt::Key_End);
    QVERIFY(f.settled());
    QCOMPARE(f.at(), 3);
    const auto seen = [&] { return f.viewport().shownScene().resolve(f.right).visible; };
    QVERIFY(!seen());
    f.follow(0);
    QVERIFY(seen());
    f.follow(0);
    QVERIFY(!seen());
  }

  void goToViews() {
    Linked f;
    f.follow(1);
    QCOMPARE(f.at(), 2);
    QTest::keyClick(&f.viewport(), Qt::Key_Home);
    QVERIFY(f.settled());
    f.follow(2);  // the callout's
    QCOMPARE(f.at(), 2);
  }

  /// A drag that begins on a link turns the scene; a link has the hand of links.
  void areNoObstacles() {
    Linked f;
    const QPoint place = f.links().areas()[1].center().toPoint();
    sendMouse(f.viewport(), QEvent::MouseMove, QPointF(place), Qt::NoButton);
    QCOMPARE(f.viewport().cursor().shape(), Qt::PointingHandCursor);
    sendMouse(f.viewport(), QEvent::MouseMove, {4.0, 4.0}, Qt::NoButton);
    QVERIFY(f.viewport().cursor().shape() != Qt::PointingHandCursor);
    const model::Camera camera = f.viewport().camera();
    dragMouse(f.viewport(), place, place + QPoint(60, 0));
    QVERIFY(!(f.viewport().camera() == camera));
    QCOMPARE(f.at(), 1);
    // The quiz hides them.
    QTest::keyClick(&f.viewport(), Qt::Key_Q);
    QTRY_VERIFY(f.links().areas().empty());
    QVERIFY(f.settled());
    QTest::keyClick(&f.viewport(), Qt::Key_Escape);
    QVERIFY(f.settled());
    QTRY_COMPARE(f.links().areas().size(), std::size_t(3));
    QTest::keyClick(&f.viewport(), Qt::Key_Escape);
    QVERIFY(!f.links().isVisible() && f.links().areas().empty());
  }

  void inNotes() {
    Linked f;
    auto& presenter = *f.window.findChild<widgets::PresenterWindow*>("presenterWindow");
    if (!presenter.isVisible())
      QTest::keyClick(&f.viewport(), Qt::Key_S);
    auto& notes = *presenter.findChild<QPlainTextEdit*>("presenterNotes");
    QCOMPARE(notes.toPlainText(), QString("Say right\nand last"));
    const auto click = [&](int line, int letter) {
      QTextCursor cursor(notes.document()->findBlockByNumber(line));
      cursor.setPosition(cursor.position() + letter);
      QTest::mouseClick(notes.viewport(), Qt::LeftButton, {},
                        notes.cursorRect(cursor).center() + QPoint(2, 0));
      if (!f.settled())
        qFatal("no picture");
    };
    const QImage dark = f.picture();
    click(0, 1);
    QVERIFY(f.picture() == dark);
    click(0, 6);
    QVERIFY(f.picture() != dark);
    click(1, 6);
    QCOMPARE(f.at(), 3);
  }
};

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::PresentedLinksTest)
#include "presented_links_test.moc"
