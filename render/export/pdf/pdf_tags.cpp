// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/pdf_tags.h"

#include <memory>
#include <qpdf/Buffer.hh>
#include <qpdf/Pl_Buffer.hh>

namespace sline::render {

namespace {

using Tag = QPDFObjectHandle;

/// Returns an element of that kind below another.
Tag tagBelow(QPDF& file, Tag parent, const char* kind) {
  Tag element = Tag::newDictionary();
  element.replaceKey("/Type", Tag::newName("/StructElem"));
  element.replaceKey("/S", Tag::newName(kind));
  element.replaceKey("/P", parent);
  element.replaceKey("/K", Tag::newArray());
  element = file.makeIndirectObject(element);
  parent.getKey("/K").appendItem(element);
  return element;
}

/// Returns an element for marked content of a page.
Tag tagOf(QPDF& file, const Tag& section, const char* kind, QPDFPageObjectHelper& page, int mark) {
  Tag element = tagBelow(file, section, kind);
  element.replaceKey("/Pg", page.getObjectHandle());
  element.replaceKey("/K", Tag::newInteger(mark));
  return element;
}

/// Puts marks around the texts of a page: mark 0 is the figure's, those of texts follow.
class TextMarks : public QPDFObjectHandle::TokenFilter {
 public:
  void handleToken(const QPDFTokenizer::Token& token) override {
    const bool word = token.getType() == QPDFTokenizer::tt_word;
    if (!m_begun) {
      m_begun = true;
      write("/Artifact BMC\n");
    }
    if (word && token.getValue() == "BT")
      write("EMC\n/P <</MCID " + std::to_string(++m_texts) + ">> BDC\n");
    writeToken(token);
    if (word && token.getValue() == "ET")
      write("\nEMC\n/Artifact BMC\n");
  }
  void handleEOF() override {
    if (m_begun)
      write("\nEMC\n");
  }
  int texts() const { return m_texts; }

 private:
  bool m_begun = false;
  int m_texts = 0;
};

}  // namespace

int tagTexts(QPDF& file, QPDFPageObjectHelper& page) {
  TextMarks marks;
  Pl_Buffer marked("marked");
  page.filterContents(&marks, &marked);
  page.getObjectHandle().replaceKey("/Contents", file.newStream(marked.getBufferSharedPointer()));
  return marks.texts();
}

std::string taggedDrawing(const PdfContent& content) {
  if (content.operators.empty())
    return {};
  return (content.said.empty() ? "/Artifact BMC\n" : "/Figure <</MCID 0>> BDC\n") +
         content.operators + "EMC\n";
}

void addTags(QPDF& file, std::vector<QPDFPageObjectHelper>& pages,
             const std::vector<PdfContent>& contents, const std::vector<int>& texts) {
  Tag root = Tag::newDictionary();
  root.replaceKey("/Type", Tag::newName("/StructTreeRoot"));
  root.replaceKey("/K", Tag::newArray());
  root = file.makeIndirectObject(root);
  Tag document = tagBelow(file, root, "/Document");
  Tag places = Tag::newArray();
  for (std::size_t i = 0; i < pages.size(); ++i) {
    const PdfContent& content = contents[i];
    Tag section = tagBelow(file, document, "/Sect");
    Tag marks = Tag::newArray();
    if (content.operators.empty() || content.said.empty()) {
      marks.appendItem(Tag::newNull());
    } else {
      Tag figure = tagOf(file, section, "/Figure", pages[i], 0);
      figure.replaceKey("/Alt", Tag::newUnicodeString(content.said));
      if (!content.language.empty())
        figure.replaceKey("/Lang", Tag::newUnicodeString(content.language));
      marks.appendItem(figure);
    }
    for (int text = 1; text <= texts[i]; ++text)
      marks.appendItem(tagOf(file, section, "/P", pages[i], text));
    places.appendItem(Tag::newInteger(std::int64_t(i)));
    places.appendItem(file.makeIndirectObject(marks));
    Tag page = pages[i].getObjectHandle();
    page.replaceKey("/StructParents", Tag::newInteger(std::int64_t(i)));
    page.replaceKey("/Tabs", Tag::newName("/S"));
  }
  Tag numbers = Tag::newDictionary();
  numbers.replaceKey("/Nums", places);
  root.replaceKey("/ParentTree", file.makeIndirectObject(numbers));
  root.replaceKey("/ParentTreeNextKey", Tag::newInteger(std::int64_t(pages.size())));
  Tag marked = Tag::newDictionary();
  marked.replaceKey("/Marked", Tag::newBool(true));
  file.getRoot().replaceKey("/MarkInfo", marked);
  file.getRoot().replaceKey("/StructTreeRoot", root);
}

}  // namespace sline::render
