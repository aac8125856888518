// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/writing_proof.h"

#include <QPainterPath>
#include <QRectF>
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <optional>
#include <utility>

namespace sline::render {

namespace {

using FaultKind = WritingFault::Kind;

/// The alpha from which a pixel counts as drawn on.
constexpr std::uint8_t drawnAlpha = 26;
// Millimetres.
constexpr float dotRadius = 0.5f;
constexpr float halfLeader = 0.1f;
constexpr float apart = 1.3f;  // dots that can be told apart
constexpr float same = 0.01f;

/// Letters or a mark as they stand: a box for each line of text and for each shape.
struct Written {
  std::string name;
  std::vector<QRectF> boxes;
};

void addLines(std::vector<QRectF>& boxes, const LetteringText& text) {
  for (std::size_t i = 0; i < text.lines.size(); ++i) {
    LetteringText line = text;
    line.lines = {text.lines[i]};
    line.at.y += float(i) * text.leading;
    if (const QRectF box = outlineOf(line).boundingRect(); !box.isEmpty())
      boxes.push_back(box);
  }
}

Written writtenOf(const LetteringItem& item, bool shapes) {
  Written written{.name = item.name, .boxes = {}};
  if (item.text)
    addLines(written.boxes, *item.text);
  if (shapes)
    for (const LetteringShape& shape : item.shapes)
      written.boxes.push_back(painterPath(shape.path).boundingRect());
  return written;
}

/// A label that stands in the picture.
struct Told {
  model::AnnotationId id;
  Written text;
  Leader leader;
  std::vector<glm::vec2> dots;
  bool byHand = false;
};

std::vector<Told> toldBy(const FigurePlate& plate) {
  std::vector<Told> all;
  if (!plate.labels)
    return all;
  const Lettering lettering = letteringOf(*plate.labels);
  std::size_t next = 0;
  for (const ShownLabel& label : plate.labels->labels)
    if (const PlacedLabel* placed = plate.labels->layout.find(label.item.id)) {
      Told one{.id = label.item.id,
               .text = writtenOf(lettering.items[next++], false),
               .leader = placed->leader,
               .dots = label.item.places,
               .byHand = placed->post == LabelPost::byHand};
      if (one.text.boxes.empty())  // a line to write on
        one.text.boxes.emplace_back(QPointF(placed->box.low.x, placed->box.low.y),
                                    QPointF(placed->box.high.x, placed->box.high.y));
      all.push_back(std::move(one));
    }
  return all;
}

float distanceTo(const glm::vec2& p, const glm::vec2& a, const glm::vec2& b) {
  const glm::vec2 way = b - a;
  const float square = glm::dot(way, way);
  const float part = square > 0.0f ? std::clamp(glm::dot(p - a, way) / square, 0.0f, 1.0f) : 0.0f;
  return glm::distance(p, a + part * way);
}

float distanceTo(const glm::vec2& p, const Leader& leader) {
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t i = 1; i < leader.size(); ++i)
    least = std::min(least, distanceTo(p, leader[i - 1], leader[i]));
  return least;
}

bool through(const Leader& leader, const QRectF& box) {
  constexpr float step = 0.1f;
  for (std::size_t i = 1; i < leader.size(); ++i) {
    const int steps = 1 + int(glm::distance(leader[i - 1], leader[i]) / step);
    for (int k = 0; k <= steps; ++k) {
      const glm::vec2 p = leader[i - 1] + float(k) / float(steps) * (leader[i] - leader[i - 1]);
      if (box.contains(QPointF(p.x, p.y)))
        return true;
    }
  }
  return false;
}

class Proving {
 public:
  Proving(const FigurePlate& plate, const glm::vec2& sizeMm, const Image& bare)
      : m_plate(plate), m_bare(bare), m_scale(float(bare.height) / sizeMm.y) {}

  WritingProof make() {
    const std::vector<Told> told = toldBy(m_plate);
    std::vector<Written> marks;
    for (const LetteringItem& item : m_plate.marks.lettering.items)
      if (item.name != groundName && item.name != frameName)
        marks.push_back(writtenOf(item, true));
    m_proof.marks = marks.size();
    m_proof.labels = told.size();
    for (const Written& mark : marks)
      lieOverAnatomy(mark, FaultKind::overAnatomy);
    for (const Told& label : told) {
      if (label.byHand)
        continue;
      lieOverAnatomy(label.text, FaultKind::labelOver);
      for (const Written& mark : marks)
        runThrough(label, mark);
      for (const Told& other : told)
        if (other.id != label.id)
          meet(label, other);
    }
    return std::move(m_proof);
  }

 private:
  void lieOverAnatomy(const Written& written, FaultKind kind) {
    int pixels = 0;
    for (const QRectF& box : written.boxes)
      for (int y = cell(box.top(), m_bare.height); y <= cell(box.bottom(), m_bare.height); ++y)
        for (int x = cell(box.left(), m_bare.width); x <= cell(box.right(), m_bare.width); ++x)
          pixels += drawn(x, y) ? 1 : 0;
    if (pixels > 0)
      m_proof.faults.push_back({kind, written.name, {}, pixels});
  }

