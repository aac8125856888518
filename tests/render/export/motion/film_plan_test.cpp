// SPDX-License-Identifier: Apache-2.0
// Tests the parts that plan a film's labels, each by itself and on small cases against all that
// could be chosen.
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "render/export/motion/film.h"
#include "render/export/motion/film_label.h"
#include "render/export/motion/film_paths.h"
#include "render/export/motion/film_places.h"
#include "render/export/motion/label_heights.h"
#include "render/export/motion/label_presence.h"
#include "render/export/motion/least_costly.h"
#include "render/export/motion/rank_stretches.h"
#include "render/labels/layout.h"
#include "tests/support/shapes.h"
#include "tests/support/suite.h"

using namespace sline;
using namespace sline::render;

namespace {

/// Returns a film of so many frames: a turn, which loops, or a way from view to view.
Film filmOf(int frames, int rate, bool loops) {
  ExportOrder order;
  order.scene.append({.name = "ball", .mesh = test::sphere(10.0f, 1)});
  model::View back{.name = "back", .camera = {}};
  back.camera.eye = {0.0f, 1000.0f, 0.0f};
  order.scene.setViews({{.name = "front", .camera = {}}, back});
  order.of<FilmOptions>() = {.motion = loops ? Motion::turntable : Motion::tour,
                             .seconds = double(frames) / double(rate),
                             .framesPerSecond = rate,
                             .hold = 0.0};
  Film film = std::move(Film::create(order)).value();
  if (film.frames() != frames || film.loops() != loops)
    qFatal("%d frames", film.frames());
  return film;
}

Presence presence(const char* frames) {
  Presence there;
  for (; *frames; ++frames)
    there.push_back(*frames == '#');
  return there;
}

QString told(const Presence& there) {
  QString text;
  for (const bool in : there)
    text += QLatin1Char(in ? '#' : '.');
  return text;
}

/// Returns the lengths of runs that are there, and of gaps between them.
std::vector<int> runsBetween(const Presence& there, bool loops) {
  std::vector<int> ends;
  const int count = int(there.size());
  for (int t = loops ? 0 : 1; t < count; ++t)
    if (there[std::size_t(t)] != there[std::size_t((t + count - 1) % count)])
      ends.push_back(t);
  std::vector<int> lengths;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    lengths.push_back(ends[k + 1] - ends[k]);
  if (loops && !ends.empty())
    lengths.push_back(ends.front() + count - ends.back());
  return lengths;
}

bool steadyFor(const Presence& there, int second, bool loops) {
  const std::vector<int> lengths = runsBetween(there, loops);
  return std::all_of(lengths.begin(), lengths.end(), [&](int length) { return length >= second; });
}

/// Calls back with each way to choose among `choices` in each frame.
void eachWay(std::size_t frames, std::size_t choices,
             const std::function<void(const std::vector<std::size_t>&)>& with) {
  std::vector<std::size_t> way(frames, 0);
  for (std::size_t at = 0; at < frames;) {
    with(way);
    for (at = 0; at < frames && ++way[at] == choices; ++at)
      way[at] = 0;
  }
}

LabelItem itemOf(int id, const glm::vec2& place, LabelPost side = LabelPost::left) {
  LabelItem item;
  item.id = model::AnnotationId{std::uint64_t(id)};
  item.places = {place};
  item.box = {20.0f, 5.0f};
  item.side = side;
  return item;
}

/// Returns a picture of 200 × 150 mm in which the anatomy is in the middle.
LabelRequest pictureOf(std::vector<LabelItem> items) {
  LabelRequest request;
  request.items = std::move(items);
  request.space.size = {200.0f, 150.0f};
  request.obstacles.extent = LabelBox{{50.0f, 10.0f}, {150.0f, 140.0f}};
  request.still = true;
  return request;
}

}  // namespace

class FilmPlanTest : public QObject {
  Q_OBJECT

