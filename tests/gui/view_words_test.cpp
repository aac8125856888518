// SPDX-License-Identifier: Apache-2.0
// Tests what a view says, typed below the cards and seen in the picture.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPaintEvent>
#include <QPlainTextEdit>

#include "model/edit/annotations.h"
#include "model/edit/views.h"
#include "tests/gui/views_fixture.h"
#include "tests/support/suite.h"
#include "widgets/annotations/label_preferences.h"

namespace sline::test {

namespace {

struct Words : Views {
  Words() {
    addThree();
    clickCard(1);
    press("viewWords");
    if (!settled())
      qFatal("no picture");
  }
  QLineEdit& title() { return control<QLineEdit>("viewTitle"); }
  QPlainTextEdit& text() { return control<QPlainTextEdit>("viewText"); }
  QPlainTextEdit& notes() { return control<QPlainTextEdit>("viewNotes"); }
  QWidget& caption() { return *viewport().findChild<QWidget*>(QStringLiteral("viewCaption")); }
  const model::ViewWords& said(std::size_t index = 1) { return scene().views()[index].words; }
  void speak(const QString& tag) {
    auto& box = control<QComboBox>("viewLanguage");
    box.setFocus();
    for (int i = 0; i < box.count() && box.currentData().toString() != tag; ++i)
      QTest::keyClick(&box, Qt::Key_Down);
    for (int i = 0; i < box.count() && box.currentData().toString() != tag; ++i)
      QTest::keyClick(&box, Qt::Key_Up);
    QCOMPARE(box.currentData().toString(), tag);
  }
};

/// Notes whether all of a widget is painted anew.
class Painted : public QObject {
 public:
  explicit Painted(QWidget& widget) : m_widget(widget) { widget.installEventFilter(this); }
  bool whole() const { return m_whole; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::Paint)
      m_whole = m_whole || static_cast<QPaintEvent*>(event)->rect().contains(m_widget.rect());
    return QObject::eventFilter(watched, event);
  }

 private:
  QWidget& m_widget;
  bool m_whole = false;
};

}  // namespace

class ViewWordsTest : public QObject {
  Q_OBJECT

 private slots:
  void typed();
  void whatItShows();
  void eachViewItsOwn();
  void inLanguages();
  void undone();
  void hostile();
  void hintsFollow();
  void preview();
  void labelsGiveWay();
  void remembered();
  void madeAnew();
};

void ViewWordsTest::typed() {
  Words f;
  f.speak("scene");
  QTest::keyClicks(&f.title(), "From behind");
  QTest::keyClicks(&f.text(), "Two **balls**");
  QTest::keyClick(&f.text(), Qt::Key_Return);
  QTest::keyClicks(&f.text(), "- left");
  QTest::keyClicks(&f.notes(), "Ask which is left");
  auto& seconds = f.control<QDoubleSpinBox>("viewSeconds");
  seconds.setFocus();
  seconds.selectAll();
  QTest::keyClicks(&seconds, "7.5");
  QTest::keyClick(&seconds, Qt::Key_Return);
  QCOMPARE(f.said().title.text, std::string("From behind"));
  QCOMPARE(f.said().text.text, std::string("Two **balls**\n- left"));
  QCOMPARE(f.said().notes.text, std::string("Ask which is left"));
  QCOMPARE(f.said().seconds, std::optional(7.5f));
  QVERIFY(f.said(0) == model::ViewWords() && f.said(2) == model::ViewWords());
  QCOMPARE(f.names(), QString("View 1|View 2|View 3"));
  seconds.setValue(0.0);
  QVERIFY(!f.said().seconds);
  // Ctrl+B marks what is chosen, as in callouts.
  f.text().setPlainText("levator ani");
  f.text().selectAll();
  QTest::keyClick(&f.text(), Qt::Key_B, Qt::ControlModifier);
  QCOMPARE(f.said().text.text, std::string("**levator ani**"));
}

/// What is told who does not see the picture is typed beside the rest, and is in no caption.
void ViewWordsTest::whatItShows() {
  Words f;
  f.speak("scene");
  auto& field = f.control<QPlainTextEdit>("viewDescription");
  QVERIFY(field.placeholderText().contains("does not see"));
  QTest::keyClicks(&field, "Two balls & a third");
  QCOMPARE(f.said().description.text, std::string("Two balls & a third"));
  f.speak("de");
  QCOMPARE(field.toPlainText(), QString());
  QCOMPARE(field.placeholderText(), QString("Two balls & a third"));
  QTest::keyClicks(&field, "Kugeln");
  QCOMPARE(f.said().description.texts.at("de"), std::string("Kugeln"));
  QVERIFY(f.said().text.empty() && f.said().notes.empty());
}

