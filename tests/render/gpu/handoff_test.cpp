// SPDX-License-Identifier: Apache-2.0
// Tests pictures drawn and shown in turn in one context: which is shown, and which part of it; and
// that pictures read back have their colours and stand upright.
#include <QtTest>

#include "render/gpu/device.h"
#include "render/gpu/handoff.h"
#include "render/gpu/headless/context.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render::gpu;

namespace {

constexpr TextureSize size{.width = 8, .height = 4};

void drawGrey(Device& device, Handoff& handoff, float grey, std::uint64_t number) {
  const auto target = handoff.begin(size);
  QVERIFY(target.ok());
  device.clear(**target, {.colour = glm::vec4(grey, grey, grey, 1.0f)});
  handoff.publish(number);
}

}  // namespace

class HandoffTest : public QObject {
  Q_OBJECT

  std::unique_ptr<HeadlessContext> m_context;
  std::unique_ptr<Device> m_device;

  /// Shows into a target of its own and returns the picture's number and the grey of a pixel.
  std::pair<std::uint64_t, int> shown(Handoff& handoff, TextureSize screen) {
    const Texture pixels(TextureFormat::rgba8, screen, "screen");
    const auto target = Target::create({{&pixels}, nullptr}, "screen");
    m_device->clear(**target, {.colour = glm::vec4(0.0f)});  // leaves it bound for drawing
    const std::uint64_t number = handoff.show(screen);
    std::vector<std::byte> rgba(std::size_t(screen.width) * screen.height * 4);
    if (!m_device->read(**target, {0, 0, screen.width, screen.height}, rgba))
      return {number, -1};
    return {number, int(rgba[rgba.size() / 2])};
  }

 private slots:
  void initTestCase() {
    auto context = HeadlessContext::create();
    if (!context)
      QSKIP(context.error().text().c_str());
    m_context = std::move(*context);
    auto device = Device::create();
    QVERIFY(device.ok());
    m_device = std::move(*device);
  }

  void newestIsShown() {
    Handoff handoff;
    QCOMPARE(shown(handoff, size).first, std::uint64_t(0));
    drawGrey(*m_device, handoff, 0.2f, 1);
    QCOMPARE(shown(handoff, size), std::pair(std::uint64_t(1), 51));
    // The picture is shown again while the next one is being drawn.
    QVERIFY(handoff.begin(size).ok());
    QCOMPARE(shown(handoff, size), std::pair(std::uint64_t(1), 51));
    drawGrey(*m_device, handoff, 0.4f, 2);
    drawGrey(*m_device, handoff, 0.6f, 3);  // overtakes 2
    QCOMPARE(shown(handoff, size), std::pair(std::uint64_t(3), 153));
    for (std::uint64_t number = 4; number < 12; ++number) {
      drawGrey(*m_device, handoff, float(number) / 15.0f, number);
      QCOMPARE(shown(handoff, size), std::pair(number, int(number) * 17));
    }
    handoff.releaseShowing();
    handoff.releaseDrawing();
  }

  void scalesToTheScreen() {
    Handoff handoff;
    drawGrey(*m_device, handoff, 0.8f, 1);
    QCOMPARE(shown(handoff, {.width = 30, .height = 11}), std::pair(std::uint64_t(1), 204));
    handoff.releaseShowing();
    handoff.releaseDrawing();
  }

  void neverDrawsOverWhatIsShown() {
    Handoff handoff;
    drawGrey(*m_device, handoff, 0.2f, 1);
    QCOMPARE(shown(handoff, size).first, std::uint64_t(1));
    drawGrey(*m_device, handoff, 0.4f, 2);
    // Neither the one shown (1) nor the newest (2) may be touched.
    const auto third = handoff.begin(size);
    QVERIFY(third.ok());
    m_device->clear(**third, {.colour = glm::vec4(1.0f)});
    QCOMPARE(shown(handoff, size), std::pair(std::uint64_t(2), 102));
    handoff.releaseShowing();
    handoff.releaseDrawing();
  }
};

SLINE_TEST_WITH_EVENTS(HandoffTest)
#include "handoff_test.moc"