 private slots:
  /// The walk costs what the best of all ways costs. Where a film loops it looks one turn ahead,
  /// which is as good but for a change now and then.
  void walksAtLeastCost() {
    std::mt19937 random(7);
    const auto under = [&](unsigned below) { return double(random() % below); };
    int worse = 0;
    for (int round = 0; round < 400; ++round) {
      const std::size_t frames = 2 + random() % 5;
      const std::size_t choices = 1 + random() % 3;
      std::vector<std::vector<double>> costs(frames, std::vector<double>(choices));
      for (std::vector<double>& frame : costs)
        for (double& cost : frame)
          cost = under(10);
      std::vector<std::vector<double>> changes(choices, std::vector<double>(choices));
      for (std::size_t a = 0; a < choices; ++a)
        for (std::size_t b = 0; b < choices; ++b)
          changes[a][b] = a == b ? 0.0 : 1.0 + under(7);
      for (const bool loops : {false, true}) {
        const auto costOf = [&](const std::vector<std::size_t>& way) {
          double sum = 0.0;
          for (std::size_t t = 0; t < frames; ++t) {
            sum += costs[t][way[t]];
            if (t > 0 || loops)
              sum += changes[way[(t + frames - 1) % frames]][way[t]];
          }
          return sum;
        };
        double least = 1e9;
        eachWay(frames, choices, [&](const auto& way) { least = std::min(least, costOf(way)); });
        const double walked = costOf(leastCostly(
            frames, choices, loops, [&](std::size_t t, std::size_t k) { return costs[t][k]; },
            [&](std::size_t, std::size_t from, std::size_t to) { return changes[from][to]; }));
        if (loops)
          worse += walked > least + 1e-9 ? 1 : 0;
        else
          QCOMPARE(walked, least);
        QVERIFY(walked < least + 8.0);
      }
    }
    QVERIFY2(worse <= 4, qPrintable(QString::number(worse)));
  }

  void staysForASecond_data() {
    QTest::addColumn<QString>("given");
    QTest::addColumn<bool>("loops");
    QTest::addColumn<QString>("kept");
    QTest::newRow("all") << "##########" << false << "##########";
    QTest::newRow("none") << ".........." << true << "..........";
    QTest::newRow("too short") << "..##......" << false << "..........";
    QTest::newRow("just long enough") << "..###....." << false << "..###.....";
    QTest::newRow("a short gap grows") << "####.#####" << false << "####...###";
    QTest::newRow("a gap grows until nothing is left") << "###.###..." << false << "###.......";
    QTest::newRow("a short gap at the beginning") << ".#########" << false << ".#########";
    QTest::newRow("and in a loop") << ".#########" << true << "...#######";
    QTest::newRow("over the end of a loop") << "#.......##" << true << "#.......##";
    QTest::newRow("too short over the end") << "#........#" << true << "..........";
  }
  void staysForASecond() {
    QFETCH(QString, given);
    QFETCH(bool, loops);
    QFETCH(QString, kept);
    Presence there = presence(qPrintable(given));
    stayForASecond(there, filmOf(10, 3, loops));
    QCOMPARE(told(there), kept);
  }

  /// Whatever is asked for: nothing is added, and nothing blinks.
  void neverBlinks() {
    std::mt19937 random(11);
    for (const bool loops : {false, true}) {
      const Film film = filmOf(20, 4, loops);
      for (int round = 0; round < 500; ++round) {
        Presence given(20);
        for (std::size_t t = 0; t < given.size(); ++t)
          given[t] = random() % 5 != 0;
        Presence there = given;
        stayForASecond(there, film);
        QVERIFY2(steadyFor(there, 4, loops), qPrintable(told(given) + ' ' + told(there)));
        for (std::size_t t = 0; t < there.size(); ++t)
          QVERIFY(given[t] || !there[t]);
        const Presence once = there;
        stayForASecond(there, film);
        QCOMPARE(there, once);
      }
    }
  }

