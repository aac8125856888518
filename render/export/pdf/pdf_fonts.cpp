// SPDX-License-Identifier: Apache-2.0
#include "render/export/pdf/pdf_fonts.h"

#include <set>
#include <string>

namespace sline::render {

namespace {

using Object = QPDFObjectHandle;

constexpr std::size_t tagLength = 6;

/// Returns six letters for a number, the first of which Qt has, too.
std::string tagOf(std::size_t number) {
  std::string tag = "Q";
  while (tag.size() < tagLength) {
    tag += char('A' + number % 26);
    number /= 26;
  }
  return tag;
}

/// Gives the name in that entry the tag, if it has one: "/QMAAAA+DejaVuSans".
void rename(Object owner, const std::string& key, const std::string& tag) {
  if (!owner.isDictionary() || !owner.getKey(key).isName())
    return;
  const std::string name = owner.getKey(key).getName();
  if (name.find('+') == tagLength + 1)
    owner.replaceKey(key, Object::newName('/' + tag + name.substr(tagLength + 1)));
}

}  // namespace

void nameFonts(std::vector<QPDFPageObjectHelper>& pages) {
  std::set<QPDFObjGen> named;
  for (QPDFPageObjectHelper& page : pages) {
    Object resources = page.getAttribute("/Resources", false);
    Object fonts = resources.isDictionary() ? resources.getKey("/Font") : Object::newNull();
    if (!fonts.isDictionary())
      continue;
    for (const std::string& key : fonts.getKeys()) {
      Object font = fonts.getKey(key);
      const std::string tag = tagOf(named.size());
      if (!named.insert(font.getObjGen()).second)
        continue;
      rename(font, "/BaseFont", tag);
      Object inner = font.isDictionary() ? font.getKey("/DescendantFonts") : Object::newNull();
      if (!inner.isArray() || inner.getArrayNItems() == 0)
        continue;
      rename(inner.getArrayItem(0), "/BaseFont", tag);
      if (inner.getArrayItem(0).isDictionary())
        rename(inner.getArrayItem(0).getKey("/FontDescriptor"), "/FontName", tag);
    }
  }
}

}  // namespace sline::render