void ViewWordsTest::eachViewItsOwn() {
  Words f;
  f.speak("scene");
  QTest::keyClicks(&f.title(), "Second");
  f.clickCard(0);
  QVERIFY(f.title().text().isEmpty());
  QCOMPARE(f.title().placeholderText(), QString("View 1"));
  QTest::keyClicks(&f.notes(), "of the first");
  f.clickCard(1);
  QCOMPARE(f.title().text(), QString("Second"));
  QVERIFY(f.notes().toPlainText().isEmpty());
  // What it says goes along where it is moved, and updating leaves it.
  QTest::keyClick(&f.row(), Qt::Key_Left, Qt::AltModifier);
  QCOMPARE(f.said(0).title.text, std::string("Second"));
  QCOMPARE(f.title().text(), QString("Second"));
  f.press("viewUpdate");
  QCOMPARE(f.said(0).title.text, std::string("Second"));
  f.press("viewDelete");
  f.press("viewDelete");
  f.press("viewDelete");
  QVERIFY(!f.title().isEnabled());
  QVERIFY(!f.caption().isVisible());
}

void ViewWordsTest::inLanguages() {
  Words f;
  f.speak("scene");
  QTest::keyClicks(&f.text(), "From below");
  f.speak("de");
  QVERIFY(f.text().toPlainText().isEmpty());
  QCOMPARE(f.text().placeholderText(), QString("From below"));
  QTest::keyClicks(&f.text(), "Von unten");
  QCOMPARE(f.said().text.in("de"), std::string("Von unten"));
  QCOMPARE(f.said().text.text, std::string("From below"));
  QCOMPARE(f.caption().accessibleName(), QString("Von unten"));
  f.speak("scene");
  QCOMPARE(f.text().toPlainText(), QString("From below"));
  f.speak("de");
  f.text().clear();
  QVERIFY(f.said().text.texts.empty());
  QCOMPARE(f.caption().accessibleName(), QString("From below"));
}

/// What another view says is not left standing in a field where this one says nothing.
void ViewWordsTest::hintsFollow() {
  Words f;
  f.speak("scene");
  QTest::keyClicks(&f.text(), "From below");
  f.speak("de");
  QCOMPARE(f.text().placeholderText(), QString("From below"));
  QVERIFY(f.settled());
  const Painted painted(*f.text().viewport());
  f.clickCard(0);
  QCOMPARE(f.text().placeholderText(), QString("Text, to be read with the view"));
  QTRY_VERIFY(painted.whole());
}

void ViewWordsTest::undone() {
  Words f;
  f.speak("scene");
  const int steps = f.steps();
  QTest::keyClicks(&f.title(), "Typed in one go");
  QCOMPARE(f.steps(), steps + 1);
  QTest::keyClicks(&f.notes(), "and more");
  QCOMPARE(f.steps(), steps + 2);
  f.undo();
  QVERIFY(f.notes().toPlainText().isEmpty());
  QCOMPARE(f.title().text(), QString("Typed in one go"));
  f.undo();
  QVERIFY(f.title().text().isEmpty() && f.said() == model::ViewWords());
  f.session.redo();
  QCOMPARE(f.title().text(), QString("Typed in one go"));
}

/// Words stay words: in the picture, in the cards' tips and in the fields.
void ViewWordsTest::hostile() {
  Words f;
  f.speak("scene");
  const QString words = "<img src='file:///etc/passwd'><b>x</b> &amp; %1 \u202eabc";
  f.title().setFocus();
  f.title().setText({});
  f.title().insert(words);
  f.text().setPlainText(words);
  QCOMPARE(f.said().text.text, words.toStdString());
  QVERIFY(f.caption().accessibleName().contains("<b>x</b> &amp; %1"));
  model::ViewWords said = f.said();
  said.title.text = words.toStdString();
  f.session.apply("words", model::withViewWords(f.scene(), 1, said));
  QVERIFY(f.caption().accessibleName().startsWith("<img src="));
  QVERIFY(f.settled());
}

