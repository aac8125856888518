// SPDX-License-Identifier: Apache-2.0
// Tests that what is said of a picture is what one sees in it: each sentence of twenty descriptions
// is taken apart and compared with a picture that tells which structure each pixel shows.
#include <QDir>
#include <QRegularExpression>
#include <QTest>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>

#include "model/demo/demo.h"
#include "model/lengths/shortest_distance.h"
#include "model/scene/visible_structures.h"
#include "render/export/description/alt_text.h"
#include "render/export/plate/legend.h"
#include "render/labels/seen/screen.h"
#include "tests/render/export/description/id_buffer.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

namespace sline::test {

using namespace render;

namespace {

constexpr int bufferHeight = 540;
/// Who looks at a picture sees a structure of so many pixels for certain.
constexpr int certainPixels = 60;

/// Returns the name as the scene has it, which is English in the demos.
QString nameOf(const model::Node& node) {
  return QString::fromStdString(node.name).simplified();
}

/// Returns the scene with opaque structures, of which the first, third, fifth … have a label.
model::Scene opaque(model::Scene scene, std::size_t labels) {
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes)
    if (!node.isGroup()) {
      node.style.fill = model::Fill::paper;
      node.style.opacity = Opacity::clamped(1.0f);
      node.style.gamma = Gamma::clamped(2.0f);
    }
  scene.setNodes(nodes);
  scene.setAnnotations({});
  std::size_t count = 0;
  for (const model::VisibleStructure& structure : model::visibleStructures(scene))
    if (++count % 2 == 1 && count < 2 * labels) {
      model::Annotation label;
      label.anchors = {model::SurfacePoint{.structure = structure.node->id, .triangle = 0}};
      label.text = nameOf(*structure.node).toStdString();
      label.found = true;
      scene.appendAnnotation(label);
    }
  return scene;
}

ExportOrder orderOf(const model::Scene& scene) {
  ExportOrder order;
  order.scene = scene;
  order.labels.mode = LabelMode::on;
  return order;
}

/// A camera at that angle about the body's axis and above its middle, fitted to all.
model::Camera around(const model::Scene& scene, float degrees, float above) {
  const float turn = glm::radians(degrees);
  const float rise = glm::radians(above);
  const glm::vec3 middle = scene.visibleBounds().centre();
  const model::Camera camera{
      .eye = middle + 900.0f * glm::vec3(std::sin(turn) * std::cos(rise),
                                         -std::cos(turn) * std::cos(rise), std::sin(rise)),
      .target = middle};
  return model::fittedToVisible(scene, camera, 160.0f / 90.0f);
}

/// Compares the sentences of one description with the picture.
class Judge {
 public:
  explicit Judge(const ExportOrder& order)
      : m_order(order),
        m_screen(order.camera, order.page.sizeMm),
        m_buffer(order.scene, m_screen, bufferHeight) {
    for (const model::VisibleStructure& structure : model::visibleStructures(order.scene))
      m_ids[nameOf(*structure.node)].push_back(structure.node->id);
  }

  /// Returns what is wrong with the text; empty: nothing.
  QStringList faults(const QString& text) {
    m_faults.clear();
    QString left = text;
    while (!left.isEmpty()) {
      const qsizetype cut = left.indexOf(QRegularExpression("\\. (?=[A-Z])"));
      const QString sentence = cut < 0 ? left.chopped(1) : left.left(cut);
      left = cut < 0 ? QString() : left.mid(cut + 2);
      if (!first(sentence) && !edge(sentence) && !zone(sentence) && !before(sentence) &&
          !others(sentence))
        m_faults << "not understood: " + sentence;
    }
    missing();
    return m_faults;
  }

 private:
  void expect(bool right, const QString& what) {
    if (!right)
      m_faults << what;
  }

  static QStringList items(const QString& list) {
    return list.split(QRegularExpression(", | and (?=[^,]*$)"));
  }

  int pixels(const QString& name) const {
    int most = 0;
    for (const model::NodeId id : m_ids.value(name))
      most = std::max(most, m_buffer.pixels(id));
    return most;
  }
  bool shown(const QString& name) {
    expect(m_ids.contains(name), "no structure is called " + name);
    expect(pixels(name) > 0, "one does not see " + name);
    m_said.insert(name);
    return m_ids.contains(name) && pixels(name) > 0;
  }

