// SPDX-License-Identifier: Apache-2.0
#include <QRect>
#include <QtTest>
#include <algorithm>
#include <array>

#include "render/gpu/device.h"
#include "render/gpu/headless/context.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render::gpu;

namespace {

constexpr auto files = std::to_array<ShaderFile>({
    {"square.vert",
     "layout(location = 0) in vec2 place;\n"
     "uniform float depth;\n"
     "void main() {\n"
     "  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
     "  gl_Position = vec4(place + corner, depth, 1.0);\n"
     "}\n"},
    {"square.frag", "uniform vec4 colour;\nout vec4 f;\nvoid main() { f = colour; }\n"},
    {"broken.frag", "out vec4 f;\nvoid main() { f = nonsense; }\n"},
});

ProgramRecipe recipe(std::vector<Uniform> uniforms, std::string_view fragment = "square.frag") {
  return {.name = "square",
          .vertexFile = "square.vert",
          .fragmentFile = fragment,
          .uniforms = std::move(uniforms)};
}

const Uniform depth{"depth", UniformType::real};
const Uniform colour{"colour", UniformType::vec4};

}  // namespace

class DeviceTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void reportsDriverAndLimits();
  void checksUniforms_data();
  void checksUniforms();
  void namesTheFileThatDoesNotCompile();
  void draws_data();
  void draws();
  void drawsInstancesFromAStart();
  void clearsOnlyTheArea();
  void copiesDepth();
  void whatDoesNotFitIsRefused_data();
  void whatDoesNotFitIsRefused();
  void whatHasNoRoomIsNotRead();

 private:
  struct Scene;
  std::unique_ptr<HeadlessContext> m_context;
  std::unique_ptr<Device> m_device;
};

/// Provides an 8×8 target, and squares of half its side.
struct DeviceTest::Scene {
  Texture colours{TextureFormat::rgba8, {8, 8}, "colours"};
  Texture depths{TextureFormat::depth32f, {8, 8}, "depths"};
  std::unique_ptr<Target> target =
      std::move(Target::create({{&colours}, &depths}, "target").value());
  std::unique_ptr<Program> program =
      std::move(Program::create(files, Dialect::desktop330, recipe({depth, colour})).value());
  Buffer places{BufferKind::vertices, "places"};
  Geometry geometry{{{.buffer = &places,
                      .stride = 8,
                      .attributes = {{0, 2, AttributeType::float32, 0}},
                      .perInstance = true}},
                    nullptr,
                    "squares"};

  Scene() {
    // The squares are the lower left and the upper right quarter.
    const std::array<float, 4> corners{-1.0f, -1.0f, 0.0f, 0.0f};
    places.fill(std::as_bytes(std::span(corners)));
  }

  void square(Device& device, float z, const glm::vec4& c, DrawState state) {
    program->set("depth", z);
    program->set("colour", c);
    state.viewport = {0, 0, 8, 8};
    device.quads({*target, *program, geometry, state}, 1);
  }

  std::array<int, 4> pixel(Device& device, int x, int y) {
    std::array<std::byte, 4> rgba{};
    if (!device.read(*target, {x, y, 1, 1}, rgba))
      return {-1, -1, -1, -1};
    return {int(rgba[0]), int(rgba[1]), int(rgba[2]), int(rgba[3])};
  }
};

void DeviceTest::initTestCase() {
  auto context = HeadlessContext::create();
  if (!context)
    QSKIP(context.error().text().c_str());
  m_context = std::move(*context);
  auto device = Device::create();
  QVERIFY2(device.ok(), device.ok() ? "" : device.error().text().c_str());
  m_device = std::move(*device);
}

void DeviceTest::reportsDriverAndLimits() {
  QVERIFY(m_device->driver().find("OpenGL") != std::string::npos);
  QVERIFY(m_context->driver().find("EGL") != std::string::npos);
  QVERIFY(m_device->limits().textureSide >= 2048);
  QVERIFY(m_device->limits().viewportSide >= 2048);
}

