// SPDX-License-Identifier: Apache-2.0
#include "render/export/plate/marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <iterator>
#include <span>

#include "model/scene/known_frame.h"
#include "model/scene/label_words.h"
#include "render/export/plate/free_places.h"
#include "render/export/plate/gamma_key.h"
#include "render/export/plate/legend.h"
#include "render/export/plate/legend_row.h"
#include "render/export/plate/mark_text.h"
#include "render/export/plate/side_letters.h"
#include "render/export/plate/source_credits.h"
#include "render/labels/orientation_letters.h"
#include "render/lettering/caption.h"
#include "render/lettering/label_texts.h"
#include "render/lettering/mark_words.h"
#include "render/lettering/scale_length.h"

namespace sline::render {

namespace {

// Millimetres of the output.
constexpr float margin = markMargin;
constexpr float gap = 1.5f;  // between marks, and to labels
constexpr float widestBar = 40.0f;

// Shares of the labels' size.
constexpr float letterSize = 1.1f;
constexpr float nameSize = 1.0f;
constexpr float smallSize = legendShare;

constexpr std::size_t mostSectionLines = 3;

// Ways that marks may be moved where anatomy lies in their place.
constexpr std::array<glm::vec2, 1> upAndDown{glm::vec2{0.0f, 1.0f}};
constexpr std::array<glm::vec2, 1> sideways{glm::vec2{1.0f, 0.0f}};
constexpr std::array<glm::vec2, 2> sidewaysElseUp{glm::vec2{1.0f, 0.0f}, glm::vec2{0.0f, 1.0f}};
using Ways = std::span<const glm::vec2>;

class MarkLayout {
 public:
  /// `cut`: the picture ends there, millimetres from its upper edge.
  MarkLayout(const ExportOrder& order, const SeenArea* drawn, std::optional<float> cut)
      : m_order(order),
        m_drawn(drawn),
        m_cut(cut),
        m_size(order.page.sizeMm),
        m_colours(letteringColours(order.environment.background)),
        m_sides(knownSides(order.scene)),
        m_words(order.labels.language, m_sides),
        m_unit(drawnUnit(order.scene)),
        m_places(m_size, order.labels.reserved, drawn) {
    m_marks.lettering.ground = m_colours.ground;
    m_marks.lettering.clear = m_colours.clear;
  }

  Marks make() {
    if (m_order.sourcesInPicture())
      addSources();
    if (m_order.marks.sides && m_sides.any)
      addSides();
    else if (m_order.marks.sides && m_unit != model::DrawnUnit::angstrom)
      addNote(m_marks.notes, {.kind = ExportNote::Kind::sidesUnknown, .names = {}, .detail = {}});
    addUpperLeft();
    if (m_order.marks.gammaKey)
      addGammaKeys();
    if (m_order.marks.scaleBar)
      addScaleBar();
    if (m_order.legendInPicture())
      addLegend();
    if (m_order.marks.words)
      addCaption();
    if (m_cut)
      cutOff();
    m_marks.edges.bottom += m_marks.foot;
    return std::move(m_marks);
  }

 private:
  float points(float size) const { return size * m_order.labels.points; }
  float letterCap() const { return capHeightMm(points(letterSize)); }

  /// Keeps the box for what was put there.
  void take(const LabelBox& box) {
    // Words that stand side by side would read as one.
    m_places.take({box.low - glm::vec2(gap, 0.0f), box.high + glm::vec2(gap, 0.0f)});
    m_marks.boxes.push_back(box.grown(gap));
  }

  /// Adds the item, moved as far as anatomy makes it move, so that it has that room; returns its
  /// box, or adds nothing where there is no room for it.
  std::optional<LabelBox> add(LetteringItem item, const LabelBox& box, Ways ways,
                              const std::optional<LabelBox>& room = {}) {
    const std::optional<glm::vec2> by = m_places.shift(room.value_or(box), ways);
    if (!by) {
      addNote(m_marks.notes, {.kind = ExportNote::Kind::marksWithoutRoom,
                              .names = {std::move(item.name)},
                              .detail = {}});
      return std::nullopt;
    }
    const LabelBox there{box.low + *by, box.high + *by};
    take(there);
    m_marks.lettering.items.push_back(movedBy(std::move(item), *by));
    return there;
  }

