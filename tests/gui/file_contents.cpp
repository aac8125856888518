// SPDX-License-Identifier: Apache-2.0
#include "tests/gui/file_contents.h"

#include <QFile>

namespace sline::test {

QByteArray contents(const QString& file) {
  QFile source(file);
  return source.open(QIODevice::ReadOnly) ? source.readAll() : QByteArray();
}

}  // namespace sline::test
