// SPDX-License-Identifier: Apache-2.0
#include "render/export/slides/slide_master.h"

#include <array>

#include "model/base/colour_text.h"
#include "render/export/slides/slide_shapes.h"

namespace sline::render {

namespace {

std::string fixedColour(const char* name, const std::string& hex) {
  return std::string("<a:") + name + "><a:srgbClr val=\"" + hex + "\"/></a:" + name + ">";
}

std::string themeColours(const SlideDeck& deck) {
  const std::string ink = colourText(deck.ink).substr(1);
  const std::string ground = colourText(deck.ground).substr(1);
  std::string all = "<a:clrScheme name=\"Sline\">" + fixedColour("dk1", deck.dark ? ground : ink) +
                    fixedColour("lt1", deck.dark ? ink : ground) + fixedColour("dk2", "3C3C3C") +
                    fixedColour("lt2", "E8E4DA");
  // Bone, artery, vein, nerve, muscle, duct: hues in which charts beside a figure do not clash.
  constexpr std::array accents{"B08D57", "B5402E", "3F6C9E", "C9A227", "A05252", "5B8C5A"};
  for (std::size_t i = 0; i < accents.size(); ++i)
    all += fixedColour(("accent" + std::to_string(i + 1)).c_str(), accents[i]);
  return all + fixedColour("hlink", "3F6C9E") + fixedColour("folHlink", "7A5C8E") +
         "</a:clrScheme>";
}

/// Returns fills, lines, effects and grounds, of which a theme has three each.
std::string themeFormats() {
  const std::string fill = "<a:solidFill><a:schemeClr val=\"phClr\"/></a:solidFill>";
  const auto line = [&fill](const char* width) {
    return "<a:ln w=\"" + std::string(width) + "\">" + fill + "</a:ln>";
  };
  const std::string effect = "<a:effectStyle><a:effectLst/></a:effectStyle>";
  return "<a:fmtScheme name=\"Sline\"><a:fillStyleLst>" + fill + fill + fill +
         "</a:fillStyleLst><a:lnStyleLst>" + line("6350") + line("12700") + line("19050") +
         "</a:lnStyleLst><a:effectStyleLst>" + effect + effect + effect +
         "</a:effectStyleLst><a:bgFillStyleLst>" + fill + fill + fill +
         "</a:bgFillStyleLst></a:fmtScheme>";
}

/// Returns properties of a level of text in the theme's fonts, major or minor.
std::string level(const std::string& element, const std::string& attributes, float points,
                  const char* font) {
  const std::string name(font);
  return "<a:" + element + attributes + "><a:buNone/><a:defRPr sz=\"" +
         std::to_string(int(100.0f * points)) +
         "\"><a:solidFill><a:schemeClr val=\"tx1\"/></a:solidFill><a:latin typeface=\"+" + name +
         "-lt\"/><a:ea typeface=\"+" + name + "-ea\"/><a:cs typeface=\"+" + name +
         "-cs\"/></a:defRPr></a:" + element + ">";
}

std::string plainLevel() {
  return level("lvl1pPr", " marL=\"0\" algn=\"l\"", slideTextPoints, "mn");
}

std::string textStyles() {
  return "<p:txStyles><p:titleStyle>" + level("lvl1pPr", " algn=\"l\"", slideTitlePoints, "mj") +
         "</p:titleStyle><p:bodyStyle>" + plainLevel() + "</p:bodyStyle><p:otherStyle>" +
         plainLevel() + "</p:otherStyle></p:txStyles>";
}

struct Place {
  const char* name;
  std::string type;  ///< attributes of `p:ph`
  SlideBox box;
  const char* body;  ///< body properties
  const char* words;
};

constexpr const char* titleBody =
    "<a:bodyPr lIns=\"0\" tIns=\"0\" rIns=\"0\" bIns=\"0\" anchor=\"ctr\"><a:normAutofit/>"
    "</a:bodyPr>";
constexpr const char* textBody =
    "<a:bodyPr lIns=\"0\" tIns=\"0\" rIns=\"0\" bIns=\"0\" anchor=\"t\"><a:normAutofit/>"
    "</a:bodyPr>";

std::string placed(int id, const Place& place, const std::string& style = {}) {
  return "<p:sp><p:nvSpPr><p:cNvPr id=\"" + std::to_string(id) + "\" name=\"" + place.name +
         "\"/><p:cNvSpPr><a:spLocks noGrp=\"1\"/></p:cNvSpPr><p:nvPr><p:ph " + place.type +
         "/></p:nvPr></p:nvSpPr><p:spPr><a:xfrm>" + slidePlace(place.box) +
         "</a:xfrm><a:prstGeom prst=\"rect\"><a:avLst/></a:prstGeom></p:spPr><p:txBody>" +
         place.body + "<a:lstStyle>" + style +
         "</a:lstStyle><a:p><a:r><a:rPr lang=\"en-US\"/><a:t>" + place.words +
         "</a:t></a:r></a:p></p:txBody></p:sp>\n";
}

std::string ground(const char* scheme) {
  return "<p:bg><p:bgRef idx=\"1001\"><a:schemeClr val=\"" + std::string(scheme) +
         "\"/></p:bgRef></p:bg>";
}

std::string colourMap(bool dark) {
  return std::string("<p:clrMap bg1=\"") + (dark ? "dk1" : "lt1") + "\" tx1=\"" +
         (dark ? "lt1" : "dk1") + "\" bg2=\"" + (dark ? "dk2" : "lt2") + "\" tx2=\"" +
         (dark ? "lt2" : "dk2") +
         "\" accent1=\"accent1\" accent2=\"accent2\" accent3=\"accent3\" accent4=\"accent4\" "
         "accent5=\"accent5\" accent6=\"accent6\" hlink=\"hlink\" folHlink=\"folHlink\"/>";
}

}  // namespace

std::string themePart(const SlideDeck& deck) {
  const std::string font =
      "<a:latin typeface=\"Arial\"/><a:ea typeface=\"\"/><a:cs typeface=\"\"/>";
  return xmlStart +
         std::string(
             "<a:theme xmlns:a=\"http://schemas.openxmlformats.org/drawingml/2006/main\" "
             "name=\"Sline\"><a:themeElements>") +
         themeColours(deck) + "<a:fontScheme name=\"Sline\"><a:majorFont>" + font +
         "</a:majorFont><a:minorFont>" + font + "</a:minorFont></a:fontScheme>" + themeFormats() +
         "</a:themeElements><a:objectDefaults/><a:extraClrSchemeLst/></a:theme>\n";
}

std::string slideMasterPart(const SlideDeck& deck) {
  const SlideFrames frames = slideFrames(deck.shape, false);
  std::string text = xmlStart;
  text +=
      "<p:sldMaster " + std::string(slideNamespaces) + "><p:cSld>" + ground("bg1") + shapeTreeStart;
  text += placed(2, {"Title", "type=\"title\"", frames.title, titleBody, "Title"});
  text += placed(3, {"Text", "type=\"body\" idx=\"1\"", frames.list, textBody, "Text"});
  text += "</p:spTree></p:cSld>" + colourMap(deck.dark) + "<p:sldLayoutIdLst>";
  // Numbers of masters and layouts are unique together and begin at 2³¹.
  for (std::size_t i = 0; i < slideLayouts.size(); ++i)
    text += "<p:sldLayoutId id=\"" + std::to_string(2'147'483'649u + unsigned(i)) +
            "\" r:id=\"rId" + std::to_string(i + 1) + "\"/>";
  return text + "</p:sldLayoutIdLst>" + textStyles() + "</p:sldMaster>\n";
}

std::string slideLayoutPart(const SlideDeck& deck, SlideLayout layout) {
  const SlideFrames frames = slideFrames(deck.shape, layout == SlideLayout::text);
  const char* const name = layout == SlideLayout::figure ? "Figure"
                           : layout == SlideLayout::text ? "Figure and text"
                                                         : "List";
  std::string text = xmlStart;
  text += "<p:sldLayout " + std::string(slideNamespaces) +
          (layout == SlideLayout::figure ? " type=\"titleOnly\"" : "") +
          " preserve=\"1\"><p:cSld name=\"" + name + "\">" + shapeTreeStart;
  text += placed(2, {"Title", "type=\"title\"", frames.title, titleBody, "Title"});
  if (layout == SlideLayout::text)
    text += placed(3, {"Text", "type=\"body\" idx=\"1\"", frames.text, textBody, "Text"});
  if (layout == SlideLayout::list)
    text += placed(3, {"List", "idx=\"1\"", frames.list, textBody, "List"},
                   level("lvl1pPr", "", slideListPoints, "mn"));
  return text + "</p:spTree></p:cSld><p:clrMapOvr><a:masterClrMapping/></p:clrMapOvr>" +
         "</p:sldLayout>\n";
}

std::string defaultTextStyle() {
  return "<p:defaultTextStyle>" + plainLevel() + "</p:defaultTextStyle>";
}

std::string notesMasterPart() {
  constexpr float margin = 19.0f;
  const float width = notesSizeMm.x - 2.0f * margin;
  const SlideBox image{{margin, margin}, {width, width * 9.0f / 16.0f}};
  const SlideBox notes{{margin, 118.0f}, {width, notesSizeMm.y - 118.0f - margin}};
  std::string text = xmlStart;
  text += "<p:notesMaster " + std::string(slideNamespaces) + "><p:cSld>" + ground("bg1") +
          shapeTreeStart;
  text +=
      "<p:sp><p:nvSpPr><p:cNvPr id=\"2\" name=\"Slide\"/><p:cNvSpPr><a:spLocks noGrp=\"1\" "
      "noRot=\"1\" noChangeAspect=\"1\"/></p:cNvSpPr><p:nvPr><p:ph type=\"sldImg\" idx=\"2\"/>"
      "</p:nvPr></p:nvSpPr><p:spPr><a:xfrm>" +
      slidePlace(image) +
      "</a:xfrm><a:prstGeom prst=\"rect\"><a:avLst/></a:prstGeom><a:noFill/><a:ln w=\"6350\">"
      "<a:solidFill><a:schemeClr val=\"tx1\"/></a:solidFill></a:ln></p:spPr></p:sp>\n";
  text += placed(3, {"Notes", "type=\"body\" idx=\"1\"", notes, "<a:bodyPr/>", "Notes"});
  constexpr float points = 12.0f;
  return text + "</p:spTree></p:cSld>" + colourMap(false) + "<p:notesStyle>" +
         level("lvl1pPr", " marL=\"0\" algn=\"l\"", points, "mn") +
         "</p:notesStyle></p:notesMaster>\n";
}

}  // namespace sline::render