  LetteringText text(const QString& line, const glm::vec2& at, float size,
                     TextAnchor anchor) const {
    return {.lines = {line},
            .at = at,
            .leading = 0.0f,
            .points = points(size),
            .anchor = anchor,
            .ink = m_colours.ink};
  }

  /// Adds the letter of an edge; where it cannot stay, further along that.
  std::optional<LabelBox> addLetter(const EdgeLetter& letter, Ways ways) {
    if (letter.letters.empty())
      return std::nullopt;
    const LetteringText words =
        text(QString::fromStdString(letter.letters), letter.at, letterSize, letter.anchor);
    return add({.name = "side " + letter.letters, .shapes = {}, .text = words}, boxOf(words), ways,
               roomOf(letter, points(letterSize)));
  }

  void addSides() {
    const EdgeLetters letters = edgeLetters(m_order.camera, m_sides);
    EdgeRoom& edges = m_marks.edges;
    const AxisLetters across = lettersAcross(letters, m_size, points(letterSize), m_places);
    if (const auto box = addLetter(across[0], Ways(upAndDown)))
      edges.left = box->high.x + gap;
    if (const auto box = addLetter(across[1], Ways(upAndDown)))
      edges.right = m_size.x - box->low.x + gap;
    const AxisLetters upright = lettersUpright(letters, m_size, points(letterSize), m_places);
    m_top = addLetter(upright[0], Ways(sideways));
    m_bottom = addLetter(upright[1], Ways(sideways));
    if (m_top)
      edges.top = margin + letterCap() + gap;
    if (m_bottom)
      edges.bottom = margin + letterCap() + gap;
  }

  /// Notes that of the text only a part is written.
  void noteShortened(const QString& whole) {
    addNote(
        m_marks.notes,
        {.kind = ExportNote::Kind::textShortened, .names = {whole.toStdString()}, .detail = {}});
  }

  /// Returns where a line between those heights begins, beside what is reserved at the left.
  float leftEnd(float top, float bottom) const {
    float left = margin;
    for (const LabelBox& box : m_order.labels.reserved)
      if (box.low.x <= margin && box.low.y < bottom && box.high.y > top)
        left = std::max(left, box.high.x + gap);
    return left;
  }

  /// Adds lines from the upper left corner downwards; the first stands beside the letter if it fits
  /// there.
  void addUpperLeft() {
    float above = 0.0f;  // the lowest point of the line before
    const auto addLine = [&](const std::string& name, const QString& line, float size) {
      const float em = points(size) * millimetresPerPoint;
      const float cap = capHeightMm(points(size));
      const float besideLetter =
          m_top ? m_top->low.x - 3.0f * gap - margin : m_size.x - 2.0f * margin;
      float baseline = above > 0.0f ? above + 1.35f * em : margin + std::max(letterCap(), cap);
      if (above <= 0.0f && m_top && textWidthMm(line, points(size)) > besideLetter)
        baseline += letterCap() + gap;
      const float left = leftEnd(baseline - cap, baseline);
      const QString fitted = elidedTo(line, points(size), m_size.x - margin - left);
      if (fitted != line)
        noteShortened(line);
      const LetteringText one = text(fitted, {left, baseline}, size, TextAnchor::start);
      if (add({.name = name, .shapes = {}, .text = one}, boxOf(one), sideways)) {
        above = baseline;
        m_marks.edges.top = std::max(m_marks.edges.top, baseline + gap);
      }
    };
    if (const QString view = viewTitle(); m_order.marks.viewName && !view.isEmpty())
      addLine("view", view, nameSize);
    if (!m_order.marks.sectionState)
      return;
    const std::vector<const model::Section*> sections = sectionsSeen(m_order.scene);
    if (sections.size() > mostSectionLines)
      addLine("sections", m_words.sections(sections.size()), smallSize);
    else
      for (std::size_t i = 0; i < sections.size(); ++i)
        addLine("section " + std::to_string(i + 1), sectionText(*sections[i]), smallSize);
  }

  /// Returns the title that the saved view has in the picture's language.
  const std::string& ownTitle() const {
    return m_order.words.title.in(model::firstLanguage(m_order.labels.language));
  }

  /// Returns what stands in the upper left corner: nothing where the caption has the title, and no
  /// side of what has none.
  QString viewTitle() const {
    if (ownTitle().empty()) {
      const bool side =
          model::anatomicalViewNamed(model::normalisedName(m_order.viewName)).has_value();
      return side && !m_sides.any ? QString() : m_words.view(m_order.viewName, m_order.camera);
    }
    return m_order.marks.words ? QString() : QString::fromStdString(ownTitle()).simplified();
  }

