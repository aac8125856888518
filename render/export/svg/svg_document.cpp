// SPDX-License-Identifier: Apache-2.0
#include "render/export/svg/svg_document.h"

#include <algorithm>
#include <cmath>

#include "model/base/colour_text.h"
#include "render/export/encoding/xml_text.h"
#include "render/export/svg/svg_drawing.h"
#include "render/export/svg/svg_lettering.h"
#include "render/export/svg/svg_shapes.h"
#include "render/export/svg/svg_values.h"

namespace sline::render {

namespace {

constexpr const char* svgTitleId = "picture-title";
constexpr const char* svgDescriptionId = "picture-description";
/// What a document says of itself that has a title and a description.
const std::string svgDescribed = std::string(" role=\"img\" aria-labelledby=\"") + svgTitleId +
                                 "\" aria-describedby=\"" + svgDescriptionId + "\"";

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
    m_text = svgStart(width, height, describedBy(m_credit));
    appendDescription(m_text, m_credit);
    appendCredit(m_text, m_credit);
    if (m_drawing.background)
      m_text += "<rect id=\"background\" width=\"" + width + "\" height=\"" + height +
                "\" fill=\"" + colourText(*m_drawing.background) + "\"/>\n";
    const bool gaps = appendGaps(m_text, m_writings, "gaps", m_drawing.sizeMm, m_decimals);
    if (gaps)
      m_text += "<g mask=\"url(#gaps)\">\n";
    appendSvgDrawing(m_text, m_drawing, m_scene, {.prefix = {}, .decimals = m_decimals});
    if (gaps)
      m_text += "</g>\n";
    for (const SvgWriting& writing : m_writings)
      appendLettering(m_text, writing, m_decimals);
    m_text += "</svg>\n";
    return std::move(m_text);
  }

 private:
  const VectorDrawing& m_drawing;
  const model::Scene& m_scene;
  std::span<const SvgWriting> m_writings;
  const ExportCredit& m_credit;
  int m_decimals;
  std::string m_text;
};

}  // namespace

std::string describedBy(const ExportCredit& credit) {
  return credit.description.empty() ? std::string() : svgDescribed;
}

void appendDescription(std::string& text, const ExportCredit& credit) {
  const std::string& said = credit.description;
  if (said.empty())
    return;
  const std::size_t cut = std::min(said.find(". "), said.size());
  const std::string language = credit.descriptionLanguage.empty()
                                   ? std::string()
                                   : " xml:lang=\"" + xmlText(credit.descriptionLanguage) + "\"";
  text += "<title id=\"" + std::string(svgTitleId) + "\"" + language + ">" +
          xmlText(std::string_view(said).substr(0, cut)) + "</title>\n";
  text += "<desc id=\"" + std::string(svgDescriptionId) + "\"" + language + ">" + xmlText(said) +
          "</desc>\n";
}

void appendCredit(std::string& text, const ExportCredit& credit) {
  if (credit.empty())
    return;
  text +=
      "<metadata>\n<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" "
      "xmlns:cc=\"http://creativecommons.org/ns#\" "
      "xmlns:dc=\"http://purl.org/dc/elements/1.1/\">\n<cc:Work rdf:about=\"\">\n";
  const auto add = [&text](const std::string& element, const std::string& value) {
    if (!value.empty())
      text += "<dc:" + element + "><cc:Agent><dc:title>" + xmlText(value) +
              "</dc:title></cc:Agent></dc:" + element + ">\n";
  };
  add("creator", credit.author);
  add("rights", credit.copyright);
  text += "</cc:Work>\n</rdf:RDF>\n</metadata>\n";
}

std::string svgDocument(const VectorDrawing& drawing, const model::Scene& scene,
                        std::span<const SvgWriting> writings, const ExportCredit& credit) {
  return Document(drawing, scene, writings, credit).make();
}

}  // namespace sline::render
