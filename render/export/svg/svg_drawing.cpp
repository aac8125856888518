// SPDX-License-Identifier: Apache-2.0
#include "render/export/svg/svg_drawing.h"

#include <QByteArray>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "model/scene/known_frame.h"
#include "render/export/encoding/png_image.h"
#include "render/export/encoding/xml_text.h"
#include "render/export/svg/svg_path.h"
#include "render/export/svg/svg_shapes.h"
#include "render/export/svg/svg_values.h"
#include "render/vectors/paper_tile.h"

namespace sline::render {

namespace {

/// Tells where a structure or group of lines stands among its siblings.
struct Branch {
  std::vector<const VectorStructure*> structures;  ///< at or below it
  float depth() const {
    float sum = 0.0f;
    for (const VectorStructure* structure : structures)
      sum += structure->depth;
    return sum / float(std::max<std::size_t>(structures.size(), 1));
  }
};

class DrawingLayers {
 public:
  DrawingLayers(std::string& text, const VectorDrawing& drawing, const model::Scene& scene,
                const SvgDrawingStyle& style)
      : m_text(text),
        m_drawing(drawing),
        m_scene(scene),
        m_prefix(style.prefix),
        m_decimals(style.decimals) {}

  void add() {
    if (std::any_of(m_drawing.structures.begin(), m_drawing.structures.end(),
                    [](const VectorStructure& s) { return s.filled(); }))
      addFills();
    addLines();
  }

 private:
  void open(const std::string& id, std::string_view label, const std::string& more = {}) {
    m_text += "<g id=\"" + id + "\" inkscape:label=\"" + xmlText(label) + "\"" + more + ">\n";
  }
  /// Opens a group with a name that every program knows: "plain" SVG has no labels.
  void openNamed(const std::string& id, model::NodeId node, const std::string& more = {}) {
    open(id, nameOf(node), more);
    m_text += "<title>" + xmlText(nameOf(node)) + "</title>\n";
  }
  void close() { m_text += "</g>\n"; }

  void addPath(const VectorShape& shape, bool regions) {
    // For the edge of a fill one digit less is enough.
    appendShape(m_text, shape, {regions ? m_decimals - 1 : m_decimals, regions});
  }

  std::string nameOf(model::NodeId id) const {
    const model::Node* node = m_scene.find(id);
    return node ? model::markedName(*node) : std::string();
  }

  void addFills() {
    open(m_prefix + "fills", "Fills", " inkscape:groupmode=\"layer\"");
    for (const VectorStructure& structure : m_drawing.structures) {
      if (!structure.filled())
        continue;
      openNamed(m_prefix + "fill-" + std::to_string(structure.id.value), structure.id,
                opacityAttribute(structure.fillOpacity));
      if (structure.tones)
        addTones(*structure.tones, m_prefix + "edge-" + std::to_string(structure.id.value));
      for (const VectorShape& shape : structure.fills)
        addPath(shape, true);
      close();
    }
    close();
  }

  /// Returns the image as an element without its place. The older name of its link is the one that
  /// all programs know.
  static std::string imageElement(const std::string& place, const Image& image) {
    const Result<std::string> png = pngOf(image);
    if (!png.ok())
      return {};  // nothing but the sink can fail, and that is memory
    return "<image " + place + " preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64," +
           QByteArray::fromStdString(*png).toBase64().toStdString() + "\"/>";
  }
  std::string sized(const glm::vec2& sizeMm) const {
    return "width=\"" + number(double(sizeMm.x), 4) + "\" height=\"" + number(double(sizeMm.y), 4) +
           '"';
  }

  /// Returns the attribute of lines that show the paper; the first of a grain brings it.
  std::string paperAttribute(float grain) {
    const int percent = paperPercent(grain);
    if (percent == 0)
      return {};
    const std::string id = m_prefix + "paper-" + std::to_string(percent);
    if (m_papers.insert(percent).second) {
      const PaperTile tile = paperTile(percent, m_drawing.sizeMm.y);
      const std::string side = sized(glm::vec2(tile.sideMm));
      const std::string page = sized(m_drawing.sizeMm);
      m_text += "<pattern id=\"" + id + "-tile\" patternUnits=\"userSpaceOnUse\" " + side + '>' +
                imageElement(side, tile.image) + "</pattern>\n<mask id=\"" + id +
                "\" maskUnits=\"userSpaceOnUse\" x=\"0\" y=\"0\" " + page + "><rect " + page +
                " fill=\"url(#" + id + "-tile)\"/></mask>\n";
    }
    return " mask=\"url(#" + id + ")\"";
  }

