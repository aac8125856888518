// SPDX-License-Identifier: Apache-2.0
#include "render/export/slides/slide_package.h"

#include <algorithm>

#include "model/disk/zip_archive.h"
#include "render/export/slides/slide_master.h"
#include "render/export/slides/slide_parts.h"
#include "render/export/slides/slide_text.h"

namespace sline::render {

namespace {

constexpr const char* relationshipTypes =
    "http://schemas.openxmlformats.org/officeDocument/2006/relationships/";
constexpr const char* contentTypes = "application/vnd.openxmlformats-officedocument.";

/// Points from one part to another, by the number of its place in the list.
struct Relation {
  std::string type;  ///< the end of its name
  std::string target;
};

std::string relationsPart(const std::vector<Relation>& relations) {
  std::string text = xmlStart;
  text += "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">";
  for (std::size_t i = 0; i < relations.size(); ++i)
    text += "<Relationship Id=\"rId" + std::to_string(i + 1) + "\" Type=\"" +
            (relations[i].type.starts_with("http") ? relations[i].type
                                                   : relationshipTypes + relations[i].type) +
            "\" Target=\"" + relations[i].target + "\"/>";
  return text + "</Relationships>\n";
}

/// Gathers the parts of one presentation.
class Package {
 public:
  explicit Package(const SlideDeck& deck) : m_deck(deck) {}

  Result<std::string> make() {
    addProperties();
    addPresentation();
    addMasters();
    for (std::size_t i = 0; i < m_deck.pictures.size(); ++i) {
      m_parts.push_back({media(i, "png"), m_deck.pictures[i].png});
      m_parts.push_back({media(i, "svg"), m_deck.pictures[i].svg});
    }
    for (std::size_t i = 0; i < m_deck.slides.size(); ++i)
      addSlide(m_deck.slides[i], std::to_string(i + 1));
    const model::ZipMember types{"[Content_Types].xml", typesPart()};
    std::vector<const model::ZipMember*> all{&types};
    for (const model::ZipMember& part : m_parts)
      all.push_back(&part);
    return model::zipped(all);
  }

 private:
  static std::string media(std::size_t picture, const char* kind) {
    return "ppt/media/image" + std::to_string(picture + 1) + "." + kind;
  }

  /// Adds a part of a content type, and what it points to.
  void add(const std::string& name, const std::string& type, std::string bytes,
           const std::vector<Relation>& relations = {}) {
    m_types += "<Override PartName=\"/" + name + "\" ContentType=\"" +
               (type.starts_with("application/") ? type : contentTypes + type) + "+xml\"/>";
    m_parts.push_back({name, std::move(bytes)});
    if (relations.empty())
      return;
    const std::size_t cut = name.rfind('/') + 1;
    m_parts.push_back(
        {name.substr(0, cut) + "_rels/" + name.substr(cut) + ".rels", relationsPart(relations)});
  }

  std::string typesPart() const {
    return xmlStart +
           ("<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
            "<Default Extension=\"png\" ContentType=\"image/png\"/>"
            "<Default Extension=\"rels\" "
            "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
            "<Default Extension=\"svg\" ContentType=\"image/svg+xml\"/>"
            "<Default Extension=\"xml\" ContentType=\"application/xml\"/>" +
            m_types + "</Types>\n");
  }

  /// Adds what is said of the whole file: the credit, where there is one.
  void addProperties() {
    m_parts.push_back(
        {"_rels/.rels",
         relationsPart({{"officeDocument", "ppt/presentation.xml"},
                        {"http://schemas.openxmlformats.org/package/2006/relationships/metadata/"
                         "core-properties",
                         "docProps/core.xml"},
                        {"extended-properties", "docProps/app.xml"}})});
    const auto said = [](const char* element, const std::string& text) {
      return text.empty() ? std::string()
                          : "<dc:" + std::string(element) + ">" + slideXmlText(text) +
                                "</dc:" + element + ">";
    };
    add("docProps/core.xml", "application/vnd.openxmlformats-package.core-properties",
        xmlStart +
            ("<cp:coreProperties xmlns:cp=\"http://schemas.openxmlformats.org/package/2006/"
             "metadata/core-properties\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\">" +
             said("title", m_deck.slides.empty() ? std::string() : m_deck.slides[0].title.text) +
             said("creator", m_deck.credit.author) + said("description", m_deck.credit.copyright) +
             "</cp:coreProperties>\n"));
    add("docProps/app.xml", "extended-properties",
        xmlStart +
            ("<Properties xmlns=\"http://schemas.openxmlformats.org/officeDocument/2006/"
             "extended-properties\"><Slides>" +
             std::to_string(m_deck.slides.size()) + "</Slides><Notes>" +
             std::to_string(std::count_if(m_deck.slides.begin(), m_deck.slides.end(), hasNotes)) +
             "</Notes></Properties>\n"));
  }

