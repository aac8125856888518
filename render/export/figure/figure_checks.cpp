// SPDX-License-Identifier: Apache-2.0
#include "render/export/figure/figure_checks.h"

#include <cmath>
#include <limits>
#include <string>

#include "render/export/figure/line_weights.h"

namespace sline::render {

namespace {

constexpr float slackPoints = 0.005f;

std::string pointsText(float points) {
  std::string text = std::to_string(std::round(100.0f * points) / 100.0f);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.'))
    text.pop_back();
  return text;
}

class Checks {
 public:
  explicit Checks(const ComposedFigure& figure) : m_figure(figure), m_limits(figure.plan.figure) {}

  std::vector<Error> make() {
    for (std::size_t i = 0; i < m_figure.panels.size(); ++i) {
      m_where = model::panelName(m_limits, i);
      const ComposedPanel& panel = m_figure.panels[i];
      Lettering all = panel.plate.marks.lettering;
      if (panel.plate.labels) {
        const Lettering labels = letteringOf(*panel.plate.labels);
        all.items.insert(all.items.end(), labels.items.begin(), labels.items.end());
      }
      checkLetters(all);
      checkPens(all);
      if (m_limits.thinLines == model::ThinLines::refused)
        checkLines(i);
    }
    m_where = "letters and legend";
    checkLetters(m_figure.writing);
    checkPens(m_figure.writing);
    checkPens(m_figure.frames);
    return std::move(m_faults);
  }

 private:
  void refuse(std::string reason, std::string remedy) {
    m_faults.push_back(
        {.where = m_where, .reason = std::move(reason), .remedy = std::move(remedy)});
  }

  void checkLetters(const Lettering& lettering) {
    const LetteringText* smallest = nullptr;
    for (const LetteringItem& item : lettering.items)
      if (item.text && (!smallest || item.text->points < smallest->points))
        smallest = &*item.text;
    if (!smallest || smallest->points >= m_limits.leastPoints - slackPoints)
      return;
    const std::string size = pointsText(smallest->points);
    refuse(
        "\"" + plainText(smallest->lines).toStdString() + "\" is set in " + size +
            " pt, and letters smaller than " + pointsText(m_limits.leastPoints) + " pt are refused",
        "Make \"points\" " + pointsText(m_limits.points * m_limits.leastPoints / smallest->points) +
            " or more, or \"least_points\" " + size);
  }

  void checkPens(const Lettering& lettering) {
    float thinnest = std::numeric_limits<float>::infinity();
    std::string what;
    for (const LetteringItem& item : lettering.items)
      for (const LetteringShape& shape : item.shapes)
        if (shape.pen > 0.0f && shape.pen < thinnest) {
          thinnest = shape.pen;
          what = "The lines of \"" + item.name + "\" are";
        }
    refuseThin(thinnest, what, {});
  }

  void checkLines(std::size_t index) {
    float thinnest = std::numeric_limits<float>::infinity();
    std::string what;
    for (const VectorStructure& structure : m_figure.panels[index].drawing.structures)
      for (const VectorLines& lines : structure.lines) {
        const float width = usualWidthMm(lines);
        if (isTone(lines) || width >= thinnest)
          continue;
        thinnest = width;
        const model::Node* node = m_figure.plan.panels[index].scene.find(structure.id);
        what = std::string(lines.kind) + " of \"" + (node ? node->name : std::string()) + "\" are";
      }
    refuseThin(thinnest, what, "\"thin_lines\": \"raised\" or ");
  }

  void refuseThin(float widthMm, const std::string& what, const std::string& remedy) {
    if (widthMm / millimetresPerPoint >= m_limits.leastLine - slackPoints)
      return;
    const std::string points = pointsText(widthMm / millimetresPerPoint);
    refuse(what + " drawn with " + points + " pt, and lines thinner than " +
               pointsText(m_limits.leastLine) + " pt are refused",
           "Take " + remedy + "\"least_line\": " + points);
  }

  const ComposedFigure& m_figure;
  const model::Figure& m_limits;
  std::string m_where;
  std::vector<Error> m_faults;
};

}  // namespace

std::vector<Error> printFaults(const ComposedFigure& figure) {
  return Checks(figure).make();
}

}  // namespace sline::render
