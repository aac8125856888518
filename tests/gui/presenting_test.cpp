// SPDX-License-Identifier: Apache-2.0
// Tests a presentation by its keys and the mouse: jumping, blank screens, laser, pen, notes, labels
// one by one and the quiz.
#include <QApplication>
#include <QPlainTextEdit>
#include <QPointer>
#include <algorithm>

#include "model/edit/annotations.h"
#include "model/edit/views.h"
#include "tests/gui/views_fixture.h"
#include "tests/support/suite.h"
#include "widgets/views/presentation_board.h"
#include "widgets/views/presentation_keys.h"
#include "widgets/views/presenter_window.h"

namespace sline::test {

namespace {

using Blank = widgets::PresentationBoard::Blank;

/// Three views of two balls that have a label each.
struct Presented : Views {
  model::Scene before;

  /// `spot`: the left ball has another label on its front, which is hidden from behind.
  explicit Presented(bool spot = false) {
    if (spot)
      session.apply(QStringLiteral("label"), model::withAnnotation(scene(), frontSpot()));
    for (const model::NodeId id : {left, right}) {
      model::Annotation label{.text = scene().find(id)->name};
      label.anchors = {model::SurfacePoint{id, 0, {0.3f, 0.3f}}};
      label.found = true;  // where one sees it: the quiz asks for nothing else
      session.apply(QStringLiteral("label"), model::withAnnotation(scene(), label));
    }
    addThree();
    showAllLabels();
    model::ViewWords words;
    words.title.text = "The <b>balls</b>";
    words.text.text = "Seen *from the front*";
    words.notes.text = "Say <i>hello</i>\nand wait";
    session.apply(QStringLiteral("words"), model::withViewWords(scene(), 0, words));
    before = presentedFrom(0);
  }
  ~Presented() { window.close(); }
  model::Annotation frontSpot() {
    const model::Mesh& mesh = *scene().find(left)->mesh;
    std::uint32_t front = 0;
    const auto depth = [&mesh](std::uint32_t triangle) {
      float y = 0.0f;
      for (const std::uint32_t corner : mesh.triangles()[triangle])
        y += mesh.positions()[corner].y;
      return y;
    };
    for (std::uint32_t i = 0; i < mesh.triangleCount(); ++i)
      if (depth(i) < depth(front))
        front = i;
    model::Annotation label{.text = "spot"};
    label.anchors = {model::SurfacePoint{left, front, {0.3f, 0.3f}}};
    return label;
  }
  void key(Qt::Key key, Qt::KeyboardModifiers with = {}) {
    QTest::keyClick(&viewport(), key, with);
  }
  widgets::PresentationBoard& board() {
    return *viewport().findChild<widgets::PresentationBoard*>();
  }
  QWidget& text() { return *viewport().findChild<QWidget*>(QStringLiteral("presentedText")); }
  widgets::PresenterWindow& presenter() {
    return *window.findChild<widgets::PresenterWindow*>(QStringLiteral("presenterWindow"));
  }
  int at() { return presented().section(' ', 0, 0).toInt(); }
  std::size_t labels() {
    const auto& all = viewport().shownScene().annotations();
    return std::size_t(
        std::count_if(all.begin(), all.end(), [](const auto& each) { return each.visible; }));
  }
  /// Clicks the ball of that name.
  void point(const QString& name) {
    const model::NodeId id = name.startsWith("left") ? left : right;
    QTest::mouseClick(&viewport(), Qt::LeftButton, {}, areaOf(id).center());
  }
};

}  // namespace

class PresentingTest : public QObject {
  Q_OBJECT