  void addPresentation() {
    std::vector<Relation> relations{{"slideMaster", "slideMasters/slideMaster1.xml"},
                                    {"notesMaster", "notesMasters/notesMaster1.xml"},
                                    {"theme", "theme/theme1.xml"}};
    std::string slides;
    for (std::size_t i = 0; i < m_deck.slides.size(); ++i) {
      relations.push_back({"slide", "slides/slide" + std::to_string(i + 1) + ".xml"});
      slides += "<p:sldId id=\"" + std::to_string(256 + i) + "\" r:id=\"rId" +
                std::to_string(relations.size()) + "\"/>";
    }
    const auto size = [](const glm::vec2& mm) {
      return " cx=\"" + std::to_string(emu(double(mm.x))) + "\" cy=\"" +
             std::to_string(emu(double(mm.y))) + "\"";
    };
    add("ppt/presentation.xml", "presentationml.presentation.main",
        xmlStart +
            ("<p:presentation " + std::string(slideNamespaces) +
             "><p:sldMasterIdLst><p:sldMasterId id=\"2147483648\" r:id=\"rId1\"/>"
             "</p:sldMasterIdLst><p:notesMasterIdLst><p:notesMasterId r:id=\"rId2\"/>"
             "</p:notesMasterIdLst><p:sldIdLst>" +
             slides + "</p:sldIdLst><p:sldSz" + size(slideSizeMm(m_deck.shape)) +
             (m_deck.shape == SlideShape::standard ? " type=\"screen4x3\"" : "") + "/><p:notesSz" +
             size(notesSizeMm) + "/>" + defaultTextStyle() + "</p:presentation>\n"),
        relations);
  }

  void addMasters() {
    std::vector<Relation> relations;
    for (std::size_t i = 0; i < slideLayouts.size(); ++i) {
      const std::string name = "slideLayout" + std::to_string(i + 1) + ".xml";
      relations.push_back({"slideLayout", "../slideLayouts/" + name});
      add("ppt/slideLayouts/" + name, "presentationml.slideLayout",
          slideLayoutPart(m_deck, slideLayouts[i]),
          {{"slideMaster", "../slideMasters/slideMaster1.xml"}});
    }
    relations.push_back({"theme", "../theme/theme1.xml"});
    add("ppt/slideMasters/slideMaster1.xml", "presentationml.slideMaster", slideMasterPart(m_deck),
        relations);
    add("ppt/theme/theme1.xml", "theme", themePart(m_deck));
    add("ppt/notesMasters/notesMaster1.xml", "presentationml.notesMaster", notesMasterPart(),
        {{"theme", "../theme/theme2.xml"}});
    SlideDeck paper;  // notes are printed
    add("ppt/theme/theme2.xml", "theme", themePart(paper));
  }

  static bool hasNotes(const Slide& slide) { return !slide.notes.text.empty(); }

  void addSlide(const Slide& slide, const std::string& number) {
    const auto layout = std::find(slideLayouts.begin(), slideLayouts.end(), layoutOf(slide));
    std::vector<Relation> relations{
        {"slideLayout", "../slideLayouts/slideLayout" +
                            std::to_string(layout - slideLayouts.begin() + 1) + ".xml"}};
    if (slide.picture)
      for (const char* kind : {"png", "svg"})
        relations.push_back({"image", "../" + media(*slide.picture, kind).substr(4)});
    if (hasNotes(slide))
      relations.push_back({"notesSlide", "../notesSlides/notesSlide" + number + ".xml"});
    add("ppt/slides/slide" + number + ".xml", "presentationml.slide", slidePart(m_deck, slide),
        relations);
    if (hasNotes(slide))
      add("ppt/notesSlides/notesSlide" + number + ".xml", "presentationml.notesSlide",
          notesPart(slide),
          {{"notesMaster", "../notesMasters/notesMaster1.xml"},
           {"slide", "../slides/slide" + number + ".xml"}});
  }

  const SlideDeck& m_deck;
  std::string m_types;
  std::vector<model::ZipMember> m_parts;
};

}  // namespace

Result<std::string> slidePackage(const SlideDeck& deck) {
  return Package(deck).make();
}

}  // namespace sline::render