  /// Returns the text of a section; one that does not cut everything names what it cuts.
  QString sectionText(const model::Section& section) const {
    const QString line = m_words.section(section.plane, m_unit);
    const model::Node* scope = m_order.scene.find(section.scope);
    return scope ? QString::fromStdString(scope->name).simplified() + QStringLiteral(": ") + line
                 : line;
  }

  /// A scale bar in its usual place, the lower left corner.
  struct ScaleBar {
    LetteringItem item;
    LabelBox box;
    float baseline = 0.0f;
  };
  /// Returns the bar no longer than that, true at the place; nothing where there is no scale.
  std::optional<ScaleBar> scaleBarWithin(float most, const ScalePlace& place) const {
    const auto length = scaleLength(m_order.camera, place.at, double(m_size.y), double(most));
    if (!length)
      return std::nullopt;
    const QString plain = lengthText(
        length->millimetres, m_words.locale(),
        m_order.of<SharedScale>().doubted ? model::DrawnUnit::doubtedMillimetre : m_unit);
    const bool perspective = m_order.camera.projection == model::Projection::perspective;
    const QString line = !perspective      ? plain
                         : place.onCutFace ? m_words.atCutFace(plain)
                                           : m_words.atMidDepth(plain);
    const float bar = float(length->drawn);
    float baseline = m_size.y - margin;
    const float end = margin + bar + gap + textWidthMm(line, points(smallSize));
    if (m_bottom && end > m_bottom->low.x - 3.0f * gap)
      baseline -= letterCap() + gap;
    const LetteringText words =
        text(line, {margin + bar + gap, baseline}, smallSize, TextAnchor::start);
    LetteringItem item{.name = "scale", .shapes = {}, .text = words};
    item.shapes.push_back(scaleBarShape({margin, baseline}, bar, m_colours.ink));
    LabelBox box = boxOf(words);
    box.low.x = margin - 0.5f * scaleBarPen;
    return ScaleBar{std::move(item), box, baseline};
  }

  /// Adds the scale bar for where the scene has it (ScalePlaces); elsewhere a perspective picture
  /// has another scale. Where anatomy leaves too little room in the usual place a shorter
  /// one stands there; where that has none either, the bar goes elsewhere.
  void addScaleBar() {
    const std::optional<ScalePlace> place = scalePlaces(m_order.scene).in(m_order.camera);
    if (!place)
      return;
    std::optional<ScaleBar> chosen;
    for (const float share : {1.0f, 0.6f, 0.35f}) {
      std::optional<ScaleBar> bar =
          scaleBarWithin(share * std::min(widestBar, 0.22f * m_size.x), *place);
      const bool free = bar && m_places.free(bar->box);
      if (!chosen || free)
        chosen = std::move(bar);
      if (!chosen || free)
        break;
    }
    if (!chosen)
      return;
    const float high = m_size.y - chosen->baseline + capHeightMm(points(smallSize)) + gap;
    if (add(std::move(chosen->item), chosen->box, sidewaysElseUp))
      m_marks.edges.bottom = std::max(m_marks.edges.bottom, high);
  }

  /// Says that the picture must end there, so that what is written below has room.
  void cutFrom(float y) { m_cut = std::min(m_cut.value_or(y), y); }
  void cutOff();
  void addSources();
  void addGammaKeys();
  void addCaption();
  void addLegend();

