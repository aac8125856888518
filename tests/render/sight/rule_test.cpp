// SPDX-License-Identifier: Apache-2.0
// Tests that a rule comes to the same in a shader as in C++: on a grid of 256 × 256 inputs, with
// the driver's own compiler.
#include <QFile>
#include <QTest>
#include <array>
#include <cmath>
#include <functional>

#include "render/gpu/device.h"
#include "render/gpu/headless/context.h"
#include "render/sight/rules.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

using Values = std::function<glm::vec4(float, float)>;
Q_DECLARE_METATYPE(Values)

namespace {

constexpr int side = 256;

constexpr const char* vertexText =
    "layout(location = 0) in vec2 place;\n"
    "void main() {\n"
    "  gl_Position = vec4(place + 2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1), 0.0, 1.0);\n"
    "}\n";

std::string contents(const char* name) {
  QFile file(QStringLiteral(SLINE_RULES "/") + QLatin1String(name));
  return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string();
}

/// How far what was drawn is from what C++ has.
struct Apart {
  int count = 0;       ///< values that differ by more than that
  float most = 0.0f;   ///< and by how much
  float range = 0.0f;  ///< the largest that was drawn
};
Apart apartOf(const std::vector<std::uint16_t>& drawn, const Values& values, float within) {
  Apart apart;
  for (int i = 0; i < side * side; ++i) {
    const glm::vec4 own = values(float(i % side) / 255.0f, float(i / side) / 255.0f);
    for (int c = 0; c < 4; ++c) {
      const float found = float(drawn[std::size_t(4 * i + c)]) / 65535.0f;
      const float off = std::abs(found - std::clamp(own[c], 0.0f, 1.0f));
      apart.most = std::max(apart.most, off);
      apart.count += off > within ? 1 : 0;
      apart.range = std::max(apart.range, found);
    }
  }
  return apart;
}

/// What a perspective between 100 and 1000 mm has, and a parallel projection of the same.
const glm::vec4 perspective{-1100.0f / 900.0f, -200000.0f / 900.0f, -1.0f, 0.0f};
const glm::vec4 parallel{-2.0f / 900.0f, -1100.0f / 900.0f, 0.0f, 1.0f};

}  // namespace

class RuleTest : public QObject {
  Q_OBJECT

  std::unique_ptr<gpu::HeadlessContext> m_context;
  std::unique_ptr<gpu::Device> m_device;

 private slots:
  void initTestCase();
  void shadersAgree_data();
  void shadersAgree();
  void entersAsPublished();
  void liftsStayBeforeTheEye();
};

void RuleTest::initTestCase() {
  auto context = gpu::HeadlessContext::create();
  if (!context)
    SLINE_ABSENT(context.error().text().c_str());
  m_context = std::move(*context);
  auto device = gpu::Device::create();
  QVERIFY2(device.ok(), device.ok() ? "" : device.error().text().c_str());
  m_device = std::move(*device);
}

