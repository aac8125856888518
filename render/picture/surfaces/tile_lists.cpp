// SPDX-License-Identifier: Apache-2.0
#include "render/picture/surfaces/tile_lists.h"

#include <algorithm>

namespace sline::render {

namespace {

/// Appends a square's list, in as many parts as the edges of its layers' areas cut it into.
class SquareLister {
 public:
  SquareLister(std::span<const ListedLayer> layers, TileLists& lists)
      : m_layers(layers), m_lists(lists) {
    m_packed.reserve(layers.size());
    for (const ListedLayer& layer : layers)
      m_packed.push_back(passes::resolveEntry(layer.layer));
  }

  void add(int column, int row, const PixelRect& square) {
    m_here.clear();
    m_columns = {square.x, square.right()};
    m_rows = {square.y, square.top()};
    for (std::size_t i = 0; i < m_layers.size(); ++i)
      if (m_layers[i].mask->marked(column, row)) {
        m_here.push_back(i);
        cutBy(intersection(m_layers[i].layer.area, square));
      }
    for (std::vector<int>* cuts : {&m_columns, &m_rows}) {
      std::sort(cuts->begin(), cuts->end());
      cuts->erase(std::unique(cuts->begin(), cuts->end()), cuts->end());
    }
    for (std::size_t y = 0; y + 1 < m_rows.size(); ++y)
      for (std::size_t x = 0; x + 1 < m_columns.size(); ++x)
        addPart(
            {m_columns[x], m_rows[y], m_columns[x + 1] - m_columns[x], m_rows[y + 1] - m_rows[y]});
  }

 private:
  void cutBy(const PixelRect& area) {
    if (area.empty())
      return;
    m_columns.insert(m_columns.end(), {area.x, area.right()});
    m_rows.insert(m_rows.end(), {area.y, area.top()});
  }

  void addPart(const PixelRect& part) {
    const std::size_t first = m_lists.entries.size();
    for (const std::size_t i : m_here)
      if (!intersection(m_layers[i].layer.area, part).empty())
        m_lists.entries.push_back(m_packed[i]);
    m_lists.tiles.push_back(passes::resolveTile(part, m_lists.entries, first));
  }

  std::span<const ListedLayer> m_layers;
  TileLists& m_lists;
  std::vector<passes::ResolveEntry> m_packed;
  std::vector<std::size_t> m_here;
  std::vector<int> m_columns;
  std::vector<int> m_rows;
};

}  // namespace

TileLists tileLists(std::span<const ListedLayer> layers, const TileMask& wanted) {
  TileLists lists;
  SquareLister lister(layers, lists);
  for (int row = 0; row < wanted.rows(); ++row)
    for (int column = 0; column < wanted.columns(); ++column) {
      if (!wanted.marked(column, row))
        continue;
      lister.add(column, row, wanted.square(column, row));
    }
  return lists;
}

}  // namespace sline::render
