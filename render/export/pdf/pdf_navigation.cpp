// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/pdf_navigation.h"

#include <qpdf/JSON.hh>
#include <qpdf/QPDF.hh>
#include <qpdf/QPDFPageObjectHelper.hh>

#include "render/export/pdf/pdf_drawing.h"

namespace sline::render {

namespace {

using Handle = QPDFObjectHandle;

/// Returns what shows the whole of that page.
Handle destination(QPDFPageObjectHelper& page) {
  return Handle::newArray({page.getObjectHandle(), Handle::newName("/Fit")});
}

void addLink(QPDF& file, QPDFPageObjectHelper& page, const PdfLink& link, const Handle& target,
             double pageHeight) {
  const auto across = [](float millimetres) {
    return Handle::newReal(pointsPerMillimetre * double(millimetres), 3);
  };
  const auto up = [pageHeight](float millimetres) {
    return Handle::newReal(pageHeight - pointsPerMillimetre * double(millimetres), 3);
  };
  Handle note = Handle::newDictionary();
  note.replaceKey("/Type", Handle::newName("/Annot"));
  note.replaceKey("/Subtype", Handle::newName("/Link"));
  note.replaceKey("/Rect", Handle::newArray({across(link.box.low.x), up(link.box.high.y),
                                             across(link.box.high.x), up(link.box.low.y)}));
  note.replaceKey("/Border", Handle::newArray({Handle::newInteger(0), Handle::newInteger(0),
                                               Handle::newInteger(0)}));
  note.replaceKey("/Dest", target);
  Handle entries = page.getObjectHandle();
  Handle notes = entries.getKey("/Annots");
  if (!notes.isArray())
    notes = entries.replaceKeyAndGetNew("/Annots", Handle::newArray());
  notes.appendItem(file.makeIndirectObject(note));
}

/// Chains the items below their parent (ISO 32000-1, 12.3.3); closed ones hide what is in them.
void chain(Handle parent, std::vector<Handle>& items, bool open) {
  if (items.empty())
    return;
  parent.replaceKey("/First", items.front());
  parent.replaceKey("/Last", items.back());
  parent.replaceKey("/Count", Handle::newInteger((open ? 1 : -1) * std::int64_t(items.size())));
  for (std::size_t i = 0; i < items.size(); ++i) {
    items[i].replaceKey("/Parent", parent);
    if (i > 0)
      items[i].replaceKey("/Prev", items[i - 1]);
    if (i + 1 < items.size())
      items[i].replaceKey("/Next", items[i + 1]);
  }
}

void addBookmarks(QPDF& file, std::vector<QPDFPageObjectHelper>& pages,
                  const std::vector<PdfBookmark>& bookmarks) {
  Handle outlines = Handle::newDictionary();
  outlines.replaceKey("/Type", Handle::newName("/Outlines"));
  outlines = file.makeIndirectObject(outlines);
  std::vector<Handle> outer;
  std::vector<Handle> inner;
  for (const PdfBookmark& bookmark : bookmarks) {
    Handle item = Handle::newDictionary();
    item.replaceKey("/Title", Handle::newUnicodeString(bookmark.title));
    item.replaceKey("/Dest", destination(pages.at(bookmark.page)));
    item = file.makeIndirectObject(item);
    if (bookmark.inner && !outer.empty()) {
      inner.push_back(item);
      continue;
    }
    if (!outer.empty())
      chain(outer.back(), inner, false);
    inner.clear();
    outer.push_back(item);
  }
  if (!outer.empty())
    chain(outer.back(), inner, false);
  chain(outlines, outer, true);
  Handle catalog = file.getRoot();
  catalog.replaceKey("/Outlines", outlines);
  catalog.replaceKey("/PageMode", Handle::newName("/UseOutlines"));
}

}  // namespace

void addNavigation(QPDF& file, std::vector<QPDFPageObjectHelper>& pages,
                   const PdfNavigation& navigation, double pageHeight) {
  for (const PdfLink& link : navigation.links)
    addLink(file, pages.at(link.page), link, destination(pages.at(link.target)), pageHeight);
  if (!navigation.bookmarks.empty())
    addBookmarks(file, pages, navigation.bookmarks);
}

}  // namespace sline::render