  /// A label keeps its rank, or changes it where this costs less than to be in others' way.
  void ranksChangeSeldom() {
    const auto stretchesOf = [](const std::vector<int>& ranks, bool loops) {
      std::vector<std::optional<FrameRank>> frames;
      for (const int rank : ranks)
        frames.push_back(rank < 0 ? std::nullopt : std::optional(FrameRank{std::size_t(rank)}));
      QStringList told;
      for (const Presence& one : rankStretches(frames, filmOf(int(ranks.size()), 2, loops)))
        told << ::told(one);
      return told;
    };
    QCOMPARE(stretchesOf({1, 1, 1, 1, 1, 1, 1, 1}, true), QStringList{"########"});
    QCOMPARE(stretchesOf({1, 1, -1, 1, 1, 1, -1, 1}, false), QStringList{"##.###.#"});
    // A moment elsewhere is no reason.
    QCOMPARE(stretchesOf({1, 1, 9, 1, 1, 1, 1, 1}, false), QStringList{"########"});
    // For good it is, and the label is gone for a second at the change.
    QCOMPARE(stretchesOf({0, 0, 0, 0, 9, 9, 9, 9}, false), (QStringList{"###.....", ".....###"}));
    const QStringList both = stretchesOf({0, 0, 0, 0, 0, 9, 9, 9, 9, 9}, true);
    QCOMPARE(both.size(), qsizetype(2));
    for (std::size_t t = 0; t < 10; ++t)
      QVERIFY(both[0][qsizetype(t)] == QLatin1Char('.') ||
              both[1][qsizetype(t)] == QLatin1Char('.'));
    // Of little weight, it stays.
    std::vector<std::optional<FrameRank>> faint(8, FrameRank{0, 0.1});
    for (std::size_t t = 4; t < 8; ++t)
      faint[t]->rank = 9;
    QCOMPARE(rankStretches(faint, filmOf(8, 2, false)).size(), std::size_t(1));
  }

  void pathsAreSteady() {
    const auto heights = [](const std::vector<float>& places) {
      return std::vector<std::optional<float>>(places.begin(), places.end());
    };
    const Film film = filmOf(40, 10, false);
    // Within the slack it stands still, even where it is absent in between.
    std::vector<std::optional<float>> near;
    for (int t = 0; t < 40; ++t)
      near.push_back(t % 7 == 3 ? std::nullopt : std::optional(50.0f + 8.0f * std::sin(float(t))));
    const std::vector<float> still = steadyPath(near, 10.0f, film);
    QVERIFY(std::all_of(still.begin(), still.end(), [&](float y) { return y == still.front(); }));
    // A leap is gone after slowly.
    std::vector<float> leap(40, 20.0f);
    std::fill(leap.begin() + 20, leap.end(), 90.0f);
    const std::vector<float> path = steadyPath(heights(leap), 10.0f, film);
    float fastest = 0.0f;
    for (std::size_t t = 1; t < path.size(); ++t)
      fastest = std::max(fastest, std::abs(path[t] - path[t - 1]));
    QVERIFY2(fastest < 4.5f, qPrintable(QString::number(double(fastest))));
    QVERIFY(path.front() < 35.0f && path.back() > 70.0f);
    QCOMPARE(averaged({0.0f, 0.0f, 3.0f, 0.0f, 0.0f}, 1, false),
             (std::vector<float>{0.0f, 1.0f, 1.0f, 1.0f, 0.0f}));
    QCOMPARE(averaged({3.0f, 0.0f, 0.0f, 0.0f, 0.0f}, 1, true),
             (std::vector<float>{1.0f, 1.0f, 0.0f, 0.0f, 1.0f}));
    const std::vector<float> share = eased(presence("...##....."), 2, false);
    QCOMPARE(share[3], 1.0f);
    QCOMPARE(share[0], 0.0f);
    QVERIFY(share[1] > 0.0f && share[1] < share[2] && share[2] < 1.0f);
  }

  /// Of two labels that cannot stand together the hidden one is gone, no longer than it must; the
  /// rest of all they could do would be worse.
  void disputesCostLittle() {
    constexpr std::size_t count = 12;
    for (const bool loops : {false, true}) {
      const Film film = filmOf(int(count), 2, loops);
      std::vector<LabelRequest> frames;
      for (std::size_t t = 0; t < count; ++t) {
        std::vector<LabelItem> items{itemOf(1, {80.0f, 40.0f}), itemOf(2, {90.0f, 80.0f}),
                                     itemOf(3, {100.0f, 120.0f})};
        items[0].height = 40.0f;
        items[1].height = t >= 4 && t < 7 ? 42.0f : 80.0f;  // over the first
        items[1].hidden = true;
        items[2].height = 120.0f;
        frames.push_back(pictureOf(std::move(items)));
        frames.back().widths = {20.0f, 20.0f};
      }
      std::vector<FilmLabel> labels = filmLabels(frames);
      keepApart(labels, frames, film);
      QCOMPARE(told(labels[0].there), QString(12, '#'));
      QCOMPARE(told(labels[1].there), QStringLiteral("####...#####"));
      QCOMPARE(told(labels[2].there), QString(12, '#'));
    }
  }