  int cell(double mm, int count) const {
    return std::clamp(int(std::floor(mm * double(m_scale))), 0, count - 1);
  }

  /// Tells whether anatomy is seen there; below what cuts the picture off, and outside a frame,
  /// there is none.
  bool drawn(int x, int y) const {
    const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / m_scale;
    if ((m_plate.marks.cutOff && m_plate.marks.cutOff->contains(p)) ||
        (m_plate.frame && !m_plate.frame->contains(p)))
      return false;
    const std::size_t pixel = std::size_t(y) * std::size_t(m_bare.width) + std::size_t(x);
    return m_bare.rgba[4 * pixel + 3] >= drawnAlpha;
  }

  void runThrough(const Told& label, const Written& other) {
    if (std::any_of(other.boxes.begin(), other.boxes.end(),
                    [&](const QRectF& box) { return through(label.leader, box); }))
      m_proof.faults.push_back({FaultKind::throughText, label.text.name, other.name, 0});
  }

  void meet(const Told& label, const Told& other) {
    runThrough(label, other.text);
    for (const glm::vec2& dot : other.dots)
      if (distanceTo(dot, label.leader) < dotRadius + halfLeader &&
          (label.dots.empty() || glm::distance(dot, label.dots.front()) > apart))
        m_proof.faults.push_back({FaultKind::throughDot, label.text.name, other.text.name, 0});
    if (label.id.value < other.id.value && cross(label.leader, other.leader))
      m_proof.faults.push_back({FaultKind::crossing, label.text.name, other.text.name, 0});
  }

  const FigurePlate& m_plate;
  const Image& m_bare;
  float m_scale;
  WritingProof m_proof;
};

bool alike(const QRectF& a, const QRectF& b) {
  const auto near = [](double x, double y) { return std::abs(x - y) < double(same); };
  return near(a.left(), b.left()) && near(a.top(), b.top()) && near(a.right(), b.right()) &&
         near(a.bottom(), b.bottom());
}

bool alike(const std::vector<glm::vec2>& a, const std::vector<glm::vec2>& b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](const glm::vec2& p, const glm::vec2& q) { return glm::distance(p, q) < same; });
}

/// Adds what only one of the maps has, and what differs.
template <class Key, class Value, class Alike, class Name>
void compare(const std::map<Key, Value>& one, const std::map<Key, Value>& other, const Alike& same,
             const Name& name, std::vector<std::string>& differences) {
  for (const auto& [key, value] : one)
    if (const auto found = other.find(key); found == other.end())
      differences.push_back(name(key, value) + ": in the first alone");
    else if (!same(value, found->second))
      differences.push_back(name(key, value) + ": elsewhere");
  for (const auto& [key, value] : other)
    if (!one.contains(key))
      differences.push_back(name(key, value) + ": in the second alone");
}

std::map<std::string, Written> marksOn(const FigurePlate& plate) {
  std::map<std::string, Written> all;
  for (const LetteringItem& item : plate.marks.lettering.items) {
    std::string name = item.name;
    while (all.contains(name))
      name += '\'';
    all.emplace(name, writtenOf(item, true));
  }
  return all;
}

std::map<std::uint64_t, Told> labelsOn(const FigurePlate& plate) {
  std::map<std::uint64_t, Told> all;
  for (Told& told : toldBy(plate))
    all.emplace(told.id.value, std::move(told));
  return all;
}

}  // namespace

int WritingProof::count(WritingFault::Kind kind) const {
  return int(std::count_if(faults.begin(), faults.end(),
                           [kind](const WritingFault& fault) { return fault.kind == kind; }));
}

int WritingProof::pixels() const {
  int sum = 0;
  for (const WritingFault& fault : faults)
    sum += fault.pixels;
  return sum;
}

WritingProof provedWriting(const FigurePlate& plate, const glm::vec2& sizeMm, const Image& bare) {
  return Proving(plate, sizeMm, bare).make();
}

std::vector<std::string> writtenElsewhere(const FigurePlate& one, const FigurePlate& other) {
  std::vector<std::string> differences;
  const auto sameBoxes = [](const Written& a, const Written& b) {
    return std::equal(a.boxes.begin(), a.boxes.end(), b.boxes.begin(), b.boxes.end(),
                      [](const QRectF& p, const QRectF& q) { return alike(p, q); });
  };
  compare(
      marksOn(one), marksOn(other), sameBoxes,
      [](const std::string& key, const Written&) { return key; }, differences);
  compare(
      labelsOn(one), labelsOn(other),
      [&](const Told& a, const Told& b) {
        return sameBoxes(a.text, b.text) && alike(a.leader, b.leader) && alike(a.dots, b.dots);
      },
      [](std::uint64_t, const Told& told) { return told.text.name; }, differences);
  return differences;
}

}  // namespace sline::render