  bool first(const QString& sentence) {
    static const QRegularExpression form(
        "^Drawing of (one|\\d+) structures?, seen (.*?)(; labelled: (\\d+))?$");
    const auto match = form.match(sentence);
    if (!match.hasMatch())
      return false;
    int certain = 0;
    int any = 0;
    for (const QString& name : m_ids.keys())
      for (const model::NodeId id : m_ids.value(name)) {
        certain += m_buffer.pixels(id) >= certainPixels ? 1 : 0;
        any += m_buffer.pixels(id) > 0 ? 1 : 0;
      }
    const int told = match.captured(1) == "one" ? 1 : match.captured(1).toInt();
    expect(told >= certain && told <= any,
           QString("%1 structures, not %2 to %3").arg(told).arg(certain).arg(any));
    const glm::vec3 from = glm::normalize(m_order.camera.eye - m_order.camera.target);
    const QMap<QString, float> shares{{"from the front", -from.y},
                                      {"from behind", from.y},
                                      {"from the patient's left", from.x},
                                      {"from the patient's right", -from.x},
                                      {"from above", from.z},
                                      {"from below", -from.z}};
    const QStringList sides = match.captured(2).split(QRegularExpression(", | and "));
    for (auto side = shares.begin(); side != shares.end(); ++side)
      expect(sides.contains(side.key()) == (side.value() >= 0.35f), "it is seen " + side.key());
    return true;
  }

  /// Whether that side of the body is on the left or at the top, as points that far apart have it.
  bool edge(const QString& sentence) {
    static const QRegularExpression form("^(.*) is (on the left|at the top) of the picture$");
    const auto match = form.match(sentence);
    if (!match.hasMatch())
      return false;
    const QMap<QString, glm::vec3> ways{
        {"The front of the body", {0, -1, 0}},    {"The back of the body", {0, 1, 0}},
        {"The patient's left", {1, 0, 0}},        {"The patient's right", {-1, 0, 0}},
        {"The upper end of the body", {0, 0, 1}}, {"The lower end of the body", {0, 0, -1}}};
    const glm::vec3 way = ways.value(match.captured(1));
    const glm::vec2 there = *m_screen.place(m_order.camera.target + 5.0f * way);
    const glm::vec2 here = *m_screen.place(m_order.camera.target - 5.0f * way);
    const glm::vec2 step = glm::normalize(there - here);
    expect(match.captured(2) == "on the left" ? step.x < -0.7f : step.y < -0.7f, sentence);
    return true;
  }

  bool zone(const QString& sentence) {
    static const QRegularExpression form(
        "^(On the left of the picture|In the middle|On the right of the picture|Labelled): (.*)$");
    const auto match = form.match(sentence);
    if (!match.hasMatch())
      return false;
    for (const QString& name : items(match.captured(2))) {
      if (!shown(name) || m_ids.value(name).size() > 1)
        continue;
      const float across = m_buffer.across(m_ids.value(name).front());
      const QString where = match.captured(1);
      constexpr float slack = 0.02f;
      const bool right = where.startsWith("On the left") ? across < 0.42f + slack
                         : where.startsWith("On the right")
                             ? across > 0.58f - slack
                             : std::abs(across - 0.5f) < 0.08f + slack;
      expect(right, QString("%1 is at %2, not %3").arg(name).arg(double(across)).arg(where));
    }
    return true;
  }

  bool before(const QString& sentence) {
    static const QRegularExpression form("^In the picture (.*) lies in front of (.*)$");
    const auto match = form.match(sentence);
    if (!match.hasMatch())
      return false;
    const QString front = match.captured(1);
    for (const QString& behind : items(match.captured(2))) {
      if (!shown(front) || !shown(behind))
        continue;
      const model::NodeId a = m_ids.value(front).front();
      const model::NodeId b = m_ids.value(behind).front();
      const int over = m_buffer.before(a, b);
      const int under = m_buffer.before(b, a);
      expect(over > 0 && over > 3 * under,
             QString("%1 before %2: %3 pixels, %4 behind").arg(front, behind).arg(over).arg(under));
    }
    return true;
  }