void RuleTest::shadersAgree_data() {
  QTest::addColumn<QString>("shader");
  QTest::addColumn<Values>("values");
  QTest::newRow("light") << "vec4(headlight(x), keyLight(x, 2.0 * y - 1.0), 5.0 * highlight(y), "
                            "arcCosine(x) / 2.0)"
                         << Values([](float x, float y) {
                              return glm::vec4(
                                  rule::headlight(x), rule::keyLight(x, 2.0f * y - 1.0f),
                                  5.0f * rule::highlight(y), rule::arcCosine(x) / 2.0f);
                            });
  QTest::newRow("colours")
      << "vec4(inShadow(vec3(x, y, 0.3)), shaded(0.1, x, y, 0.0))" << Values([](float x, float y) {
           return glm::vec4(rule::inShadow({x, y, 0.3f}), rule::shaded(0.1f, x, y, 0.0f));
         });
  for (const float onDark : {0.0f, 1.0f})
    QTest::addRow("entering, %s", onDark > 0.0f ? "on a dark ground" : "on paper")
        << QString(
               "vec4(enteredAt(enteringAngle(x, %1), y, 0.0, 0.0), "
               "enteredAt(enteringAngle(x, %1), y, 0.4, 0.0), "
               "enteredAt(enteringAngle(x, %1), 0.5, 1.0, y), glazed(x, y, 0.3))")
               .arg(double(onDark), 0, 'f', 1)
        << Values([onDark](float x, float y) {
             const float angle = rule::enteringAngle(x, onDark);
             return glm::vec4(rule::enteredAt(angle, y, 0.0f, 0.0f),
                              rule::enteredAt(angle, y, 0.4f, 0.0f),
                              rule::enteredAt(angle, 0.5f, 1.0f, y), rule::glazed(x, y, 0.3f));
           });
  QTest::newRow("layers and stages")
      << "vec4(layered(x, y, 0.25), stagePlace(5.0 * x) / 32.0, 0.0, 1.0)"
      << Values([](float x, float y) {
           return glm::vec4(rule::layered(x, y, 0.25f), rule::stagePlace(5.0f * x) / 32.0f, 0.0f,
                            1.0f);
         });
  QTest::newRow("pens") << "vec4(penCoverage(4.0 * x, 4.0 * y, 1.0), penHalfWidth(x) / 2.0, "
                           "penOpacity(x), penOutside(2.0 * y) / 2.0)"
                        << Values([](float x, float y) {
                             return glm::vec4(rule::penCoverage(4.0f * x, 4.0f * y, 1.0f),
                                              rule::penHalfWidth(x) / 2.0f, rule::penOpacity(x),
                                              rule::penOutside(2.0f * y) / 2.0f);
                           });
  QTest::newRow("stripes")
      << "vec4(stripeCoverage(7.0 * x, 0.2, 2.0 * y, 0.5), stripeCoverage(7.0 * x, y, 0.7, 1.0), "
         "stripeCoverage(-7.0 * x, 0.3, 1.0, y), 1.0)"
      << Values([](float x, float y) {
           return glm::vec4(rule::stripeCoverage(7.0f * x, 0.2f, 2.0f * y, 0.5f),
                            rule::stripeCoverage(7.0f * x, y, 0.7f, 1.0f),
                            rule::stripeCoverage(-7.0f * x, 0.3f, 1.0f, y), 1.0f);
         });
  QTest::newRow("cuts")
      << "vec4(takesAway(vec4(0.6, 0.8, 0.0, -0.7), vec3(x, y, 5.0)) ? 1.0 : 0.0, "
         "faceDepth(vec3(0.004, -0.002, 0.4), vec2(300.0 * x, 300.0 * y)), "
         "stripeIsOdd(9.0 * x - 4.0), stripeAway(5.0 * x, 0.1 + y) / 5.0)"
      << Values([](float x, float y) {
           return glm::vec4(rule::takesAway({0.6f, 0.8f, 0.0f, -0.7f}, {x, y, 5.0f}) ? 1.0f : 0.0f,
                            rule::faceDepth({0.004f, -0.002f, 0.4f}, {300.0f * x, 300.0f * y}),
                            rule::stripeIsOdd(9.0f * x - 4.0f),
                            rule::stripeAway(5.0f * x, 0.1f + y) / 5.0f);
         });
  QTest::newRow("layers") << "vec4(laidBehind(x, y, 0.5), hiddenCoverage(x), "
                             "liesBefore(x, 1.0, y, 2.0) ? 1.0 : 0.0, "
                             "liesBefore(x, 2.0, x, floor(2.9 * y + 0.06)) ? 1.0 : 0.0)"
                          << Values([](float x, float y) {
                               const auto number = [](bool is) { return is ? 1.0f : 0.0f; };
                               return glm::vec4(rule::laidBehind(x, y, 0.5f),
                                                rule::hiddenCoverage(x),
                                                number(rule::liesBefore(x, 1.0f, y, 2.0f)),
                                                number(rule::liesBefore(
                                                    x, 2.0f, x, std::floor(2.9f * y + 0.06f))));
                             });
  QTest::newRow("sight") << "vec4(float(afterLook(1, x, y, 0.3, vec2(0.01, 0.2)) + 1) / 5.0, "
                            "float(afterLook(3, x, y, 0.3, vec2(0.1, 0.2)) + 1) / 5.0, "
                            "lookOutside(int(4.0 * x), vec2(0.2, 0.8)), "
                            "probeOutside(int(4.0 * x), 0.1, vec2(0.2, 0.8)))"
                         << Values([](float x, float y) {
                              const auto look = [](int after) { return float(after + 1) / 5.0f; };
                              const auto k = int(4.0f * x);
                              return glm::vec4(look(rule::afterLook(1, x, y, 0.3f, {0.01f, 0.2f})),
                                               look(rule::afterLook(3, x, y, 0.3f, {0.1f, 0.2f})),
                                               rule::lookOutside(k, {0.2f, 0.8f}),
                                               rule::probeOutside(k, 0.1f, {0.2f, 0.8f}));
                            });
  QTest::newRow("paper") << "vec4(inkTaken(vec2(255.0 * x, 255.0 * y), vec2(1.0, 3.0)), "
                            "inkTaken(vec2(255.0 * x, 255.0 * y), vec2(0.4, 1.5)), 0.0, 1.0)"
                         << Values([](float x, float y) {
                              return glm::vec4(
                                  rule::inkTaken({255.0f * x, 255.0f * y}, {1.0f, 3.0f}),
                                  rule::inkTaken({255.0f * x, 255.0f * y}, {0.4f, 1.5f}), 0.0f,
                                  1.0f);
                            });
  const auto depths = [](const char* name, const glm::vec4& projection) {
    QTest::newRow(name) << QString(
                               "vec4(eyeDistance(x, p) / 1000.0, depthLift(x, 300.0 * y, p), "
                               "liftedDistance(1000.0 * x, 300.0 * y, p.z) / 1000.0, 1.0)")
                               .replace(", p)", QString(", vec4(%1, %2, %3, %4))")
                                                    .arg(double(projection.x), 0, 'f', 9)
                                                    .arg(double(projection.y), 0, 'f', 9)
                                                    .arg(double(projection.z), 0, 'f', 9)
                                                    .arg(double(projection.w), 0, 'f', 9))
                               .replace("p.z", QString("(%1)").arg(double(projection.z), 0, 'f', 1))
                        << Values([projection](float x, float y) {
                             return glm::vec4(
                                 rule::eyeDistance(x, projection) / 1000.0f,
                                 rule::depthLift(x, 300.0f * y, projection),
                                 rule::liftedDistance(1000.0f * x, 300.0f * y, projection.z) /
                                     1000.0f,
                                 1.0f);
                           });
  };
  depths("depths in perspective", perspective);
  depths("depths in parallel projection", parallel);
}

