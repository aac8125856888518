// SPDX-License-Identifier: Apache-2.0
#include "model/figure/figure_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/base/letters.h"
#include "model/scene/near_names.h"

namespace sline::model {

namespace {

constexpr float slack = 0.01f;  // millimetres

struct Cell {
  std::size_t column = 0;
  std::size_t row = 0;
};

/// Where columns or rows begin and how long they are.
struct Tracks {
  std::vector<float> at;
  std::vector<float> size;

  Tracks(const std::vector<float>& weights, float whole, float gap) {
    const float sum = std::accumulate(weights.begin(), weights.end(), 0.0f);
    const float room = whole - gap * float(weights.size() - 1);
    float next = 0.0f;
    for (const float weight : weights) {
      at.push_back(next);
      size.push_back(room * weight / sum);
      next += size.back() + gap;
    }
  }
  float end(std::size_t last) const { return at[last] + size[last]; }
};

class Layout {
 public:
  explicit Layout(const Figure& figure) : m_figure(figure), m_letters(lettersOf(figure)) {}

  Result<FigureLayout> make(float legendMm) {
    if (m_figure.panels.empty())
      return Error{.where = "panels", .reason = "the figure has no panels", .remedy = "Add one"};
    m_layout.panels.resize(m_figure.panels.size());
    for (const auto step :
         {&Layout::nameLetters, &Layout::link, &Layout::putInOrder, &Layout::fillGrid})
      TRY((this->*step)());
    placeAll(legendMm);
    TRY(checkPlaces());
    return std::move(m_layout);
  }

 private:
  Error fault(std::size_t index, std::string reason, std::string remedy) const {
    return {.where = panelName(m_figure, index),
            .reason = std::move(reason),
            .remedy = std::move(remedy)};
  }

  Status nameLetters() {
    for (std::size_t i = 0; i < m_letters.size(); ++i) {
      const FigurePanel& panel = m_figure.panels[i];
      for (std::size_t before = 0; before < i; ++before)
        if (!m_letters[i].empty() && lowerCase(m_letters[i]) == lowerCase(m_letters[before]))
          return fault(i, "two panels have that letter", "Give one of them another");
      if (m_figure.letters != PanelLetters::none || panel.letter)
        m_layout.panels[i].letter = m_letters[i];
    }
    return Unit{};
  }

  Status linkTo(std::size_t index, const std::string& letter, const char* key) {
    const std::optional<std::size_t> other = panelOfLetter(m_figure, letter);
    if (!other) {
      std::string near = nearNamesText(letter, m_letters);
      return fault(index, std::string(key) + " names panel \"" + letter + "\", which there is not",
                   near.empty() ? "Name the letter of another panel" : near);
    }
    m_layout.panels[index].from = other;
    return Unit{};
  }

  Status link() {
    for (std::size_t i = 0; i < m_figure.panels.size(); ++i) {
      const FigurePanel& panel = m_figure.panels[i];
      const bool likes = panel.camera && !panel.camera->like.empty();
      if (panel.inset && panel.camera)
        return fault(i, "an inset is seen from where its panel is", "Leave \"camera\" out");
      if (panel.inset && !panel.scene.empty())
        return fault(i, "an inset shows the scene of its panel", "Leave \"scene\" out");
      if (likes && panel.camera->fit)
        return fault(i, "a camera is either like another or fits", "Leave \"fit\" out");
      if (panel.camera && panel.camera->centred && !likes)
        return fault(i, "\"centred\" belongs to a camera like another", "Add \"like\"");
      TRY(panel.inset ? linkTo(i, panel.inset->of, "\"of\"")
          : likes     ? linkTo(i, panel.camera->like, "\"like\"")
                      : Status(Unit{}));
    }
    return Unit{};
  }

  /// Puts each panel after the one that it follows.
  Status putInOrder() {
    std::vector<bool> done(m_figure.panels.size());
    for (std::size_t round = 0; round < done.size(); ++round)
      for (std::size_t i = 0; i < done.size(); ++i) {
        const auto& from = m_layout.panels[i].from;
        if (!done[i] && (!from || done[*from])) {
          done[i] = true;
          m_layout.order.push_back(i);
        }
      }
    const auto left = std::find(done.begin(), done.end(), false);
    if (left == done.end())
      return Unit{};
    return fault(std::size_t(left - done.begin()), "its camera leads back to itself",
                 "Let one of the panels have a camera of its own");
  }

