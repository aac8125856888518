// SPDX-License-Identifier: Apache-2.0
#include "render/export/svg/svg_document.h"

#include <QXmlStreamReader>
#include <QtTest>

#include "render/export/encoding/xml_text.h"
#include "render/export/svg/svg_path.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {

const char* const svgNamespace = "http://www.w3.org/2000/svg";
const char* const inkscape = "http://www.inkscape.org/namespaces/inkscape";

model::NodeId add(model::Scene& scene, const std::string& name, model::NodeId parent,
                  const model::MeshPtr& mesh = nullptr) {
  model::Node node;
  node.name = name;
  node.parent = parent;
  node.mesh = mesh;
  return scene.append(std::move(node));
}

model::MeshPtr triangle() {
  return std::make_shared<const model::Mesh>(
      std::move(model::Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}})).value());
}

render::VectorStructure structure(model::NodeId id, float depth) {
  render::Curve line;
  line.start = {1.0f, 2.0f};
  line.pieces.push_back({{2.0f, 3.0f}, {4.0f, 3.0f}, {5.0f, 2.0f}});
  render::VectorShape pen{.path = {line}, .colour = {0, 0, 0}, .opacity = 1.0f, .penWidth = 0.25f};
  render::VectorShape fill{.path = {line}, .colour = {255, 10, 0}, .opacity = 0.5f, .penWidth = 0};
  return {.id = id,
          .depth = depth,
          .fills = {fill},
          .fillOpacity = 0.75f,
          .lines = {{.kind = "Contours", .shapes = {pen}}}};
}

/// Returns the labels of all groups with ids, in the order of the document, each with its depth in
/// the tree.
QStringList labels(const std::string& svg, QString* fault = nullptr) {
  QXmlStreamReader reader(QByteArray::fromStdString(svg));
  QStringList found;
  int depth = 0;
  while (!reader.atEnd()) {
    const auto token = reader.readNext();
    if (token == QXmlStreamReader::StartElement) {
      if (reader.namespaceUri() != QString(svgNamespace) && fault)
        *fault = "a foreign element " + reader.name().toString();
      if (reader.name() == QString("g") && reader.attributes().hasAttribute("id"))
        found << QString::number(depth) + " " +
                     reader.attributes().value(inkscape, "label").toString();
      ++depth;
    } else if (token == QXmlStreamReader::EndElement) {
      --depth;
    }
  }
  if (reader.hasError() && fault)
    *fault = reader.errorString();
  return found;
}

}  // namespace

class SvgDocumentTest : public QObject {
  Q_OBJECT
 private slots:
  void groupsNestAsTheTreeDoes() {
    model::Scene scene;
    const auto vessels = add(scene, "Vessels", model::rootId);
    const auto aorta = add(scene, "aorta", vessels, triangle());
    const auto vein = add(scene, "vena cava", vessels, triangle());
    const auto liver = add(scene, "liver", model::rootId, triangle());
    add(scene, "nothing of it shows", model::rootId, triangle());
    const std::string svg = render::svgDocument(
        {.sizeMm = {160.0f, 90.0f},
         .background = Colour{255, 255, 255},
         .structures = {structure(vein, 0.9f), structure(liver, 0.6f), structure(aorta, 0.5f)}},
        scene);
    QString fault;
    const QStringList found = labels(svg, &fault);
    QCOMPARE(fault, QString());
    QCOMPARE(found, QStringList({"1 Fills", "2 vena cava", "2 liver", "2 aorta", "1 Lines",
                                 "2 Vessels", "3 vena cava", "3 aorta", "2 liver"}));
    const QByteArray text = QByteArray::fromStdString(svg);
    QVERIFY(text.contains("width=\"160mm\" height=\"90mm\" viewBox=\"0 0 160 90\""));
    QVERIFY(text.contains("stroke-width=\".25\""));
    QVERIFY(text.contains("<rect id=\"background\""));
    QVERIFY(text.contains("opacity=\".75\""));
  }

