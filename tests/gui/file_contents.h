// SPDX-License-Identifier: Apache-2.0
// Reads whole files.
#pragma once

#include <QByteArray>
#include <QString>

namespace sline::test {

QByteArray contents(const QString& file);

}  // namespace sline::test