  bool inGrid(std::size_t index) const {
    const FigurePanel& panel = m_figure.panels[index];
    return !panel.at && !(panel.inset && panel.inset->inside);
  }

  bool isFree(const Cell& cell, const FigurePanel& panel) const {
    for (std::size_t row = cell.row; row < cell.row + std::size_t(panel.rows); ++row)
      for (std::size_t column = cell.column; column < cell.column + std::size_t(panel.columns);
           ++column)
        if (row < m_taken.size() && m_taken[row][column])
          return false;
    return true;
  }

  /// Gives each panel of the grid the first free cells in reading order.
  Status fillGrid() {
    const std::size_t columns = m_figure.columns.size();
    m_cells.resize(m_figure.panels.size());
    for (std::size_t i = 0; i < m_figure.panels.size(); ++i) {
      const FigurePanel& panel = m_figure.panels[i];
      if (!inGrid(i))
        continue;
      if (std::size_t(panel.columns) > columns)
        return fault(i, "it spans more columns than there are", "Give the grid more columns");
      Cell cell;
      while (cell.column + std::size_t(panel.columns) > columns || !isFree(cell, panel))
        cell = cell.column + 1 < columns ? Cell{cell.column + 1, cell.row} : Cell{0, cell.row + 1};
      const std::size_t end = cell.row + std::size_t(panel.rows);
      const std::size_t most = m_figure.rows.empty() ? 2 * mostPanels : m_figure.rows.size();
      if (end > most)
        return fault(i, "the grid has no room for it",
                     "Give the figure more rows or columns, or the panel a place of its own");
      m_taken.resize(std::max(m_taken.size(), end), std::vector<bool>(columns, false));
      for (std::size_t row = cell.row; row < end; ++row)
        for (int column = 0; column < panel.columns; ++column)
          m_taken[row][cell.column + std::size_t(column)] = true;
      m_cells[i] = cell;
    }
    return Unit{};
  }

  /// Returns the height of the grid where nothing says how high the page is.
  float usualGridHeight(const std::vector<float>& rows) const {
    if (rows.empty())
      return 0.0f;
    constexpr float shape = 0.75f;  // height by width
    const auto count = float(m_figure.columns.size());
    const float column = (m_figure.widthMm - m_figure.gapMm * (count - 1.0f)) / count;
    return shape * column * float(rows.size()) + m_figure.gapMm * float(rows.size() - 1);
  }

  void placeAll(float legendMm) {
    std::vector<float> rows = m_figure.rows;
    rows.resize(std::max(rows.size(), m_taken.size()), 1.0f);
    const float foot = legendMm > 0.0f ? legendMm + m_figure.gapMm : 0.0f;
    float grid = usualGridHeight(rows);
    if (m_figure.heightMm)
      grid = *m_figure.heightMm - foot;
    float bottom = grid;
    if (!rows.empty()) {
      const Tracks across(m_figure.columns, m_figure.widthMm, m_figure.gapMm);
      const Tracks down(rows, grid, m_figure.gapMm);
      for (std::size_t i = 0; i < m_figure.panels.size(); ++i)
        if (inGrid(i))
          placeInGrid(i, across, down);
    }
    for (std::size_t i = 0; i < m_figure.panels.size(); ++i)
      if (const auto& at = m_figure.panels[i].at) {
        m_layout.panels[i].box = *at;
        bottom = std::max(bottom, at->end().y);
      }
    for (const std::size_t i : m_layout.order)
      if (const auto& inset = m_figure.panels[i].inset; inset && inset->inside)
        m_layout.panels[i].box = {
            m_layout.panels[*m_layout.panels[i].from].box.at + inset->inside->at,
            inset->inside->size};
    m_layout.sizeMm = {m_figure.widthMm, m_figure.heightMm.value_or(bottom + foot)};
    m_layout.legend = {{0.0f, m_layout.sizeMm.y - legendMm}, {m_figure.widthMm, legendMm}};
  }