  bool others(const QString& sentence) {
    static const QRegularExpression form("^(Also shown|Shown): (.*)$");
    static const QRegularExpression more("^\\d+ more$");
    const auto match = form.match(sentence);
    if (!match.hasMatch())
      return false;
    for (const QString& name : items(match.captured(2)))
      if (!more.match(name).hasMatch())
        shown(name);
    return true;
  }

  void missing() {
    for (const model::Annotation& label : m_order.scene.annotations()) {
      const QString name = QString::fromStdString(label.text);
      expect(m_said.contains(name) || pixels(name) < certainPixels, name + " is not named");
    }
  }

  const ExportOrder& m_order;
  Screen m_screen;
  IdBuffer m_buffer;
  QMap<QString, QList<model::NodeId>> m_ids;
  QSet<QString> m_said;
  QStringList m_faults;
};

}  // namespace

class AltTextTest : public QObject {
  Q_OBJECT

  std::map<QString, model::Scene> m_scenes;

  const model::Scene& scene(const QString& name) {
    auto found = m_scenes.find(name);
    if (found == m_scenes.end()) {
      const auto demo = *model::demoNamed(name.section('-', 0, 0).toStdString());
      const auto sex = name.endsWith("-m") ? model::Sex::male : model::Sex::female;
      found =
          m_scenes.emplace(name, opaque(model::demo(demo, sex, QDir::tempPath().toStdString()), 14))
              .first;
    }
    return found->second;
  }

  /// Two balls, the nearer before a part of the other, and a third at the patient's left.
  static model::Scene balls() {
    model::Scene scene;
    const auto add = [&scene](const char* name, float radius, const glm::vec3& at) {
      model::Node node{.name = name, .mesh = moved(*sphere(1.0f, 4), radius, at)};
      node.style.fill = model::Fill::paper;
      node.provenance.frame = "LPS";
      const model::NodeId id = scene.append(node);
      model::Annotation label;
      label.anchors = {model::SurfacePoint{.structure = id, .triangle = 0}};
      label.text = name;
      scene.appendAnnotation(label);
    };
    add("near one", 20.0f, {-20, -60, 0});
    add("far one", 30.0f, {0, 40, 0});
    add("left one", 15.0f, {90, 0, 0});
    return scene;
  }

  static ExportOrder ballsOrder() {
    ExportOrder order = orderOf(balls());
    order.camera = around(order.scene, 0.0f, 0.0f);
    return order;
  }

 private slots:
  void isWhatOneSees_data() {
    QTest::addColumn<QString>("demo");
    QTest::addColumn<float>("turn");
    QTest::addColumn<float>("above");
    const auto add = [](const char* demo, float turn, float above) {
      QTest::addRow("%s at %d, %d", demo, int(turn), int(above)) << demo << turn << above;
    };
    for (const char* demo : {"pelvis-f", "pelvis-m", "abdomen-m"})
      for (const auto& [turn, above] :
           {std::pair(0.0f, 0.0f), std::pair(180.0f, 0.0f), std::pair(90.0f, 0.0f),
            std::pair(-90.0f, 0.0f), std::pair(40.0f, 25.0f)})
        add(demo, turn, above);
    for (const auto& [turn, above] :
         {std::pair(0.0f, 0.0f), std::pair(180.0f, 0.0f), std::pair(0.0f, 85.0f),
          std::pair(-30.0f, -40.0f), std::pair(90.0f, 0.0f)})
      add("kidney-f", turn, above);
  }
  void isWhatOneSees() {
    QFETCH(QString, demo);
    QFETCH(float, turn);
    QFETCH(float, above);
    ExportOrder order = orderOf(scene(demo));
    order.camera = around(order.scene, turn, above);
    const QString text = QString::fromStdString(describedPicture(order));
    const QStringList faults = Judge(order).faults(text);
    QVERIFY2(faults.empty(), qPrintable(faults.join("\n") + "\n" + text));
    for (const char* language : {"en", "de", "nl", "nb", "la"}) {
      order.labels.language = language;
      const QString said = QString::fromStdString(describedPicture(order));
      QVERIFY2(said.split(' ').size() <= int(usualWords), qPrintable(said));
    }
  }

