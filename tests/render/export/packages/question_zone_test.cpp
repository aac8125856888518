// SPDX-License-Identifier: Apache-2.0
// Tests where in a picture an answer is right.
#include <QtTest>
#include <algorithm>

#include "render/export/packages/question_zone.h"
#include "tests/support/suite.h"

using namespace sline;

namespace {

/// Returns an area drawn with '#'; millimetres are cells.
render::SeenArea areaOf(const std::vector<std::string>& rows) {
  render::SeenArea area;
  area.grid = {.columns = int(rows.front().size()), .rows = int(rows.size()), .side = 1.0f};
  for (const std::string& row : rows)
    for (const char c : row)
      area.cells.push_back(c == '#');
  return area;
}

glm::vec2 sizeOf(const render::SeenArea& area) {
  return {float(area.grid.columns), float(area.grid.rows)};
}

/// Returns a disc with a hole, and beside it a smaller disc.
render::SeenArea ringAndDisc() {
  render::SeenArea area;
  area.grid = {.columns = 120, .rows = 80, .side = 1.0f};
  for (int y = 0; y < 80; ++y)
    for (int x = 0; x < 120; ++x) {
      const auto within = [&](int cx, int cy, int r) {
        return (x - cx) * (x - cx) + (y - cy) * (y - cy) <= r * r;
      };
      area.cells.push_back((within(40, 40, 30) && !within(45, 38, 12)) || within(100, 30, 12));
    }
  return area;
}

}  // namespace

class QuestionZoneTest : public QObject {
  Q_OBJECT

 private slots:
  void isWhatIsSeen() {
    const render::SeenArea area = ringAndDisc();
    const render::QuestionZone zone = zoneOf(area, sizeOf(area));
    int differ = 0;
    for (int y = 0; y < area.grid.rows; ++y)
      for (int x = 0; x < area.grid.columns; ++x)
        differ += area.at(x, y) !=
                  render::isWithin(zone.outline, (glm::vec2(x, y) + 0.5f) / sizeOf(area));
    const auto seen = std::count(area.cells.begin(), area.cells.end(), true);
    QVERIFY2(100 * differ <= 4 * seen, qPrintable(QString::number(differ)));
    QVERIFY(zone.outline.size() < 120);
    QVERIFY(!render::isWithin(zone.outline, glm::vec2(45.0f, 38.0f) / sizeOf(area)));  // the hole
    QVERIFY(render::isWithin(zone.outline,
                             glm::vec2(100.0f, 30.0f) / sizeOf(area)));  // the second part
    QVERIFY(zone.canBeHit());
  }

  void boxesLieWithinIt() {
    const render::SeenArea area = ringAndDisc();
    const render::QuestionZone zone = zoneOf(area, sizeOf(area));
    QVERIFY(!zone.boxes.empty() && zone.boxes.size() <= 12);
    std::size_t covered = 0;
    for (const auto& box : zone.boxes) {
      const glm::ivec2 low = glm::ivec2(glm::round(box.low * sizeOf(area)));
      const glm::ivec2 high = glm::ivec2(glm::round(box.high * sizeOf(area)));
      for (int y = low.y; y < high.y; ++y)
        for (int x = low.x; x < high.x; ++x) {
          QVERIFY(area.at(x, y));
          ++covered;
        }
    }
    const auto seen = std::size_t(std::count(area.cells.begin(), area.cells.end(), true));
    QVERIFY2(10 * covered >= 7 * seen, qPrintable(QString::number(covered)));
  }

  void cornersThatTouchStayApart() {
    std::vector<std::string> rows(40, std::string(40, ' '));
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x) {
        rows[std::size_t(y)][std::size_t(x)] = '#';
        rows[std::size_t(y + 20)][std::size_t(x + 20)] = '#';
      }
    const render::SeenArea area = areaOf(rows);
    const render::QuestionZone zone = zoneOf(area, sizeOf(area));
    QVERIFY(render::isWithin(zone.outline, {0.25f, 0.25f}));
    QVERIFY(render::isWithin(zone.outline, {0.75f, 0.75f}));
    QVERIFY(!render::isWithin(zone.outline, {0.75f, 0.25f}));
    QVERIFY(!render::isWithin(zone.outline, {0.25f, 0.75f}));
  }

  void whatIsTooSmallCannotBeHit() {
    std::vector<std::string> rows(200, std::string(200, ' '));
    QVERIFY(zoneOf(areaOf(rows), {200.0f, 200.0f}).outline.empty());
    rows[10][10] = '#';  // a speck
    QVERIFY(zoneOf(areaOf(rows), {200.0f, 200.0f}).outline.empty());
    for (std::size_t x = 0; x < 180; ++x)
      rows[50][x] = '#';  // a hair
    QVERIFY(!zoneOf(areaOf(rows), {200.0f, 200.0f}).canBeHit());
    for (std::size_t x = 0; x < 180; ++x)
      rows[51][x] = rows[52][x] = rows[53][x] = rows[54][x] = '#';
    QVERIFY(zoneOf(areaOf(rows), {200.0f, 200.0f}).canBeHit());
  }
};

SLINE_TEST(QuestionZoneTest)
#include "question_zone_test.moc"
