// SPDX-License-Identifier: Apache-2.0
#include "widgets/text/tr.h"

#include <QCoreApplication>

namespace sline::widgets {

QString tr(const char* text, const char* comment, int n) {
  return QCoreApplication::translate("sline::widgets", text, comment, n);
}

}  // namespace sline::widgets

#include "moc_tr.cpp"
