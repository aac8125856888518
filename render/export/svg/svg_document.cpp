// SPDX-License-Identifier: Apache-2.0
#include "render/export/svg/svg_document.h"

#include <QByteArray>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "model/base/colour_text.h"
#include "render/export/encoding/png_image.h"
#include "render/export/encoding/xml_text.h"
#include "render/export/svg/svg_lettering.h"
#include "render/export/svg/svg_path.h"
#include "render/export/svg/svg_shapes.h"
#include "render/export/svg/svg_values.h"

namespace sline::render {

namespace {

constexpr const char* svgTitleId = "picture-title";
constexpr const char* svgDescriptionId = "picture-description";
/// What a document says of itself that has a title and a description.
const std::string svgDescribed = std::string(" role=\"img\" aria-labelledby=\"") + svgTitleId +
                                 "\" aria-describedby=\"" + svgDescriptionId + "\"";

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

class Document {
 public:
  Document(const VectorDrawing& drawing, const model::Scene& scene,
           std::span<const SvgWriting> writings, const ExportCredit& credit)
      : m_drawing(drawing),
        m_scene(scene),
        m_writings(writings),
        m_credit(credit),
        // Steps are a fortieth of λ or less.
        m_decimals(
            std::clamp(int(std::ceil(-std::log10(drawing.sizeMm.y / 720.0f / 40.0f))), 2, 4)) {}

  std::string make() {
    const std::string width = number(double(m_drawing.sizeMm.x), 4);
    const std::string height = number(double(m_drawing.sizeMm.y), 4);
    m_text = svgStart(width, height, m_credit.description.empty() ? std::string() : svgDescribed);
    addDescription();
    addCredit();
    if (m_drawing.background)
      m_text += "<rect id=\"background\" width=\"" + width + "\" height=\"" + height +
                "\" fill=\"" + colourText(*m_drawing.background) + "\"/>\n";
    if (std::any_of(m_drawing.structures.begin(), m_drawing.structures.end(),
                    [](const VectorStructure& s) { return s.filled(); }))
      addFills();
    addLines();
    for (const SvgWriting& writing : m_writings)
      appendLettering(m_text, writing, m_decimals);
    m_text += "</svg>\n";
    return std::move(m_text);
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

  std::string_view nameOf(model::NodeId id) const {
    const model::Node* node = m_scene.find(id);
    return node ? std::string_view(node->name) : std::string_view();
  }

  /// Adds what the drawing shows: its first sentence as the title, which programs show, too.
  void addDescription() {
    const std::string& text = m_credit.description;
    if (text.empty())
      return;
    const std::size_t cut = std::min(text.find(". "), text.size());
    const std::string language =
        m_credit.descriptionLanguage.empty()
            ? std::string()
            : " xml:lang=\"" + xmlText(m_credit.descriptionLanguage) + "\"";
    m_text += "<title id=\"" + std::string(svgTitleId) + "\"" + language + ">" +
              xmlText(std::string_view(text).substr(0, cut)) + "</title>\n";
    m_text += "<desc id=\"" + std::string(svgDescriptionId) + "\"" + language + ">" +
              xmlText(text) + "</desc>\n";
  }

  /// Adds the credit as Inkscape writes and reads it: Dublin Core about the document.
  void addCredit() {
    if (m_credit.author.empty() && m_credit.copyright.empty())
      return;
    m_text +=
        "<metadata>\n<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
        "xmlns:cc=\"http://creativecommons.org/ns#\" "
        "xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n<cc:Work rdf:about=\"\">\n";
    const auto add = [this](const std::string& element, const std::string& text) {
      if (!text.empty())
        m_text += "<dc:" + element + "><cc:Agent><dc:title>" + xmlText(text) +
                  "</dc:title></cc:Agent></dc:" + element + ">\n";
    };
    add("creator", m_credit.author);
    add("rights", m_credit.copyright);
    m_text += "</cc:Work>\n</rdf:RDF>\n</metadata>\n";
  }

  void addFills() {
    open("fills", "Fills", " inkscape:groupmode=\"layer\"");
    for (const VectorStructure& structure : m_drawing.structures) {
      if (!structure.filled())
        continue;
      openNamed("fill-" + std::to_string(structure.id.value), structure.id,
                opacityAttribute(structure.fillOpacity));
      if (structure.tones)
        addTones(*structure.tones, "edge-" + std::to_string(structure.id.value));
      for (const VectorShape& shape : structure.fills)
        addPath(shape, true);
      close();
    }
    close();
  }

  /// Adds tones as an image behind its edge. The older name of its link is the one that all
  /// programs know.
  void addTones(const VectorTones& tones, const std::string& edge) {
    const Result<std::string> png = pngOf(tones.image);
    if (!png.ok())
      return;  // nothing but the sink can fail, and that is memory
    const QByteArray bytes = QByteArray::fromStdString(*png).toBase64();
    m_text += "<clipPath id=\"" + edge + "\"><path clip-rule=\"evenodd\" d=\"" +
              svgPath(tones.edge, m_decimals - 1) + "\"/></clipPath>\n";
    m_text += "<g clip-path=\"url(#" + edge + ")\"><image x=\"" + number(double(tones.at.x), 4) +
              "\" y=\"" + number(double(tones.at.y), 4) + "\" width=\"" +
              number(double(tones.sizeMm.x), 4) + "\" height=\"" +
              number(double(tones.sizeMm.y), 4) +
              "\" preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64," +
              bytes.toStdString() + "\"/></g>\n";
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
    open("lines", "Lines",
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
    open("veiled", "Behind fills");
    for (std::size_t i = 0; i < veiled.size(); ++i) {
      const VeiledLines& part = veiled[i];
      const auto goesOn = [&part](const VeiledLines& other) {
        return other.structure == part.structure && other.light() == part.light();
      };
      if (i == 0 || !goesOn(veiled[i - 1]))
        openNamed("veiled-" + std::to_string(int(std::lround(100.0f * part.light()))) + "-" +
                      std::to_string(part.structure->id.value),
                  part.structure->id);
      addShapes(*part.lines, part.shapes);
      if (i + 1 == veiled.size() || !goesOn(veiled[i + 1]))
        close();
    }
    close();
  }

  void addShapes(const VectorLines& lines, std::span<const VectorShape> shapes) {
    m_text += "<g inkscape:label=\"" + std::string(lines.kind) + "\"" +
              (lines.hidden ? " class=\"hidden\"" : "") + opacityAttribute(lines.opacity) + ">\n";
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
        openNamed("group-" + std::to_string(id.value), id);
        addBelow(id);
      } else {
        openNamed("structure-" + std::to_string(id.value), id);
        addStructure(*m_branches[id].structures.front());
      }
      close();
    }
  }

  void addStructure(const VectorStructure& structure) {
    for (const VectorLines& lines : structure.lines)
      if (const auto shapes = plainShapes(lines); !shapes.empty())
        addShapes(lines, shapes);
  }

  const VectorDrawing& m_drawing;
  const model::Scene& m_scene;
  std::span<const SvgWriting> m_writings;
  const ExportCredit& m_credit;
  int m_decimals;
  std::map<model::NodeId, Branch> m_branches;
  std::string m_text;
};

}  // namespace

std::string svgDocument(const VectorDrawing& drawing, const model::Scene& scene,
                        std::span<const SvgWriting> writings, const ExportCredit& credit) {
  return Document(drawing, scene, writings, credit).make();
}

}  // namespace sline::render