  /// Whatever labels wish: no two that stand are in conflict, and none blinks; nor would any find
  /// room for the whole film.
  void disputesAreSettled() {
    std::mt19937 random(3);
    const auto within = [&](float low, float high) {
      return low + (high - low) * float(random() % 1000) / 1000.0f;
    };
    for (int round = 0; round < 12; ++round) {
      const bool loops = round % 2 == 0;
      const Film film = filmOf(24, 4, loops);
      std::vector<LabelRequest> frames;
      std::vector<glm::vec2> places;
      for (int k = 0; k < 6; ++k)
        places.push_back({within(60.0f, 140.0f), within(20.0f, 130.0f)});
      for (int t = 0; t < 24; ++t) {
        std::vector<LabelItem> items;
        for (int k = 0; k < 6; ++k) {
          if (t % 6 == 0)
            places[std::size_t(k)] = {within(60.0f, 140.0f), within(20.0f, 130.0f)};
          items.push_back(
              itemOf(k + 1, places[std::size_t(k)], k % 2 ? LabelPost::left : LabelPost::right));
        }
        frames.push_back(pictureOf(std::move(items)));
      }
      std::vector<FilmLabel> labels = filmLabels(frames);
      planHeights(labels, frames, film);
      keepApart(labels, frames, film);
      for (const FilmLabel& label : labels)
        QVERIFY2(steadyFor(label.there, 4, loops), qPrintable(told(label.there)));
      for (std::size_t t = 0; t < frames.size(); ++t) {
        LabelRequest standing = frames[t];
        std::erase_if(standing.items, [&](const LabelItem& item) {
          return !std::find_if(labels.begin(), labels.end(), [&](const FilmLabel& label) {
                    return label.id == item.id;
                  })->there[t];
        });
        QVERIFY(labelConflicts(standing).empty());
      }
    }
  }