  /// Adds tones as an image behind its edge.
  void addTones(const VectorTones& tones, const std::string& edge) {
    m_text += "<clipPath id=\"" + edge + "\"><path clip-rule=\"evenodd\" d=\"" +
              svgPath(tones.edge, m_decimals - 1) + "\"/></clipPath>\n";
    m_text += "<g clip-path=\"url(#" + edge + ")\">" +
              imageElement("x=\"" + number(double(tones.at.x), 4) + "\" y=\"" +
                               number(double(tones.at.y), 4) + "\" " + sized(tones.sizeMm),
                           tones.image) +
              "</g>\n";
  }

  void addLines() {
    for (const VectorStructure& structure : m_drawing.structures) {
      if (std::all_of(structure.lines.begin(), structure.lines.end(),
                      [](const VectorLines& lines) { return plainShapes(lines).empty(); }))
        continue;
      const model::Node* node = m_scene.find(structure.id);
      m_branches[structure.id].structures.push_back(&structure);
      while (node && node->parent != model::rootId) {
        m_branches[node->parent].structures.push_back(&structure);
        node = m_scene.find(node->parent);
      }
    }
    open(m_prefix + "lines", "Lines",
         " inkscape:groupmode=\"layer\" stroke-linecap=\"round\" stroke-linejoin=\"round\"");
    addVeiledLines();
    addBelow(model::rootId);
    close();
  }

  /// Adds what is seen through fills, as no structure's lines lie wholly before another's.
  void addVeiledLines() {
    const std::vector<VeiledLines> veiled = veiledLines(m_drawing);
    if (veiled.empty())
      return;
    open(m_prefix + "veiled", "Behind fills");
    for (std::size_t i = 0; i < veiled.size(); ++i) {
      const VeiledLines& part = veiled[i];
      const auto goesOn = [&part](const VeiledLines& other) {
        return other.structure == part.structure && other.light() == part.light();
      };
      if (i == 0 || !goesOn(veiled[i - 1]))
        openNamed(m_prefix + "veiled-" + std::to_string(int(std::lround(100.0f * part.light()))) +
                      "-" + std::to_string(part.structure->id.value),
                  part.structure->id);
      addShapes(*part.lines, part.shapes, part.structure->grain);
      if (i + 1 == veiled.size() || !goesOn(veiled[i + 1]))
        close();
    }
    close();
  }

  void addShapes(const VectorLines& lines, std::span<const VectorShape> shapes, float grain) {
    const std::string paper = paperAttribute(grain);
    m_text += "<g inkscape:label=\"" + std::string(lines.kind) + "\"" +
              (lines.hidden ? " class=\"hidden\"" : "") + opacityAttribute(lines.opacity) + paper +
              ">\n";
    for (const VectorShape& shape : shapes)
      addPath(shape, false);
    close();
  }

  /// Adds the farthest first, in the tree's order where they are equally far.
  void addBelow(model::NodeId parent) {
    std::vector<model::NodeId> ids = m_scene.children(parent);
    std::erase_if(ids, [this](model::NodeId id) { return !m_branches.contains(id); });
    std::stable_sort(ids.begin(), ids.end(), [this](model::NodeId a, model::NodeId b) {
      return m_branches[a].depth() > m_branches[b].depth();
    });
    for (const model::NodeId id : ids) {
      if (m_scene.find(id)->isGroup()) {
        openNamed(m_prefix + "group-" + std::to_string(id.value), id);
        addBelow(id);
      } else {
        openNamed(m_prefix + "structure-" + std::to_string(id.value), id);
        addStructure(*m_branches[id].structures.front());
      }
      close();
    }
  }

  void addStructure(const VectorStructure& structure) {
    for (const VectorLines& lines : structure.lines)
      if (const auto shapes = plainShapes(lines); !shapes.empty())
        addShapes(lines, shapes, structure.grain);
  }

  std::string& m_text;
  const VectorDrawing& m_drawing;
  const model::Scene& m_scene;
  std::string m_prefix;
  int m_decimals;
  std::set<int> m_papers;  ///< percent: there already
  std::map<model::NodeId, Branch> m_branches;
};

}  // namespace

void appendSvgDrawing(std::string& text, const VectorDrawing& drawing, const model::Scene& scene,
                      const SvgDrawingStyle& style) {
  DrawingLayers(text, drawing, scene, style).add();
}

}  // namespace sline::render