  void placeInGrid(std::size_t index, const Tracks& across, const Tracks& down) {
    const FigurePanel& panel = m_figure.panels[index];
    const Cell& cell = m_cells[index];
    const glm::vec2 at{across.at[cell.column], down.at[cell.row]};
    const glm::vec2 end{across.end(cell.column + std::size_t(panel.columns) - 1),
                        down.end(cell.row + std::size_t(panel.rows) - 1)};
    m_layout.panels[index].box = {at, end - at};
  }

  static bool within(const FigureBox& box, const glm::vec2& size) {
    return box.at.x >= -slack && box.at.y >= -slack && box.end().x <= size.x + slack &&
           box.end().y <= size.y + slack;
  }
  static bool overlapping(const FigureBox& a, const FigureBox& b) {
    return a.at.x + slack < b.end().x && b.at.x + slack < a.end().x && a.at.y + slack < b.end().y &&
           b.at.y + slack < a.end().y;
  }

  /// Tells whether that panel is an inset that lies on the other one.
  bool liesOn(std::size_t index, std::size_t other) const {
    const auto& inset = m_figure.panels[index].inset;
    const FigureBox& box = m_layout.panels[index].box;
    const FigureBox& below = m_layout.panels[other].box;
    return inset && m_layout.panels[index].from == other &&
           within({box.at - below.at, box.size}, below.size);
  }

  Status checkPlaces() const {
    const float legend = m_layout.legend.size.y;
    if (m_layout.sizeMm.y > figureHeightLimits.high + slack)
      return Error{.where = "height",
                   .reason = "the page would be higher than 1500 mm",
                   .remedy = "Take fewer rows, or say how high it is"};
    for (std::size_t i = 0; i < m_layout.panels.size(); ++i) {
      const FigureBox& box = m_layout.panels[i].box;
      if (box.size.x < leastPanelMm - slack || box.size.y < leastPanelMm - slack)
        return fault(i, "it is narrower or lower than 10 mm",
                     "Make the page larger, or take fewer columns or rows");
      if (!within(box, {m_layout.sizeMm.x, m_layout.sizeMm.y - legend}))
        return fault(i, "it reaches over the page's edge or into the legend",
                     "Move it, make it smaller or the page larger");
      TRY(checkAgainstOthers(i));
    }
    return Unit{};
  }

  Status checkAgainstOthers(std::size_t index) const {
    const FigureBox& box = m_layout.panels[index].box;
    const auto& inset = m_figure.panels[index].inset;
    if (inset && !within(inset->part, m_layout.panels[*m_layout.panels[index].from].box.size))
      return fault(index,
                   "the part that it shows reaches over the edge of panel " +
                       m_letters[*m_layout.panels[index].from],
                   "Move the part, or make it smaller");
    if (inset && inset->inside && !liesOn(index, *m_layout.panels[index].from))
      return fault(index, "it reaches over the edge of the panel that it lies on",
                   "Move it, or make it smaller");
    for (std::size_t other = 0; other < index; ++other)
      if (overlapping(box, m_layout.panels[other].box) && !liesOn(index, other) &&
          !liesOn(other, index))
        return fault(index, "it lies over " + panelName(m_figure, other),
                     "Move one of them; only an inset may lie on its own panel");
    return Unit{};
  }

  const Figure& m_figure;
  std::vector<std::string> m_letters;
  FigureLayout m_layout;
  std::vector<Cell> m_cells;
  std::vector<std::vector<bool>> m_taken;  ///< rows of the grid
};

}  // namespace

Result<FigureLayout> layOut(const Figure& figure, float legendMm) {
  return Layout(figure).make(legendMm);
}

Status checkFigure(const Figure& figure) {
  if (figure.blackAndWhite && figure.legend != FigureLegend::none)
    return Error{.where = "legend",
                 .reason = "a legend tells colours, and ink alone has none",
                 .remedy = "Leave one of both out"};
  const Result<FigureLayout> layout = layOut(figure);
  return layout.ok() ? Status(Unit{}) : Status(layout.error());
}

}  // namespace sline::model