  /// Boxes of a column keep their order, do not overlap and go slowly; one near its place all the
  /// time stands still, and one that changes sides is gone for a second.
  void heightsHoldStill() {
    const Film film = filmOf(40, 10, false);
    std::vector<LabelRequest> frames;
    for (int t = 0; t < 40; ++t) {
      const float wave = 6.0f * std::sin(0.3f * float(t));
      frames.push_back(
          pictureOf({itemOf(1, {80.0f, 60.0f + wave}), itemOf(2, {90.0f, 62.0f - wave}),
                     itemOf(3, {100.0f, 20.0f + 2.0f * float(t)}),
                     itemOf(4, {100.0f, 70.0f}, t < 20 ? LabelPost::left : LabelPost::right)}));
    }
    std::vector<FilmLabel> labels = filmLabels(frames);
    planHeights(labels, frames, film);
    const auto height = [&](std::size_t k, std::size_t t) { return *labels[k].items[t]->height; };
    for (std::size_t t = 0; t < 40; ++t) {
      QCOMPARE(labels[3].there[t], t < 15 || t >= 25);
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < a; ++b)
          if (labels[a].there[t] && labels[b].there[t] &&
              labels[a].items[t]->side == labels[b].items[t]->side)
            QVERIFY(std::abs(height(a, t) - height(b, t)) >= 5.0f);
      for (std::size_t a = 0; a < 4 && t > 0; ++a)
        if (labels[a].there[t] && labels[a].there[t - 1])
          QVERIFY(std::abs(height(a, t) - height(a, t - 1)) < 3.0f);
    }
    QVERIFY(frames.front().widths == (std::array<float, 2>{20.0f, 20.0f}));
  }

  /// Where there is no room for all, those are left out that one does not see.
  void crowdsLeaveOutTheHidden() {
    const Film film = filmOf(20, 5, true);
    std::vector<LabelRequest> frames;
    for (int t = 0; t < 20; ++t) {
      std::vector<LabelItem> items;
      for (int k = 0; k < 36; ++k) {
        items.push_back(itemOf(k + 1, {80.0f, 20.0f + 3.0f * float(k)}));
        items.back().hidden = k % 3 == 0;
      }
      frames.push_back(pictureOf(std::move(items)));
    }
    std::vector<FilmLabel> labels = filmLabels(frames);
    planHeights(labels, frames, film);
    std::size_t out = 0;
    for (const FilmLabel& label : labels) {
      const bool there = label.there.front();
      QVERIFY(there || label.items.front()->hidden);
      out += there ? 0 : 1;
    }
    QVERIFY2(out > 0 && out <= 12, qPrintable(QString::number(out)));
  }

  /// Leaders meet where, and only where, no bend leads them past each other.
  void meetingIsKnownBeforehand() {
    std::mt19937 random(5);
    const auto within = [&](float low, float high) {
      return low + (high - low) * float(random() % 1000) / 1000.0f;
    };
    int meet = 0;
    int agree = 0;
    constexpr int rounds = 600;
    for (int round = 0; round < rounds; ++round) {
      const LabelPost side = round % 2 ? LabelPost::left : LabelPost::right;
      std::vector<LabelItem> items{itemOf(1, {within(60.0f, 140.0f), within(20.0f, 130.0f)}, side),
                                   itemOf(2, {within(60.0f, 140.0f), within(20.0f, 130.0f)}, side)};
      items[0].height = within(20.0f, 60.0f);
      items[1].height = *items[0].height + within(6.0f, 70.0f);
      const bool said = leadersMeet(items[0], items[1]);
      QCOMPARE(leadersMeet(items[1], items[0]), said);
      LabelRequest request = pictureOf(std::move(items));
      request.widths = {20.0f, 20.0f};
      meet += said ? 1 : 0;
      agree += labelConflicts(request).empty() != said ? 1 : 0;
    }
    QVERIFY(meet > rounds / 10 && meet < rounds / 2);
    QVERIFY2(agree >= 0.97 * rounds, qPrintable(QString::number(agree)));
    LabelItem one = itemOf(1, {80.0f, 90.0f});
    LabelItem two = itemOf(2, {60.0f, 50.0f});
    one.height = 70.0f;
    two.height = 80.0f;
    QVERIFY(leadersMeet(one, two));
    two.side = LabelPost::right;
    QVERIFY(!leadersMeet(one, two));
    two.side = LabelPost::left;
    two.height.reset();
    QVERIFY(!leadersMeet(one, two));
  }

  /// A label points elsewhere on its structure where its leader would meet another's, but not at a
  /// place that one does not see.
  void placesGiveWay() {
    const Film film = filmOf(12, 4, true);
    const model::AnnotationId id{1};
    PlacePool pool;
    pool[id].anchors.resize(2);
    for (const bool seen : {true, false}) {
      std::vector<LabelSights> sights(12);
      std::vector<LabelRequest> requests;
      for (LabelSights& frame : sights) {
        frame.labels.shown.resize(2);
        ShownLabel& first = frame.labels.shown[0];
        first.item = itemOf(1, {90.0f, 100.0f});
        first.choices = {{0, {90.0f, 100.0f}, true}, {1, {90.0f, 45.0f}, seen}};
        frame.labels.shown[1].item = itemOf(2, {70.0f, 60.0f});
        std::vector<LabelItem> items{first.item, frame.labels.shown[1].item};
        items[0].height = 70.0f;
        items[1].height = 80.0f;
        requests.push_back(pictureOf(std::move(items)));
      }
      QVERIFY(leadersMeet(requests[0].items[0], requests[0].items[1]));
      uncrossPlaces(requests, sights, pool, film);
      for (const LabelRequest& request : requests) {
        QCOMPARE(request.items[0].places.front().y, seen ? 45.0f : 100.0f);
        QVERIFY(!request.items[0].hidden);
        QCOMPARE(request.items[1].places.front().y, 60.0f);
      }
    }
  }
};

SLINE_TEST(FilmPlanTest)
#include "film_plan_test.moc"