void DeviceTest::checksUniforms_data() {
  QTest::addColumn<bool>("good");
  QTest::addColumn<QStringList>("names");
  QTest::addColumn<QString>("fault");
  QTest::newRow("as declared") << true << QStringList{"depth", "colour"} << "";
  QTest::newRow("not declared") << false << QStringList{"depth"} << "colour";
  QTest::newRow("not in the shader") << false << QStringList{"depth", "colour", "light"} << "light";
  QTest::newRow("another type") << false << QStringList{"depth", "colour:real"} << "colour";
}

void DeviceTest::checksUniforms() {
  QFETCH(bool, good);
  QFETCH(QStringList, names);
  QFETCH(QString, fault);
  std::vector<Uniform> uniforms;
  for (const QString& name : names)
    uniforms.push_back(name == "colour"        ? colour
                       : name == "colour:real" ? Uniform{"colour", UniformType::real}
                       : name == "light"       ? Uniform{"light", UniformType::vec3}
                                               : depth);
  const auto program = Program::create(files, m_device->dialect(), recipe(uniforms));
  QCOMPARE(program.ok(), good);
  if (!good)
    QCOMPARE(QString::fromStdString(program.error().where), "uniform " + fault);
}

void DeviceTest::namesTheFileThatDoesNotCompile() {
  const auto program = Program::create(files, m_device->dialect(), recipe({depth}, "broken.frag"));
  QVERIFY(!program.ok());
  QCOMPARE(program.error().file, std::string("broken.frag"));
  QVERIFY(program.error().reason.find("nonsense") != std::string::npos);
}

void DeviceTest::draws_data() {
  QTest::addColumn<int>("blend");
  QTest::addColumn<int>("test");
  QTest::addColumn<float>("z");
  QTest::addColumn<QList<int>>("expected");
  // The square is drawn over red 200, green 100, opaque, at depth 0.
  const int off = int(DepthTest::off);
  const int less = int(DepthTest::less);
  QTest::newRow("plain") << int(Blend::off) << off << 0.0f << QList<int>{51, 102, 0, 102};
  QTest::newRow("over") << int(Blend::over) << off << 0.0f << QList<int>{171, 162, 0, 255};
  QTest::newRow("maximum") << int(Blend::maximum) << off << 0.0f << QList<int>{200, 102, 0, 255};
  QTest::newRow("nearer") << int(Blend::off) << less << -0.5f << QList<int>{51, 102, 0, 102};
  QTest::newRow("farther") << int(Blend::off) << less << 0.5f << QList<int>{200, 100, 0, 255};
}

void DeviceTest::draws() {
  QFETCH(int, blend);
  QFETCH(int, test);
  QFETCH(float, z);
  QFETCH(QList<int>, expected);
  Scene scene;
  m_device->clear(*scene.target, {.colour = glm::vec4(200.0f / 255.0f, 100.0f / 255.0f, 0.0f, 1.0f),
                                  .depth = 0.5f});
  scene.square(*m_device, z, glm::vec4(0.2f, 0.4f, 0.0f, 0.4f),
               {.depth = DepthTest(test), .blend = Blend(blend)});
  const auto inside = scene.pixel(*m_device, 3, 3);
  for (std::size_t i = 0; i < 4; ++i)
    QVERIFY2(std::abs(inside[i] - expected[qsizetype(i)]) <= 1,
             qPrintable(QString("channel %1: %2").arg(i).arg(inside[i])));
  const std::array<int, 4> outside{200, 100, 0, 255};
  QCOMPARE(scene.pixel(*m_device, 4, 3), outside);
}

void DeviceTest::drawsInstancesFromAStart() {
  Scene scene;
  m_device->clear(*scene.target, {.colour = glm::vec4(0.0f), .depth = 1.0f});
  scene.geometry.startInstancesAt(1);
  scene.square(*m_device, 0.0f, glm::vec4(1.0f), {});
  QCOMPARE(scene.pixel(*m_device, 3, 3)[0], 0);
  QCOMPARE(scene.pixel(*m_device, 4, 4)[0], 255);
}

void DeviceTest::clearsOnlyTheArea() {
  Scene scene;
  m_device->clear(*scene.target, {.colour = glm::vec4(1.0f)});
  m_device->clear(*scene.target,
                  {.colour = glm::vec4(0.0f), .area = render::PixelRect{2, 2, 3, 3}});
  QCOMPARE(scene.pixel(*m_device, 1, 2)[0], 255);
  QCOMPARE(scene.pixel(*m_device, 2, 2)[0], 0);
  QCOMPARE(scene.pixel(*m_device, 4, 4)[0], 0);
  QCOMPARE(scene.pixel(*m_device, 5, 4)[0], 255);
}