  const ExportOrder& m_order;
  const SeenArea* m_drawn;
  std::optional<float> m_cut;
  glm::vec2 m_size;
  LetteringColours m_colours;
  model::KnownSides m_sides;
  MarkWords m_words;
  model::DrawnUnit m_unit;
  Marks m_marks;
  FreePlaces m_places;
  std::optional<LabelBox> m_top;
  std::optional<LabelBox> m_bottom;
};

/// Covers what is below the cut with ground.
void MarkLayout::cutOff() {
  const glm::vec2& page = m_order.page.sizeMm;
  cutOffAt(m_marks, {{0.0f, *m_cut}, page});
  addNote(m_marks.notes, {.kind = ExportNote::Kind::footCutOff,
                          .names = {},
                          .detail = std::to_string(std::lround(page.y - *m_cut))});
}

/// Adds whose work the surfaces are at the very foot, whole, and leaves that out of the page that
/// other marks have; where it would take more than half of the page, the rest is noted.
void MarkLayout::addSources() {
  const QString whole = QString::fromStdString(sourcesInOne(m_order.scene)).simplified();
  if (whole.isEmpty())
    return;
  const FootText foot = footText(whole, points(1.0f), {m_size.x - 2.0f * margin, m_size.y});
  if (foot.shortened)
    noteShortened(whole);
  LetteringText one = text({}, {margin, m_size.y - margin - foot.below()}, 1.0f, TextAnchor::start);
  one.points = foot.points;
  one.lines.assign(foot.lines.begin(), foot.lines.end());
  one.leading = foot.lineHeight;
  LabelBox box = boxOf(one);
  for (const TextLine& line : one.lines)
    box.high.x = std::max(box.high.x, margin + textWidthMm(line, one.points));
  box.high.y += foot.below();
  // Whose work it is stands at the foot whatever lies there: a licence asks for it.
  if (m_drawn && m_drawn->anyIn(box.grown(0.5f * gap)))
    cutFrom(box.low.y - 0.5f * gap);
  m_marks.lettering.items.push_back({.name = "sources", .shapes = {}, .text = one});
  take(box);
  m_marks.foot = capHeightMm(foot.points) + foot.below() + gap;
  m_size.y -= m_marks.foot;
  m_places.setPage(m_size);
}

/// Adds keys in the upper right corner, one below the other.
void MarkLayout::addGammaKeys() {
  constexpr float widest = 0.3f;  // of the page's width
  const GammaKeyStyle style{
      .points = points(smallSize), .width = widest * m_size.x, .colours = m_colours};
  float top = margin;
  for (GammaKey key : gammaKeys(m_order, m_words)) {
    key.title = elidedTo(key.title, points(smallSize), 1.5f * widest * m_size.x);
    if (key.title != key.fullTitle)
      noteShortened(key.fullTitle);
    const glm::vec2 size = gammaKeySize(key, style);
    glm::vec2 corner{m_size.x - margin - size.x, top};
    const std::optional<glm::vec2> by = m_places.shift(
        {corner, corner + size}, std::array{glm::vec2{0.0f, 1.0f}, glm::vec2{1.0f, 0.0f}});
    if (by)
      corner += *by;
    std::vector<LetteringItem> items = drawnGammaKey(key, corner, style, m_words);
    if (!add(std::move(items.front()), {corner, corner + size}, {}))
      continue;
    std::move(items.begin() + 1, items.end(), std::back_inserter(m_marks.lettering.items));
    top += size.y + gap;
  }
}

/// Adds swatches and names in the lower right corner, in columns no higher than to the letter at
/// the picture's right side and no wider than to that at its foot. What finds no room is left out.
void MarkLayout::addLegend() {
  const auto structures = legendStructures(m_order.scene, m_order.legend);
  if (structures.empty())
    addNote(m_marks.notes, {.kind = ExportNote::Kind::legendEmpty, .names = {}, .detail = {}});
  constexpr float widestName = 0.27f;  // of the page's width
  constexpr float widestLegend = 0.46f;
  const LegendMeasure measure(points(smallSize));
  std::vector<QString> names;
  std::vector<QString> shortened;
  float width = 0.0f;
  for (const model::Node* node : structures) {
    const QString whole =
        QString::fromStdString(structureName(*node, m_order.labels.language)).simplified();
    names.push_back(elidedTo(whole, points(smallSize), widestName * m_size.x));
    if (names.back() != whole)
      shortened.push_back(whole);
    width = std::max(width, measure.indent + textWidthMm(names.back(), points(smallSize)));
  }
  const float height = 0.5f * (m_size.y - letterCap()) - margin - 2.0f * gap;
  const auto rows = std::size_t(std::max(0.0f, height / measure.row));
  const auto columns =
      std::size_t((widestLegend * m_size.x + measure.between) / (width + measure.between));
  const std::size_t shown = std::min(structures.size(), rows * columns);
  ExportNote left{.kind = ExportNote::Kind::legendWithoutRoom, .names = {}, .detail = {}};
  for (std::size_t i = shown; i < names.size(); ++i)
    left.names.push_back(names[i].toStdString());
  if (!left.names.empty())
    addNote(m_marks.notes, std::move(left));
  if (shown == 0)
    return;
  const std::size_t across = (shown + rows - 1) / rows;
  const std::size_t down = (shown + across - 1) / across;
  const glm::vec2 size{float(across) * (width + measure.between) - measure.between,
                       float(down) * measure.row};
  const std::optional<glm::vec2> corner = m_places.corner(size);
  if (!corner) {
    addNote(m_marks.notes,
            {.kind = ExportNote::Kind::marksWithoutRoom, .names = {"legend"}, .detail = {}});
    return;
  }
  for (std::size_t i = 0; i < shown; ++i) {
    const std::size_t column = i / down;
    m_marks.lettering.items.push_back(legendRow(
        {.name = structures[i]->name,
         .text = names[i],
         .colour = m_order.scene.resolve(structures[i]->id).colour},
        *corner +
            glm::vec2(float(column) * (width + measure.between), float(i % down + 1) * measure.row),
        points(smallSize), m_colours));
  }
  for (const QString& name : shortened)
    noteShortened(name);
  take({*corner, *corner + size});
  m_marks.legend = m_marks.boxes.back();
}

/// Adds what the view says, in the middle above the marks at the foot, left of the legend. Where
/// anatomy leaves it no room there, nor above, it stands in a corner, and if need be in a narrower
/// box.
void MarkLayout::addCaption() {
  const std::string& text = m_order.words.text.in(model::firstLanguage(m_order.labels.language));
  const std::string markup = captionMarkup(ownTitle(), text);
  if (QString::fromStdString(markup).trimmed().isEmpty())
    return;
  constexpr float tallest = 0.4f;  // of the page's height
  constexpr float beside = 0.6f;   // of it, in a corner
  const float right = m_marks.legend ? m_marks.legend->low.x : m_size.x - margin;
  LabelStyle style = m_order.labels;
  style.ground = m_order.environment.background;
  const auto set = [&](float width, float height) {
    return captionOf(markup, style,
                     {.middle = 0.5f * (margin + right),
                      .foot = m_size.y - std::max(m_marks.edges.bottom, margin),
                      .width = std::min(width * m_size.x, right - margin),
                      .height = height * m_size.y});
  };
  std::optional<Caption> caption = set(captionShare, tallest);
  if (!caption) {
    addNote(m_marks.notes,
            {.kind = ExportNote::Kind::marksWithoutRoom, .names = {"caption"}, .detail = {}});
    return;
  }
  std::optional<glm::vec2> free = m_places.shift(caption->box, upAndDown);
  const float narrowest = 7.0f * points(1.0f) * millimetresPerPoint;
  for (const float width : {captionShare, 0.5f, 0.36f, 0.25f, 0.17f}) {
    if (free || !m_drawn || width * m_size.x < narrowest)
      break;
    const std::optional<Caption> other = set(width, beside);
    if (!other || (other->shortened && !caption->shortened))
      continue;
    if (const std::optional<glm::vec2> corner = m_places.corner(other->box.size())) {
      free = *corner - other->box.low;
      caption = other;
    }
  }
  if (caption->shortened)
    noteShortened(plainText(caption->item.text->lines.front()));
  // What the view says is never lost: where anatomy leaves it no room the picture ends above it.
  const glm::vec2 by = free.value_or(glm::vec2(0.0f));
  if (!free && m_drawn)
    cutFrom(caption->box.low.y - gap);
  take({caption->box.low + by, caption->box.high + by});
  m_marks.lettering.items.push_back(movedBy(caption->item, by));
  m_marks.caption = m_marks.boxes.back();
  if (by == glm::vec2(0.0f))
    m_marks.edges.bottom = std::max(m_marks.edges.bottom, m_size.y - caption->box.low.y + gap);
}

}  // namespace

Marks marksOf(const ExportOrder& order, const SeenArea* drawn) {
  Marks marks = MarkLayout(order, drawn, {}).make();
  // Below the cut there is no anatomy that marks must keep off, and they may stand there, too.
  for (int round = 0; marks.cutOff && round < 3; ++round) {
    const float cut = marks.cutOff->low.y;
    const SeenArea left = areaAbove(*drawn, cut);
    marks = MarkLayout(order, &left, cut).make();
    if (marks.cutOff->low.y >= cut)
      break;
  }
  return marks;
}

void paintMarks(QPainter& painter, const Marks& marks) {
  paintLettering(painter, marks.lettering);
}

}  // namespace sline::render
