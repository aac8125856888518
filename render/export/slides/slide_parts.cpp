// SPDX-License-Identifier: Apache-2.0
#include "render/export/slides/slide_parts.h"

#include <algorithm>

#include "model/scene/markup.h"
#include "render/export/encoding/xml_text.h"
#include "render/export/slides/slide_master.h"
#include "render/export/slides/slide_shapes.h"
#include "render/export/slides/slide_text.h"

namespace sline::render {

namespace {

/// Returns a placeholder of the layout's; `type` are its attributes.
std::string placeholder(const std::string& named, const std::string& type, const std::string& body,
                        const std::string& paragraphs) {
  return "<p:sp><p:nvSpPr><p:cNvPr " + named +
         "/><p:cNvSpPr><a:spLocks noGrp=\"1\"/></p:cNvSpPr><p:nvPr><p:ph " + type +
         "/></p:nvPr></p:nvSpPr><p:spPr/><p:txBody>" + body + "<a:lstStyle/>" + paragraphs +
         "</p:txBody></p:sp>\n";
}

std::vector<std::string> linesOf(const SlideWords& words) {
  std::vector<std::string> lines;
  for (const model::MarkedLine& line : model::markedLines(words.text)) {
    lines.emplace_back();
    for (const model::MarkedRun& run : line.runs)
      lines.back() += run.text;
  }
  return lines;
}

/// Returns the picture with the document that programs show which know it; others show the pixels.
std::string pictureXml(const Slide& slide, const std::string& named) {
  return "<p:pic><p:nvPicPr><p:cNvPr " + named + " descr=\"" +
         slideXmlText(plainLine(slide.shown.text)) +
         "\"/><p:cNvPicPr><a:picLocks noChangeAspect=\"1\"/></p:cNvPicPr><p:nvPr/></p:nvPicPr>"
         "<p:blipFill><a:blip r:embed=\"" +
         slidePngId +
         "\"><a:extLst><a:ext uri=\"{96DAC541-7B7A-43D3-8B79-37D633B846F1}\"><asvg:svgBlip "
         "xmlns:asvg=\"http://schemas.microsoft.com/office/drawing/2016/SVG/main\" r:embed=\"" +
         slideSvgId +
         "\"/></a:ext></a:extLst></a:blip><a:stretch><a:fillRect/></a:stretch></p:blipFill>"
         "<p:spPr><a:xfrm>" +
         slidePlace(slide.figure) +
         "</a:xfrm><a:prstGeom prst=\"rect\"><a:avLst/></a:prstGeom></p:spPr></p:pic>\n";
}

/// Returns the key's paragraphs in so many columns that they are as large as possible.
std::string keyList(const SlideDeck& deck, const Slide& slide, const std::string& named) {
  constexpr int mostColumns = 5;
  std::vector<std::string> lines;
  for (const SlideKeyLine& line : slide.key)
    lines.push_back((line.number > 0 ? std::to_string(line.number) + "  " : std::string()) +
                    plainLine(line.words.text));
  const glm::vec2 box = slideFrames(deck.shape, false).list.size;
  int columns = 1;
  float share = 0.0f;
  for (int i = 1; i <= mostColumns; ++i)
    if (const float fits = shareThatFits(lines, slideListPoints, box, i); fits > share) {
      columns = i;
      share = fits;
    }
  return placeholder(named, "idx=\"1\"", fittedBody(share, columns), keyParagraphs(slide.key));
}

/// Returns one effect: a shape that becomes visible with a click. `id` counts time nodes.
std::string appearance(int shape, int& id) {
  const auto node = [&id](const std::string& attributes, const std::string& delay,
                          const std::string& children) {
    return "<p:par><p:cTn id=\"" + std::to_string(++id) + "\"" + attributes +
           " fill=\"hold\"><p:stCondLst><p:cond delay=\"" + delay +
           "\"/></p:stCondLst><p:childTnLst>" + children + "</p:childTnLst></p:cTn></p:par>";
  };
  const std::string set =
      "<p:set><p:cBhvr><p:cTn id=\"" + std::to_string(++id) +
      "\" dur=\"1\" fill=\"hold\"><p:stCondLst><p:cond delay=\"0\"/></p:stCondLst></p:cTn>"
      "<p:tgtEl><p:spTgt spid=\"" +
      std::to_string(shape) +
      "\"/></p:tgtEl><p:attrNameLst><p:attrName>style.visibility</p:attrName></p:attrNameLst>"
      "</p:cBhvr><p:to><p:strVal val=\"visible\"/></p:to></p:set>";
  const std::string effect =
      node(" presetID=\"1\" presetClass=\"entr\" presetSubtype=\"0\" nodeType=\"clickEffect\"", "0",
           set);
  return node("", "indefinite", node("", "0", effect));
}

}  // namespace

SlideLayout layoutOf(const Slide& slide) {
  if (!slide.picture)
    return SlideLayout::list;
  return linesOf(slide.text).empty() ? SlideLayout::figure : SlideLayout::text;
}

std::string appearOnClick(const std::vector<int>& shapes) {
  if (shapes.empty())
    return {};
  int id = 2;  // the root and the main sequence are first
  std::string effects;
  for (const int shape : shapes)
    effects += appearance(shape, id);
  const auto turns = [](const std::string& list, const std::string& event) {
    return "<p:" + list + "><p:cond evt=\"" + event +
           "\" delay=\"0\"><p:tgtEl><p:sldTgt/></p:tgtEl></p:cond></p:" + list + ">";
  };
  return "<p:timing><p:tnLst><p:par><p:cTn id=\"1\" dur=\"indefinite\" restart=\"never\" "
         "nodeType=\"tmRoot\"><p:childTnLst><p:seq concurrent=\"1\" nextAc=\"seek\">"
         "<p:cTn id=\"2\" dur=\"indefinite\" nodeType=\"mainSeq\"><p:childTnLst>" +
         effects + "</p:childTnLst></p:cTn>" + turns("prevCondLst", "onPrev") +
         turns("nextCondLst", "onNext") +
         "</p:seq></p:childTnLst></p:cTn></p:par></p:tnLst></p:timing>\n";
}

std::string slidePart(const SlideDeck& deck, const Slide& slide) {
  const SlideLayout layout = layoutOf(slide);
  const SlideFrames frames = slideFrames(deck.shape, layout == SlideLayout::text);
  SlideShapes shapes(deck, slide.figure);
  std::string text = xmlStart;
  text += "<p:sld " + std::string(slideNamespaces) + "><p:cSld>" + shapeTreeStart;
  text += placeholder(
      shapes.named("Title"), "type=\"title\"",
      fittedBody(shareThatFits({plainLine(slide.title.text)}, slideTitlePoints, frames.title.size)),
      lineParagraphs(slide.title));
  if (layout == SlideLayout::text)
    text += placeholder(
        shapes.named("Text"), "type=\"body\" idx=\"1\"",
        fittedBody(shareThatFits(linesOf(slide.text), slideTextPoints, frames.text.size)),
        markedParagraphs(slide.text));
  if (layout == SlideLayout::list)
    text += keyList(deck, slide, shapes.named("Key"));
  if (slide.picture)
    text += pictureXml(slide, shapes.named("Figure"));
  for (const SlideLabel& mark : slide.marks)
    text += shapes.label(mark);
  std::vector<int> groups;
  for (const SlideLabel& label : slide.labels) {
    int id = 0;
    text += shapes.label(label, &id);
    groups.push_back(id);
  }
  return text + "</p:spTree></p:cSld><p:clrMapOvr><a:masterClrMapping/></p:clrMapOvr>" +
         (slide.onClick ? appearOnClick(groups) : std::string()) + "</p:sld>\n";
}

std::string notesPart(const Slide& slide) {
  return xmlStart + ("<p:notes " + std::string(slideNamespaces)) + "><p:cSld>" + shapeTreeStart +
         "<p:sp><p:nvSpPr><p:cNvPr id=\"2\" name=\"Slide\"/><p:cNvSpPr><a:spLocks noGrp=\"1\" "
         "noRot=\"1\" noChangeAspect=\"1\"/></p:cNvSpPr><p:nvPr><p:ph type=\"sldImg\"/></p:nvPr>"
         "</p:nvSpPr><p:spPr/></p:sp>\n" +
         placeholder("id=\"3\" name=\"Notes\"", "type=\"body\" idx=\"1\"", "<a:bodyPr/>",
                     plainParagraphs(slide.notes)) +
         "</p:spTree></p:cSld><p:clrMapOvr><a:masterClrMapping/></p:clrMapOvr></p:notes>\n";
}

}  // namespace sline::render