  void transparentHasNoBackground() {
    const std::string svg = render::svgDocument({}, {});
    QString fault;
    QCOMPARE(labels(svg, &fault), QStringList({"1 Lines"}));
    QCOMPARE(fault, QString());
    QVERIFY(svg.find("<rect") == std::string::npos);
  }

  void anyNameIsText_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QString>("read");
    const QString bad(QChar(0xFFFD));
    QTest::newRow("markup") << QByteArray("</g><script>alert(1)</script>&amp;")
                            << "</g><script>alert(1)</script>&amp;";
    QTest::newRow("quotes") << QByteArray("a\" onload=\"x' b") << "a\" onload=\"x' b";
    QTest::newRow("section end") << QByteArray("]]> <!-- --> <![CDATA[")
                                 << "]]> <!-- --> <![CDATA[";
    QTest::newRow("entity") << QByteArray("&#0; &lt;") << "&#0; &lt;";
    QTest::newRow("Unicode") << QByteArray("Über-Größe 肝臓 🫀 عظم")
                             << QString::fromUtf8("Über-Größe 肝臓 🫀 عظم");
    QTest::newRow("controls") << QByteArray("a\0b\nc\x7f", 6) << "a" + bad + "b" + bad + "c" + bad;
    QTest::newRow("no UTF-8") << QByteArray(
                                     "a\xff\xc0\xaf"
                                     "b")
                              << "a" + bad + bad + bad + "b";
    QTest::newRow("surrogate") << QByteArray("\xed\xa0\x80") << bad;
    QTest::newRow("no character") << QByteArray("\xef\xbf\xbf") << bad;
    QTest::newRow("cut short") << QByteArray("x\xe2\x82") << "x" + bad + bad;
    QTest::newRow("empty") << QByteArray() << QString();
  }
  void anyNameIsText() {
    QFETCH(QByteArray, name);
    QFETCH(QString, read);
    model::Scene scene;
    const auto id = add(scene, name.toStdString(), model::rootId, triangle());
    const std::string svg = render::svgDocument({.structures = {structure(id, 0.5f)}}, scene);
    QString fault;
    const QStringList found = labels(svg, &fault);
    QCOMPARE(fault, QString());
    QCOMPARE(found, QStringList({"1 Fills", "2 " + read, "1 Lines", "2 " + read}));
  }

  void numbersAreShort_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<QString>("text");
    QTest::newRow("whole") << 7.0 << "7";
    QTest::newRow("half") << 12.5 << "12.5";
    QTest::newRow("small") << -0.04 << "-.04";
    QTest::newRow("rounded") << 0.0449 << ".045";
    QTest::newRow("nothing") << -0.0001 << "0";
    QTest::newRow("large") << 4999.999 << "4999.999";
  }
  void numbersAreShort() {
    QFETCH(double, value);
    QFETCH(QString, text);
    std::string written;
    render::appendNumber(written, value, 3);
    QCOMPARE(QString::fromStdString(written), text);
  }

  // Relative steps are rounded from where the pen is, so that errors do not add up.
  void pathsDoNotDrift() {
    render::Curve curve;
    curve.start = {0.0f, 0.0f};
    for (int i = 1; i <= 300; ++i) {
      const glm::vec2 end(0.0333f * float(i), 0.0177f * float(i * i % 7));
      curve.pieces.push_back({end, end, end});
    }
    QString path = QString::fromStdString(render::svgPath({curve}, 2));
    path.remove(0, path.indexOf('l') + 1);
    double x = 0.0;
    double y = 0.0;
    static const QRegularExpression number("-?[0-9]*\\.?[0-9]+");
    auto it = number.globalMatch(path);
    while (it.hasNext()) {
      x += it.next().captured().toDouble();
      y += it.next().captured().toDouble();
    }
    QVERIFY2(std::abs(x - 9.99) < 0.006, qPrintable(QString::number(x) + path.left(300)));
    QVERIFY(std::abs(y - double(curve.pieces.back().end.y)) < 0.006);
  }
};

SLINE_TEST(SvgDocumentTest)
#include "svg_document_test.moc"