  /// The judge finds fault where there is some.
  void theJudgeJudges() {
    const ExportOrder order = ballsOrder();
    const QString text = QString::fromStdString(describedPicture(order));
    QCOMPARE(Judge(order).faults(text), QStringList());
    const auto wrong = [&](const QString& is, const QString& said) {
      QVERIFY2(text.contains(is), qPrintable(text));
      QVERIFY2(!Judge(order).faults(QString(text).replace(is, said)).empty(), qPrintable(said));
    };
    wrong("near one lies in front of far one", "far one lies in front of near one");
    wrong("The patient's right is on the left", "The patient's left is on the left");
    wrong("from the front", "from behind");
    wrong("On the right of the picture: left one", "On the left of the picture: left one");
    wrong("Drawing of 3", "Drawing of 4");
    wrong("In the middle: far one", "In the middle: nothing");
  }

  void saysItInFiveLanguages() {
    ExportOrder order = ballsOrder();
    const std::map<std::string, QString> begins{
        {"",
         "Drawing of 3 structures, seen from the front; labelled: 3. The patient's right is on "
         "the left of the picture."},
        {"de+la",
         "Zeichnung von 3 Strukturen, gesehen von vorn; beschriftet: 3. Die rechte "
         "Körperseite ist links im Bild."},
        {"nl",
         "Tekening van 3 structuren, gezien van voren; benoemd: 3. De rechterzijde van het "
         "lichaam is links in beeld."},
        {"nb-NO",
         "Tegning av 3 strukturer, sett forfra; med navn: 3. Kroppens høyre side er til "
         "venstre i bildet."},
        {"la",
         "Delineatio structurarum 3, conspectus a fronte; inscriptae: 3. Latus dextrum "
         "corporis in imagine a sinistra est."},
        {"fr", "Drawing of 3 structures, seen from the front; labelled: 3."}};
    for (const auto& [language, begin] : begins) {
      order.labels.language = language;
      const QString text = QString::fromStdString(altTextOf(order).text);
      QVERIFY2(text.startsWith(begin), qPrintable(text));
      QVERIFY(text.contains("near one") && text.contains("left one"));
    }
    order.labels.language = "fr";
    QCOMPARE(altTextOf(order).language, std::string("en"));
  }

  /// A side that nobody is sure of is not told as a fact.
  void doubtIsSaid() {
    ExportOrder order = ballsOrder();
    const auto doubted = [&order](model::Evidence sides, model::Evidence front) {
      std::vector<model::Node> nodes = order.scene.nodes();
      for (model::Node& node : nodes)
        node.provenance.evidence = {sides, front};
      order.scene.setNodes(std::move(nodes));
      return QString::fromStdString(altTextOf(order).text)
          .contains("Which side of the body is which is not certain.");
    };
    using enum model::Evidence;
    QVERIFY(!doubted(voted, voted));
    QVERIFY(doubted(assumed, assumed));
    QVERIFY(doubted(conflict, known));
    // Each side that is in doubt has the mark, and no other.
    QVERIFY(doubted(known, assumed));
    QVERIFY(QString::fromStdString(altTextOf(order).text).contains("seen from the front (?)"));
    QVERIFY(doubted(assumed, known));
    const QString text = QString::fromStdString(altTextOf(order).text);
    QVERIFY(text.contains("front; labelled") && text.contains("right (?) is on"));
    // From above neither left nor right would be told but at the edge.
    QVERIFY(doubted(known, assumed));
  }

  /// Where a picture gives no names away, its description gives none away either.
  void testsAreNotAnswered() {
    ExportOrder order = ballsOrder();
    order.words.description = {"the near one", {}};
    for (const LabelMode mode : {LabelMode::off, LabelMode::numbers, LabelMode::blank}) {
      order.labels.mode = mode;
      const QString text = QString::fromStdString(altTextOf(order).text);
      QCOMPARE(text, QString("Drawing of 3 structures, seen from the front. The patient's right is "
                             "on the left of the picture."));
    }
    order.altText = "all about the near one";
    QVERIFY(altTextOf(order).text.find("near one") == std::string::npos);
    order.labels.mode = LabelMode::off;  // a person has said so of this very file
    QCOMPARE(altTextOf(order).text, order.altText);
    order.altText = "off";
    QCOMPARE(altTextOf(order).text, std::string());
  }