void RuleTest::shadersAgree() {
  QFETCH(QString, shader);
  QFETCH(Values, values);
  const std::array<const char*, 7> rules{"cuts.glsl", "depth.glsl", "grain.glsl", "layers.glsl",
                                         "pen.glsl",  "shade.glsl", "sight.glsl"};
  std::array<std::string, rules.size()> texts;
  std::vector<gpu::ShaderFile> files;
  std::string includes;
  for (std::size_t i = 0; i < rules.size(); ++i) {
    texts[i] = contents(rules[i]);
    QVERIFY2(!texts[i].empty(), rules[i]);
    files.push_back({rules[i], texts[i]});
    includes += std::string("#include \"") + rules[i] + "\"\n";
  }
  const std::string fragment =
      includes +
      "out vec4 f;\nvoid main() {\n"
      "  float x = (gl_FragCoord.x - 0.5) / 255.0;\n  float y = (gl_FragCoord.y - 0.5) / 255.0;\n"
      "  f = " +
      shader.toStdString() + ";\n}\n";
  files.push_back({"grid.vert", vertexText});
  files.push_back({"grid.frag", fragment});
  const auto program = gpu::Program::create(
      files, m_device->dialect(),
      {.name = "grid", .vertexFile = "grid.vert", .fragmentFile = "grid.frag", .uniforms = {}});
  QVERIFY2(program.ok(), program.ok() ? "" : program.error().text().c_str());
  const gpu::Texture colours(gpu::TextureFormat::rgba16, {side, side}, "colours");
  const auto target = gpu::Target::create({{&colours}, nullptr}, "grid");
  QVERIFY(target.ok());
  gpu::Buffer places(gpu::BufferKind::vertices, "places");
  const std::array<float, 2> corner{-1.0f, -1.0f};
  places.fill(std::as_bytes(std::span(corner)));
  const gpu::Geometry geometry({{.buffer = &places,
                                 .stride = 8,
                                 .attributes = {{0, 2, gpu::AttributeType::float32, 0}},
                                 .perInstance = true}},
                               nullptr, "grid");
  gpu::DrawState state;
  state.viewport = {0, 0, side, side};
  m_device->quads({**target, **program, geometry, state}, 1);
  std::vector<std::uint16_t> drawn(std::size_t(side) * side * 4);
  QVERIFY(m_device->read(**target, {0, 0, side, side}, drawn).ok());

  // The hash of the paper's grain takes its numbers apart: where a fraction begins anew the last
  // bit decides, of a few points.
  const bool hashed = QLatin1String(QTest::currentDataTag()) == QLatin1String("paper");
  const Apart apart = apartOf(drawn, values, hashed ? 0.02f : 2e-4f);
  QVERIFY(apart.range > 0.5f);
  QVERIFY2(apart.count <= (hashed ? 4 * side * side / 200 : 0),
           qPrintable(QString("%1 values, by up to %2").arg(apart.count).arg(double(apart.most))));
}