/// Title and text stand over the picture's foot while the fields are there; labels give way.
void ViewWordsTest::preview() {
  Words f;
  f.speak("scene");
  QVERIFY(!f.caption().isVisible());
  const auto seen = [&f] { return f.viewport().grab().toImage(); };
  const QImage bare = seen();
  QTest::keyClicks(&f.text(), "Seen *from behind*");
  QVERIFY(f.caption().isVisible());
  QVERIFY(f.settled());
  const QRect place = f.caption().geometry();
  QVERIFY(f.viewport().rect().contains(place));
  QVERIFY(qAbs(place.center().x() - f.viewport().rect().center().x()) <= 2);
  QVERIFY(place.center().y() > f.viewport().height() * 3 / 4);
  const QRect changed = difference(bare, seen());
  QVERIFY(!changed.isEmpty());
  const double ratio = f.viewport().devicePixelRatioF();
  const QRect onScreen(place.topLeft() * ratio, place.size() * ratio);
  QVERIFY2(onScreen.adjusted(-2, -2, 2, 2).contains(changed), "more than the caption changed");
  f.clickCard(0);
  QVERIFY(!f.caption().isVisible());
  f.clickCard(1);
  QVERIFY(f.caption().isVisible());
  f.press("viewWords");
  QVERIFY(!f.caption().isVisible() && !f.text().isVisible());
  QVERIFY(f.settled());
}

/// The words lie over no label, leader or dot: what a label names is pointed at beside them.
void ViewWordsTest::labelsGiveWay() {
  Words f;
  f.speak("scene");
  const auto sheet = [&f] { return f.viewport().labels().layer().sheet(); };
  const auto now = [&f] { return f.session.scene(); };
  for (const model::NodeId id : {f.left, f.right})
    f.session.apply("label", model::withAnnotation(
                                 now(), {.anchors = {model::SurfacePoint{id, 0, {0.3f, 0.3f}}},
                                         .text = "a ball",
                                         .found = true}));
  QVERIFY(f.settled());
  f.text().setPlainText(QString("One\n") + QString("- more\n").repeated(12));
  QVERIFY(f.caption().isVisible());
  QVERIFY(f.settled());
  QVERIFY(sheet());
  const float scale = sheet()->wish.pixelsPerMm;
  const QRectF words = f.caption().geometry();
  const render::LabelBox covered{glm::vec2(float(words.left()), float(words.top())) / scale,
                                 glm::vec2(float(words.right()), float(words.bottom())) / scale};
  int ends = 0;
  for (const render::ShownLabel& label : sheet()->plate.labels)
    if (const render::PlacedLabel* placed = sheet()->plate.layout.find(label.item.id)) {
      QVERIFY(!render::overlap(placed->box, covered));
      QVERIFY(!render::runsThrough(placed->leader, covered));
      QVERIFY(!covered.contains(label.item.places[0]));
      ++ends;
    }
  QCOMPARE(ends, 2);
}

void ViewWordsTest::remembered() {
  Words f;
  QVERIFY(f.text().isVisible());
  QVERIFY(f.settings.value("views/words").toBool());
  const int high = f.dock().height();
  QVERIFY2(high > 170 && high <= 230, qPrintable(QString::number(high)));
  f.press("viewWords");
  QVERIFY(!f.settings.value("views/words").toBool());
  QTRY_VERIFY(f.dock().height() <= 130);
}

/// Controls that are made anew, as in another language, leave no second caption in the picture.
void ViewWordsTest::madeAnew() {
  Words f;
  f.speak("scene");
  QTest::keyClicks(&f.text(), "Seen from behind");
  QVERIFY(f.caption().isVisible());
  QEvent change(QEvent::LanguageChange);
  QCoreApplication::sendEvent(&f.window, &change);
  const auto captions = f.viewport().findChildren<QWidget*>(QStringLiteral("viewCaption"));
  QCOMPARE(captions.size(), 1);
  QVERIFY(f.text().isVisible());
  f.clickCard(1);
  QVERIFY(f.caption().isVisible());
  QCOMPARE(f.text().toPlainText(), QString("Seen from behind"));
}

}  // namespace sline::test

SLINE_TEST_WITH_WIDGETS(sline::test::ViewWordsTest)
#include "view_words_test.moc"
