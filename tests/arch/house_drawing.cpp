// SPDX-License-Identifier: Apache-2.0
#include "tests/arch/house_drawing.h"

#include <algorithm>
#include <array>
#include <functional>
#include <sstream>

namespace sline::arch {

namespace {

using Boxes = std::map<std::string, std::set<std::string>>;  // whom each includes

struct Layer {
  const char* name;
  const char* paper;
  const char* ink;
};
constexpr std::array<Layer, 4> layers{{{"app", "#f3f0ec", "#6b5d4f"},
                                       {"widgets", "#eaf1f8", "#2f6296"},
                                       {"render", "#eef6ec", "#3c7a34"},
                                       {"model", "#fbf0ec", "#a4492c"}}};
constexpr int width = 1280;
constexpr int rowHeight = 62;
constexpr int boxHeight = 30;
constexpr int gap = 14;
constexpr int margin = 96;

std::string boxOf(const std::string& room) {
  for (const char* whole :
       {"app/cli", "model/demo", "model/import", "render/export", "render/passes"})
    if (isUnder(room, whole))
      return whole;
  return room;
}

std::string layerOfBox(const std::string& box) {
  return box.substr(0, box.find('/'));
}

std::string nameOf(const std::string& box) {
  return box.substr(box.find('/') + 1);
}

Boxes boxesOf(const House& house) {
  Boxes boxes;
  for (const auto& [name, room] : house.rooms) {
    std::set<std::string>& uses = boxes[boxOf(name)];
    for (const std::string& other : room.mayUse)
      if (boxOf(other) != boxOf(name))
        uses.insert(boxOf(other));
    if (room.wholeLayers.contains(layerOfBox(name)))
      for (const auto& [other, its] : house.rooms)
        if (layerOfBox(other) == layerOfBox(name) && boxOf(other) != boxOf(name))
          uses.insert(boxOf(other));
  }
  return boxes;
}

bool leadsTo(const Boxes& boxes, const std::string& from, const std::string& to) {
  std::set<std::string> seen{from};
  std::vector<std::string> open{from};
  while (!open.empty()) {
    const std::string at = open.back();
    open.pop_back();
    if (at == to)
      return true;
    for (const std::string& next : boxes.at(at))
      if (boxes.contains(next) && seen.insert(next).second)
        open.push_back(next);
  }
  return false;
}

/// Without the arrows that a longer way says, too.
Boxes reduced(const Boxes& boxes) {
  Boxes least = boxes;
  for (const auto& [box, uses] : boxes)
    for (const std::string& used : uses)
      for (const std::string& other : uses)
        if (other != used && leadsTo(boxes, other, used) && !leadsTo(boxes, used, other))
          least[box].erase(used);
  return least;
}

/// How many rooms of its own layer stand below it.
std::map<std::string, int> heightsOf(const Boxes& boxes) {
  std::map<std::string, int> heights;
  const std::function<int(const std::string&)> height = [&](const std::string& box) {
    if (const auto known = heights.find(box); known != heights.end())
      return known->second;
    heights[box] = 0;  // where rooms go round in a circle the first stands lowest
    int most = -1;
    for (const std::string& used : boxes.at(box))
      if (boxes.contains(used) && layerOfBox(used) == layerOfBox(box))
        most = std::max(most, height(used));
    return heights[box] = most + 1;
  };
  for (const auto& [box, uses] : boxes)
    height(box);
  return heights;
}

struct Place {
  double x = 0.0;  ///< of the middle
  double y = 0.0;  ///< of the upper edge
  double wide = 0.0;
};

class Drawing {
 public:
  explicit Drawing(const House& house) : m_boxes(boxesOf(house)), m_arrows(reduced(m_boxes)) {
    place();
  }

  std::string text() {
    for (const auto& [box, uses] : m_arrows)
      for (const std::string& used : uses)
        if (m_places.contains(used))
          arrow(m_places.at(box), m_places.at(used), inkOf(used));
    for (const auto& [box, place] : m_places)
      room(box, place);
    std::ostringstream all;
    all << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " << width << ' ' << m_bottom
        << "\" font-family=\"sans-serif\" font-size=\"14\">\n"
        << m_bands.str() << m_lines.str() << m_rooms.str() << "</svg>\n";
    return all.str();
  }

