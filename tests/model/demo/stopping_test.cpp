// SPDX-License-Identifier: Apache-2.0
// Tests that modelling is given up at once, wherever it is, when its result is no longer wanted.
#include <QTemporaryDir>
#include <QTest>
#include <atomic>
#include <glm/geometric.hpp>

#include "model/demo/demo.h"
#include "model/sculpting/sculpture.h"
#include "model/sculpting/stopping.h"
#include "tests/support/suite.h"

namespace sline::model {

namespace {

constexpr Box box{{-24, -24, -24}, {24, 24, 24}};

/// A ball that requests a stop when its field has been evaluated `enough` times, and counts on.
struct Patience {
  std::atomic<int> asked = 0;
  int enough = 0;
  std::stop_source source;

  Field ball() {
    return [this](const glm::vec3& p) {
      if (++asked == enough)
        source.request_stop();
      return glm::length(p) - 20.0f;
    };
  }
};

/// Each thread may be in the middle of an evaluation.
constexpr int threads = 256;

}  // namespace

class StoppingTest : public QObject {
  Q_OBJECT
 private slots:
  void structuresAreGivenUp_data() {
    QTest::addColumn<int>("enough");
    QTest::newRow("at once") << 1;
    QTest::newRow("while sampling") << 1'000;
    QTest::newRow("later") << 20'000;
  }
  void structuresAreGivenUp() {
    QFETCH(int, enough);
    Patience patience;
    patience.enough = enough;
    const DemoStructure ball{.name = "ball",
                             .groups = {},
                             .colour = {},
                             .fill = {},
                             .inkColour = {},
                             .field = patience.ball(),
                             .box = box,
                             .edge = 0.5f,
                             .givesWayTo = {},
                             .opening = {}};
    QVERIFY_THROWS_EXCEPTION(ModellingStopped,
                             static_cast<void>(demoScene({ball}, patience.source.get_token())));
    QVERIFY(patience.asked >= enough);
    QVERIFY(patience.asked < enough + threads);
  }

  void sculpturesAreGivenUp() {
    Patience patience;
    patience.enough = 2'000;
    Sculpture clay;
    clay.add(patience.ball(), box, 1.0f);
    QVERIFY_THROWS_EXCEPTION(ModellingStopped, static_cast<void>(clay.sampled(
                                                   {0.5f, 0.3f}, patience.source.get_token())));
    // The stop is checked between blocks.
    constexpr int block = 16 * 16 * 16;
    QVERIFY(patience.asked < patience.enough + threads * block);
  }

  void demosLeaveNothing_data() {
    QTest::addColumn<int>("demo");
    for (std::size_t i = 0; i < demoNames.size(); ++i)
      QTest::newRow(std::string(demoNames[i]).c_str()) << int(i);
  }
  void demosLeaveNothing() {
    QFETCH(int, demo);
    const QTemporaryDir folder;
    const std::filesystem::path cache = folder.path().toStdString();
    std::stop_source source;
    source.request_stop();
    QVERIFY(!model::demo(DemoName(demo), Sex::female, cache, source.get_token()));
    QVERIFY(!std::filesystem::exists(cache / demoCacheFile(DemoName(demo), Sex::female)));
  }
};

}  // namespace sline::model

SLINE_TEST(sline::model::StoppingTest)
#include "stopping_test.moc"