 private slots:
  void keysOfOthers_data();
  void keysOfOthers();
  void titleAndText();
  void theWindowMayGoMeanwhile();
  void jumping();
  void blanked();
  void laser();
  void pen();
  void notes();
  void oneByOne();
  void quiz();
  void quizAsksForWhatItsViewShows();
  void quizBesides();
  void placesOnScreens();
  void twoScreens();
  void leavesAllAlone();
};

void PresentingTest::keysOfOthers_data() {
  QTest::addColumn<int>("key");
  QTest::addColumn<int>("at");
  for (const Qt::Key on : {Qt::Key_Right, Qt::Key_Down, Qt::Key_Space, Qt::Key_PageDown, Qt::Key_N,
                           Qt::Key_Return, Qt::Key_Enter})
    QTest::newRow(qPrintable(QKeySequence(on).toString())) << int(on) << 3;
  for (const Qt::Key back :
       {Qt::Key_Left, Qt::Key_Up, Qt::Key_Backspace, Qt::Key_PageUp, Qt::Key_P, Qt::Key_Home})
    QTest::newRow(qPrintable(QKeySequence(back).toString())) << int(back) << 1;
  QTest::newRow("End") << int(Qt::Key_End) << 3;
  QTest::newRow("none") << int(Qt::Key_Z) << 2;
}

void PresentingTest::keysOfOthers() {
  QFETCH(int, key);
  QFETCH(int, at);
  Presented f;
  f.key(Qt::Key_2);
  f.key(Qt::Key_Return);
  QCOMPARE(f.at(), 2);
  f.key(Qt::Key(key));
  QCOMPARE(f.at(), at);
}

/// What the view says is there, in plain letters; HTML stays text.
void PresentingTest::titleAndText() {
  Presented f;
  QCOMPARE(f.presented(), QString("1 / 3   The <b>balls</b>"));
  QVERIFY(f.text().isVisible());
  QCOMPARE(f.text().accessibleName(), QString("Seen from the front"));
  const auto& name = f.control<QLabel>("presentedView");
  QCOMPARE(name.textFormat(), Qt::PlainText);
  QVERIFY(!f.text().geometry().intersects(name.geometry()));
  QVERIFY(f.viewport().rect().contains(f.text().geometry()));
  f.key(Qt::Key_Right);
  QCOMPARE(f.presented(), QString("2 / 3   View 2"));
  QVERIFY(!f.text().isVisible());
}

void PresentingTest::theWindowMayGoMeanwhile() {
  QPointer<widgets::PresentationBoard> board;
  {
    Views f;
    f.addThree();
    f.clickCard(0);
    QTest::keyClick(&f.viewport(), Qt::Key_F5, Qt::ShiftModifier);
    QVERIFY(f.settled());
    board = f.viewport().findChild<widgets::PresentationBoard*>();
    QVERIFY(board && board->isVisible());
  }
  QVERIFY(!board);
}

void PresentingTest::jumping() {
  Presented f;
  f.key(Qt::Key_3);
  QCOMPARE(f.at(), 1);
  f.key(Qt::Key_Return);
  QCOMPARE(f.at(), 3);
  f.key(Qt::Key_9);
  f.key(Qt::Key_Return);
  QCOMPARE(f.at(), 3);
  f.key(Qt::Key_2, Qt::KeypadModifier);
  f.key(Qt::Key_Enter, Qt::KeypadModifier);
  QCOMPARE(f.at(), 2);
  // Another key forgets the number.
  f.key(Qt::Key_1);
  f.key(Qt::Key_Left);
  QCOMPARE(f.at(), 1);
  f.key(Qt::Key_Return);
  QCOMPARE(f.at(), 2);
  for (int i = 0; i < 30; ++i)
    f.key(Qt::Key_9);
  f.key(Qt::Key_Return);
  QCOMPARE(f.at(), 2);
}

/// A key that would go on brings the picture back, so that no view is passed over unseen.
void PresentingTest::blanked() {
  Presented f;
  const QPoint middle = f.viewport().rect().center();
  const auto seen = [&] { return f.viewport().grab().toImage().pixelColor(middle); };
  for (const Qt::Key key : {Qt::Key_B, Qt::Key_Period}) {
    f.key(key);
    QCOMPARE(seen(), QColor(Qt::black));
    f.key(key);
    QCOMPARE(f.board().blank(), Blank::none);
  }
  for (const Qt::Key key : {Qt::Key_W, Qt::Key_Comma}) {
    f.key(key);
    QCOMPARE(seen(), QColor(Qt::white));
    f.key(Qt::Key_PageDown);
    QCOMPARE(f.board().blank(), Blank::none);
    QCOMPARE(f.at(), 1);
  }
  f.key(Qt::Key_B);
  f.key(Qt::Key_W);
  QCOMPARE(f.board().blank(), Blank::white);
  // The mouse turns nothing behind it.
  const model::Camera camera = f.viewport().camera();
  QVERIFY(!f.board().testAttribute(Qt::WA_TransparentForMouseEvents));
  dragMouse(f.board(), {300, 300}, {340, 300});
  QVERIFY(f.viewport().camera() == camera);
}

void PresentingTest::laser() {
  Presented f;
  f.key(Qt::Key_L);
  sendMouse(f.viewport(), QEvent::MouseMove, {310.0, 220.0}, Qt::NoButton);
  QVERIFY(f.board().dot());
  QCOMPARE(*f.board().dot(), QPointF(310.0, 220.0));
  QVERIFY(QApplication::overrideCursor());
  const QColor dot = f.viewport().grab().toImage().pixelColor(310, 220);
  QVERIFY2(dot.red() > 200 && dot.green() < 130, qPrintable(dot.name()));
  // The mouse still turns the scene.
  const model::Camera camera = f.viewport().camera();
  dragMouse(f.viewport(), {300, 300}, {360, 300});
  QVERIFY(!(f.viewport().camera() == camera));
  f.key(Qt::Key_L);
  QVERIFY(!f.board().dot() && !QApplication::overrideCursor());
  f.key(Qt::Key_L);
  sendMouse(f.viewport(), QEvent::MouseMove, {310.0, 220.0}, Qt::NoButton);
  f.key(Qt::Key_Escape);
  QVERIFY(!QApplication::overrideCursor());
}

void PresentingTest::pen() {
  Presented f;
  const model::Camera camera = f.viewport().camera();
  for (const auto with : {Qt::KeyboardModifiers(), Qt::KeyboardModifiers(Qt::ControlModifier)}) {
    f.key(with ? Qt::Key_P : Qt::Key_D, with);
    dragMouse(f.board(), {200, 150}, {280, 210});
    QCOMPARE(f.board().drawn().size(), std::size_t(1));
    const QColor ink = f.viewport().grab().toImage().pixelColor(240, 180);
    QVERIFY2(ink.red() > 180 && ink.green() < 90, qPrintable(ink.name()));
    QVERIFY(f.viewport().camera() == camera);
    // What was drawn is gone with the next view; the pen stays.
    f.key(Qt::Key_Right);
    QVERIFY(f.board().drawn().empty());
    dragMouse(f.board(), {200, 150}, {280, 210});
    QCOMPARE(f.board().drawn().size(), std::size_t(1));
    f.key(Qt::Key_E);
    QVERIFY(f.board().drawn().empty());
    f.key(Qt::Key_Left);
    f.key(Qt::Key_D);
    QVERIFY(f.board().testAttribute(Qt::WA_TransparentForMouseEvents));
  }
}

void PresentingTest::notes() {
  Presented f;
  widgets::PresenterWindow& presenter = f.presenter();
  const bool besides = QGuiApplication::screens().size() > 1;
  QCOMPARE(presenter.isVisible(), besides);
  f.key(Qt::Key_S);
  QCOMPARE(presenter.isVisible(), !besides);
  if (besides)
    f.key(Qt::Key_S);
  QCOMPARE(presenter.findChild<QPlainTextEdit*>("presenterNotes")->toPlainText(),
           QString("Say <i>hello</i>\nand wait"));
  const auto said = [&](const char* name) { return presenter.findChild<QLabel*>(name)->text(); };
  QCOMPARE(said("presenterTitle"), QString("The <b>balls</b>"));
  QCOMPARE(said("presenterNext"), QString("Next: View 2"));
  QCOMPARE(said("presenterPlace"), QString("1 / 3"));
  QVERIFY2(said("presenterClock").endsWith("0:00") || said("presenterClock").contains(" 0:0"),
           qPrintable(said("presenterClock")));
  QTRY_VERIFY(!presenter.findChild<QLabel*>("presenterPicture")->pixmap().isNull());
  for (QLabel* label : presenter.findChildren<QLabel*>())
    QCOMPARE(label->textFormat(), Qt::PlainText);
  f.key(Qt::Key_End);
  QCOMPARE(said("presenterNext"), QString("This is the last view"));
  QVERIFY(presenter.findChild<QPlainTextEdit*>("presenterNotes")->toPlainText().isEmpty());
  f.key(Qt::Key_S);
  QVERIFY(!presenter.isVisible());
  f.key(Qt::Key_S);
  f.key(Qt::Key_Escape);
  QVERIFY(!presenter.isVisible());
}

void PresentingTest::oneByOne() {
  Presented f;
  QCOMPARE(f.labels(), std::size_t(2));
  f.key(Qt::Key_R);
  QCOMPARE(f.labels(), std::size_t(0));
  f.key(Qt::Key_Space);
  QCOMPARE(f.labels(), std::size_t(1));
  QVERIFY(f.viewport().shownScene().annotations().front().visible);
  f.key(Qt::Key_Space);
  QCOMPARE(f.labels(), std::size_t(2));
  QCOMPARE(f.at(), 1);
  f.key(Qt::Key_Left);
  QCOMPARE(f.labels(), std::size_t(1));
  f.key(Qt::Key_Space);
  f.key(Qt::Key_Space);
  QCOMPARE(f.at(), 2);
  QCOMPARE(f.labels(), std::size_t(0));
  // Back at the view before, all that was revealed is there.
  f.key(Qt::Key_Left);
  QCOMPARE(f.at(), 1);
  QCOMPARE(f.labels(), std::size_t(2));
  f.key(Qt::Key_R);
  f.key(Qt::Key_Right);
  QCOMPARE(f.at(), 2);
  QCOMPARE(f.labels(), std::size_t(2));
}

/// Fifty runs by the mouse: each label is asked for once, and the score is what was clicked right.
void PresentingTest::quiz() {
  Presented f;
  for (int run = 0; run < 50; ++run) {
    f.key(Qt::Key_Q);
    QTRY_COMPARE(f.labels(), std::size_t(0));
    QVERIFY(!f.text().isVisible());
    QSet<QString> asked;
    int right = 0;
    for (int i = 0; i < 2; ++i) {
      const QString question = f.presented();
      QVERIFY2(question.startsWith(QString("%1 / 2   Point at: ").arg(i + 1)),
               qPrintable(question));
      const QString wanted = question.section(": ", 1);
      asked << wanted;
      const bool knows = ((run >> i) & 1) != 0;
      const QString other = wanted == "left ball" ? "right ball" : "left ball";
      f.point(knows ? wanted : other);
      QTRY_VERIFY(f.presented() != question);
      QCOMPARE(f.presented(), knows
                                  ? "Right: " + wanted
                                  : QString("No, that is: %1. Outlined is: %2").arg(other, wanted));
      right += int(knows);
      if (run % 2 == 0)
        f.key(Qt::Key_PageDown);
      else
        f.point(other);
    }
    QCOMPARE(asked.size(), 2);
    QCOMPARE(f.presented(), QString("%1 of 2 right").arg(right));
    f.key(Qt::Key_Space);
    QCOMPARE(f.presented(), QString("1 / 3   The <b>balls</b>"));
    QCOMPARE(f.labels(), std::size_t(2));
  }
}

/// What one sees decides what is asked for, in the view at hand: its picture may come after the
/// key.
void PresentingTest::quizAsksForWhatItsViewShows() {
  Presented f(true);
  f.key(Qt::Key_Q);
  QTRY_VERIFY2(f.presented().startsWith("1 / 3 "), qPrintable(f.presented()));
  f.key(Qt::Key_Escape);
  for (int run = 0; run < 3; ++run) {
    QVERIFY(f.settled());
    f.key(run % 2 == 0 ? Qt::Key_Right : Qt::Key_Left);
    f.key(Qt::Key_Q);
    const QString wanted = run % 2 == 0 ? "1 / 2   Point at" : "1 / 3   Point at";
    QTRY_VERIFY2(f.presented().startsWith(wanted), qPrintable(f.presented()));
    QCOMPARE(f.labels(), std::size_t(0));
    f.key(Qt::Key_Escape);
  }
  // So it is where labels come one by one, and none is there yet.
  QVERIFY(f.settled());
  f.key(Qt::Key_R);
  QVERIFY(f.settled());
  f.key(Qt::Key_Q);
  QTRY_VERIFY2(f.presented().startsWith("1 / 2   Point at"), qPrintable(f.presented()));
  f.key(Qt::Key_Escape);
  QCOMPARE(f.labels(), std::size_t(0));
  // A second press, or another key, takes it back.
  f.key(Qt::Key_Right);
  f.key(Qt::Key_Q);
  f.key(Qt::Key_Q);
  QVERIFY(f.settled());
  QVERIFY2(f.presented().startsWith("2 / 3   View 2"), qPrintable(f.presented()));
  QCOMPARE(f.labels(), std::size_t(1));
}

/// A click beside the anatomy is no answer, a drag turns the scene, and Esc ends the quiz alone.
void PresentingTest::quizBesides() {
  Presented f;
  f.key(Qt::Key_Q);
  QTRY_VERIFY(f.presented().contains("Point at"));
  const QString question = f.presented();
  QTest::mouseClick(&f.viewport(), Qt::LeftButton, {}, {4, 4});
  const model::Camera camera = f.viewport().camera();
  dragMouse(f.viewport(), f.areaOf(f.left).center(), f.areaOf(f.left).center() + QPoint(60, 0));
  QVERIFY(!(f.viewport().camera() == camera));
  QVERIFY(f.settled());
  QCOMPARE(f.presented(), question);
  f.key(Qt::Key_Escape);
  QCOMPARE(f.presented(), QString("1 / 3   The <b>balls</b>"));
  f.key(Qt::Key_Q);
  QTRY_VERIFY(f.presented().contains("Point at"));
  f.key(Qt::Key_2);
  f.key(Qt::Key_Return);
  QCOMPARE(f.at(), 2);
  QCOMPARE(f.labels(), std::size_t(2));
  f.key(Qt::Key_Escape);
  QVERIFY(f.presented().isEmpty());
  // Without labels there is nothing to ask for.
  f.window.close();
  Views none;
  none.addThree();
  QTest::keyClick(&none.viewport(), Qt::Key_F5, Qt::ShiftModifier);
  QTest::keyClick(&none.viewport(), Qt::Key_Q);
  QTRY_COMPARE(none.presented(), QString("No label here names anything to ask for"));
  QTest::keyClick(&none.viewport(), Qt::Key_Space);
  QCOMPARE(none.presented(), QString("3 / 3   View 3"));
  none.window.close();
}

void PresentingTest::placesOnScreens() {
  const QRect laptop(0, 0, 1280, 800);
  const QRect projector(1280, 0, 1024, 768);
  const auto one = widgets::presentationPlaces({laptop}, {600, 400});
  QVERIFY(one.picture == 0 && !one.presenter);
  const auto two = widgets::presentationPlaces({laptop, projector}, {600, 400});
  QVERIFY(two.picture == 1 && two.presenter == 0);
  const auto back = widgets::presentationPlaces({laptop, projector}, {1500, 400});
  QVERIFY(back.picture == 0 && back.presenter == 1);
  const auto mirrored = widgets::presentationPlaces({laptop, QRect(0, 0, 1024, 768)}, {600, 400});
  QVERIFY(mirrored.picture == 0 && !mirrored.presenter);
}

/// Where there are two screens, picture and notes have one each, and the window is back in its
/// place afterwards.
void PresentingTest::twoScreens() {
  if (QGuiApplication::screens().size() < 2)
    QSKIP("there is one screen; presenting_two_screens has two");
  Presented f;
  const QRect own = f.presenter().screen()->geometry();
  const QRect other = f.window.screen()->geometry();
  QVERIFY(own != other);
  QCOMPARE(f.presenter().geometry(), own);
  QTRY_COMPARE(f.window.geometry(), other);
  QTest::keyClick(&f.viewport(), Qt::Key_Right);
  QCOMPARE(f.presenter().findChild<QLabel*>("presenterPlace")->text(), QString("2 / 3"));
  QTest::keyClick(&f.viewport(), Qt::Key_Escape);
  QTRY_VERIFY(own.contains(f.window.geometry().center()));
  QVERIFY(f.settled());
}

void PresentingTest::leavesAllAlone() {
  Presented f;
  const int steps = f.steps();
  for (const Qt::Key key : {Qt::Key_L, Qt::Key_D, Qt::Key_R, Qt::Key_Q, Qt::Key_S, Qt::Key_B,
                            Qt::Key_W, Qt::Key_E, Qt::Key_Delete})
    f.key(key);
  f.key(Qt::Key_Z, Qt::ControlModifier);
  f.key(Qt::Key_Escape);
  f.key(Qt::Key_Escape);
  QVERIFY(f.presented().isEmpty() && !f.text().isVisible());
  QVERIFY(!f.board().isVisible() && !f.presenter().isVisible());
  QVERIFY(f.settled());
  QVERIFY(f.scene() == f.before && f.steps() == steps);
  QVERIFY(!f.window.isFullScreen());
}

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::PresentingTest)
#include "presenting_test.moc"
