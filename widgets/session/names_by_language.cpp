// SPDX-License-Identifier: Apache-2.0
#include "widgets/session/names_by_language.h"

namespace sline::widgets {

std::map<std::string, std::string> namesByLanguage(const DisplayNames& names,
                                                   const std::string& name) {
  std::map<std::string, std::string> all;
  if (names.knows(name))
    for (const char* tag : {"en", "la", "de", "nl", "nb"})
      all[tag] = names.calledIn(name, tag).toStdString();
  return all;
}

}  // namespace sline::widgets