void DeviceTest::copiesDepth() {
  Scene from;
  Scene to;
  m_device->clear(*from.target, {.colour = glm::vec4(0.0f), .depth = 0.25f});
  m_device->clear(*to.target, {.colour = glm::vec4(0.0f), .depth = 1.0f});
  m_device->copyDepth(*from.target, *to.target, {0, 0, 2, 8});
  // Window depth 0.5 lies behind the copied depth and before the depth elsewhere.
  to.square(*m_device, 0.0f, glm::vec4(1.0f), {.depth = DepthTest::less});
  QCOMPARE(to.pixel(*m_device, 1, 1)[0], 0);
  QCOMPARE(to.pixel(*m_device, 2, 1)[0], 255);
}

void DeviceTest::whatDoesNotFitIsRefused_data() {
  QTest::addColumn<int>("bytes");
  QTest::addColumn<QRect>("area");
  QTest::addColumn<bool>("fits");
  QTest::newRow("all") << 4 * 8 * 8 << QRect(0, 0, 8, 8) << true;
  QTest::newRow("a corner") << 4 * 3 * 2 << QRect(5, 6, 3, 2) << true;
  QTest::newRow("nothing") << 0 << QRect(3, 3, 0, 0) << true;
  QTest::newRow("a byte less") << 4 * 8 * 8 - 1 << QRect(0, 0, 8, 8) << false;
  QTest::newRow("none for some pixels") << 0 << QRect(0, 0, 8, 8) << false;
  QTest::newRow("more") << 4 * 8 * 8 << QRect(0, 0, 8, 7) << false;
  QTest::newRow("for no pixels") << 4 << QRect(0, 0, 0, 1) << false;
  QTest::newRow("beyond the right edge") << 4 * 3 * 2 << QRect(6, 6, 3, 2) << false;
  QTest::newRow("beyond the upper edge") << 4 * 3 * 2 << QRect(0, 7, 3, 2) << false;
  QTest::newRow("before the left edge") << 4 * 3 * 2 << QRect(-1, 0, 3, 2) << false;
  QTest::newRow("below the lower edge") << 4 * 3 * 2 << QRect(0, -1, 3, 2) << false;
}

/// Drivers trust sizes: what is too little for its pixels is read beyond its end.
void DeviceTest::whatDoesNotFitIsRefused() {
  QFETCH(int, bytes);
  QFETCH(QRect, area);
  QFETCH(bool, fits);
  const Scene scene;
  m_device->clear(*scene.target, {.colour = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f)});
  const std::vector<std::byte> grey(std::size_t(bytes), std::byte(77));
  const Status done = scene.colours.upload(grey, {area.x(), area.y(), area.width(), area.height()});
  QCOMPARE(done.ok(), fits);
  QVERIFY(fits || (!done.error().reason.empty() && !done.error().remedy.empty()));
  std::array<std::byte, 4 * 8 * 8> rgba{};
  QVERIFY(m_device->read(*scene.target, {0, 0, 8, 8}, rgba).ok());
  QCOMPARE(int(std::count(rgba.begin(), rgba.end(), std::byte(77))), fits ? bytes : 0);
}

void DeviceTest::whatHasNoRoomIsNotRead() {
  const Scene scene;
  m_device->clear(*scene.target, {.colour = glm::vec4(1.0f)});
  std::array<std::byte, 4 * 8 * 8> rgba{};
  QVERIFY(!m_device->read(*scene.target, {0, 0, 8, 8}, std::span(rgba).first(4 * 8 * 8 - 1)).ok());
  QCOMPARE(int(std::count(rgba.begin(), rgba.end(), std::byte(0))), int(rgba.size()));
  QVERIFY(m_device->read(*scene.target, {0, 0, 8, 8}, rgba).ok());
  QCOMPARE(int(std::count(rgba.begin(), rgba.end(), std::byte(255))), int(rgba.size()));
}

SLINE_TEST_WITH_EVENTS(DeviceTest)
#include "device_test.moc"