/// S eq. 11: nothing enters before the threshold, all has where T_P and what follows are 1.
void RuleTest::entersAsPublished() {
  QCOMPARE(rule::enteredAt(rule::enteringAngle(0.0f, 0.0f), 1.0f, 0.0f, 0.0f), 0.0f);
  QCOMPARE(rule::enteredAt(rule::enteringAngle(1.0f, 0.0f), 1.0f, 0.5f, 0.0f), 0.0f);
  QVERIFY(rule::enteredAt(rule::enteringAngle(0.0f, 0.0f), 1.0f, 0.5f, 0.0f) > 0.999f);
  // On a dark ground light enters where paper has none.
  QVERIFY(rule::enteredAt(rule::enteringAngle(1.0f, 1.0f), 1.0f, 0.5f, 0.0f) > 0.999f);
  QCOMPARE(rule::enteredAt(rule::enteringAngle(0.0f, 1.0f), 1.0f, 0.5f, 0.0f), 0.0f);
  for (const float facing : {0.0f, 0.4f, 1.0f})
    QCOMPARE(rule::enteredAt(rule::enteringAngle(facing, 0.0f), 0.0f, 1.0f, 1.0f), 1.0f);
  for (float x = 0.0f; x <= 1.0f; x += 1e-3f)
    QVERIFY(std::abs(rule::arcCosine(x) - std::acos(x)) < 7e-5f);
}

/// A line that would come to lie behind the eye, lifted by more than its distance, stays before it.
void RuleTest::liftsStayBeforeTheEye() {
  const float depth = 0.02f;  // 102 mm from the eye
  const float away = rule::eyeDistance(depth, perspective);
  QVERIFY(std::abs(away - 101.83f) < 0.1f);
  QVERIFY(rule::liftedDistance(away, 500.0f, perspective.z) > 0.0f);
  QCOMPARE(rule::liftedDistance(away, 500.0f, parallel.z), away - 500.0f);
  QVERIFY(rule::depthLift(depth, 500.0f, perspective) > rule::depthLift(depth, 50.0f, perspective));
  QVERIFY(rule::depthLift(depth, 50.0f, perspective) > 0.0f);
}

SLINE_TEST(RuleTest)
#include "rule_test.moc"