 private:
  static const char* inkOf(const std::string& box) {
    const auto layer = std::find_if(layers.begin(), layers.end(), [&](const Layer& each) {
      return layerOfBox(box) == each.name;
    });
    return layer == layers.end() ? "#000000" : layer->ink;
  }

  void place() {
    const std::map<std::string, int> heights = heightsOf(m_boxes);
    for (const Layer& layer : layers) {
      std::map<int, std::vector<std::string>, std::greater<>> rows;
      for (const auto& [box, uses] : m_boxes)
        if (layerOfBox(box) == layer.name)
          rows[heights.at(box)].push_back(box);
      const int top = m_bottom;
      m_bottom += gap;
      for (auto& [height, row] : rows)
        placeRow(row);
      m_bands << "<rect x=\"0\" y=\"" << top << "\" width=\"" << width << "\" height=\""
              << m_bottom - top << "\" fill=\"" << layer.paper << "\"/>\n<text x=\"14\" y=\""
              << top + 30 << "\" font-size=\"18\" fill=\"" << layer.ink << "\">" << layer.name
              << "</text>\n";
      m_bottom += gap;
    }
  }

  /// Below the middle of those that include them, in that order.
  void placeRow(std::vector<std::string>& row) {
    std::map<std::string, double> wish;
    double total = -double(gap);
    for (const std::string& box : row) {
      double sum = 0.0;
      int users = 0;
      for (const auto& [other, place] : m_places)
        if (m_arrows.at(other).contains(box)) {
          sum += place.x;
          ++users;
        }
      wish[box] = users > 0 ? sum / users : 0.5 * width;
      total += wideOf(box) + gap;
    }
    std::stable_sort(row.begin(), row.end(),
                     [&](const std::string& a, const std::string& b) { return wish[a] < wish[b]; });
    const double step = std::max(0.0, width - 2 * margin - total) / double(row.size() + 1);
    double x = margin + step;
    for (const std::string& box : row) {
      const double wide = wideOf(box);
      m_places[box] = {x + 0.5 * wide, double(m_bottom), wide};
      x += step + wide + gap;
    }
    m_bottom += rowHeight;
  }

  static double wideOf(const std::string& box) { return 8.0 * double(nameOf(box).size()) + 20.0; }

  void arrow(const Place& from, const Place& to, const char* ink) {
    const double y0 = from.y + boxHeight;
    const double bend = 0.5 * std::max(40.0, to.y - y0);
    m_lines << "<path d=\"M" << from.x << ' ' << y0 << " C" << from.x << ' ' << y0 + bend << ' '
            << to.x << ' ' << to.y - bend << ' ' << to.x << ' ' << to.y
            << "\" fill=\"none\" stroke=\"" << ink << "\" stroke-opacity=\"0.45\"/>\n<circle cx=\""
            << to.x << "\" cy=\"" << to.y << "\" r=\"2.5\" fill=\"" << ink << "\"/>\n";
  }

  void room(const std::string& box, const Place& place) {
    m_rooms << "<rect x=\"" << place.x - 0.5 * place.wide << "\" y=\"" << place.y << "\" width=\""
            << place.wide << "\" height=\"" << boxHeight << "\" rx=\"4\" fill=\"#ffffff\" stroke=\""
            << inkOf(box) << "\"/>\n<text x=\"" << place.x << "\" y=\"" << place.y + 20
            << "\" text-anchor=\"middle\">" << nameOf(box) << "</text>\n";
  }

  Boxes m_boxes;
  Boxes m_arrows;
  std::map<std::string, Place> m_places;
  int m_bottom = 0;
  std::ostringstream m_bands;
  std::ostringstream m_lines;
  std::ostringstream m_rooms;
};

}  // namespace

std::string drawingOf(const House& house) {
  return Drawing(house).text();
}

}  // namespace sline::arch