  void personsWordsComeFirst() {
    ExportOrder order = ballsOrder();
    order.words.description = {"Three  balls", {{"de", "Drei Kugeln"}}};
    QCOMPARE(altTextOf(order), (AltText{"Three balls", ""}));
    order.labels.language = "de";
    QCOMPARE(altTextOf(order), (AltText{"Drei Kugeln", "de"}));
    order.altText = "Nur\ndies";
    QCOMPARE(altTextOf(order), (AltText{"Nur dies", "de"}));
  }

  /// Where nobody knows which side is which, none is told.
  void unknownSidesAreNotTold() {
    ExportOrder order = ballsOrder();
    std::vector<model::Node> nodes = order.scene.nodes();
    for (model::Node& node : nodes)
      node.provenance.frame = "file";
    order.scene.setNodes(nodes);
    const QString text = QString::fromStdString(altTextOf(order).text);
    QVERIFY2(text.startsWith("Drawing of 3 structures; labelled: 3. On the left"),
             qPrintable(text));
    QVERIFY(!text.contains("patient") && !text.contains("front;"));
  }

  void namesAreTextOfOneLine() {
    ExportOrder order = ballsOrder();
    std::vector<model::Annotation> labels = order.scene.annotations();
    labels[0].text = "a\nb\x01 %1 %2 \u202e<b>&\"";
    labels[1].text = std::string(5000, 'x');
    order.scene.setAnnotations(labels);
    const QString text = QString::fromStdString(altTextOf(order).text);
    QVERIFY2(text.contains("a b %1 %2 <b>&\""), qPrintable(text));
    QVERIFY(text.size() < 1000);
    for (const QChar letter : text)
      QVERIFY(letter.isPrint());
  }

  /// A distance says what it leads from and to, and its length; so does a key.
  void distancesAreTold() {
    ExportOrder order = ballsOrder();
    const auto& nodes = order.scene.nodes();
    model::Annotation distance{.kind = model::AnnotationKind::distance};
    distance.anchors = {model::SurfacePoint{.structure = nodes[0].id},
                        model::SurfacePoint{.structure = nodes[1].id}};
    const model::AnnotationId id = order.scene.appendAnnotation(distance);
    const std::string ends = distanceEnds(order.scene, order.scene.annotations().back(), "");
    QCOMPARE(ends, nodes[0].name + " – " + nodes[1].name);
    const auto length = drawnLength(order.scene, order.scene.annotations().back());
    QVERIFY(length);
    const QString text = QString::fromStdString(altTextOf(order).text);
    QVERIFY2(text.contains(QString::fromStdString(ends + ": ")) && text.contains(" mm."),
             qPrintable(text));
    ShownLabel label{.item = {.id = id, .kind = model::AnnotationKind::distance}, .length = length};
    QVERIFY(keyLine(order.scene, label, {}).starts_with(ends + ": "));
    label.text = "margin";
    QVERIFY(keyLine(order.scene, label, {}).starts_with("margin "));
    // Where names would give answers away, none is said.
    order.labels.mode = LabelMode::numbers;
    QVERIFY(altTextOf(order).text.find(ends) == std::string::npos);
  }

  void saysThatThereIsNothing() {
    ExportOrder order;
    order.labels.mode = LabelMode::on;
    QCOMPARE(altTextOf(order).text, std::string("Nothing is visible in the picture."));
  }

  /// More labels than words: the largest are named, the others counted.
  void countsWhatHasNoRoom() {
    ExportOrder order = orderOf({});
    for (int i = 0; i < 100; ++i) {
      model::Node node{.name = "a rather long name number " + std::to_string(i)};
      node.mesh = moved(*sphere(1.0f, 2), 4.0f, {float(i % 10) * 12.0f, 0, float(i / 10) * 12.0f});
      node.provenance.frame = "LPS";
      model::Annotation label;
      label.text = node.name;
      label.anchors = {model::SurfacePoint{.structure = order.scene.append(node), .triangle = 0}};
      order.scene.appendAnnotation(label);
    }
    order.camera = around(order.scene, 0.0f, 0.0f);
    const QString text = QString::fromStdString(describedPicture(order));
    QVERIFY(text.split(' ').size() <= int(usualWords));
    const int named = int(text.count("a rather long name"));
    QVERIFY2(named >= 10, qPrintable(text));
    QVERIFY2(text.contains(QString("%1 more").arg(100 - named)), qPrintable(text));
  }
};

}  // namespace sline::test

SLINE_TEST(sline::test::AltTextTest)
#include "alt_text_test.moc"
