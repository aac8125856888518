// SPDX-License-Identifier: Apache-2.0
// Tests what labels say in several languages at once.
#include "model/scene/label_words.h"

#include <QTest>

#include "model/scene/markup.h"
#include "tests/support/suite.h"

namespace sline::model {

class LabelWordsTest : public QObject {
  Q_OBJECT
 private slots:
  void says_data() {
    QTest::addColumn<QString>("tags");
    QTest::addColumn<QString>("words");
    QTest::newRow("the scene's own") << ""
                                     << "bladder";
    QTest::newRow("one") << "de"
                         << "Harnblase";
    QTest::newRow("two") << "de+la"
                         << "Harnblase / Vesica urinaria";
    QTest::newRow("the other way round") << "la+de"
                                         << "Vesica urinaria / Harnblase";
    QTest::newRow("three") << "de+la+nl"
                           << "Harnblase / Vesica urinaria / blaas";
    QTest::newRow("the scene's own and one") << "+la"
                                             << "bladder / Vesica urinaria";
    QTest::newRow("the same twice") << "de+at+de"
                                    << "Harnblase";
    QTest::newRow("said alike in both") << "la+it"
                                        << "Vesica urinaria";
    QTest::newRow("first without words") << "fr+la"
                                         << "bladder / Vesica urinaria";
    QTest::newRow("second without words") << "de+fr"
                                          << "Harnblase";
  }
  void says() {
    QFETCH(QString, tags);
    const Annotation label{.anchors = {glm::vec3(0.0f)},
                           .text = "bladder",
                           .texts = {{"de", "Harnblase"},
                                     {"at", "Harnblase"},
                                     {"la", "Vesica urinaria"},
                                     {"it", "Vesica urinaria"},
                                     {"nl", "blaas"}}};
    QTEST(QString::fromStdString(writtenIn(label, tags.toStdString())), "words");
    QTEST(QString::fromStdString(plainTextIn(label, tags.toStdString())), "words");
  }
  void calloutsHaveOneBelowTheOther() {
    const Annotation callout{.kind = AnnotationKind::callout,
                             .anchors = {glm::vec3(0.0f)},
                             .text = "bladder",
                             .texts = {{"la", "vesica"}}};
    QCOMPARE(writtenIn(callout, "en+la"), std::string("bladder\nvesica"));
  }
  void headingsAreInTheFirst() {
    QCOMPARE(firstLanguage("de+la"), std::string("de"));
    QCOMPARE(firstLanguage("nb"), std::string("nb"));
    QCOMPARE(firstLanguage(""), std::string());
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::LabelWordsTest)
#include "label_words_test.moc"
