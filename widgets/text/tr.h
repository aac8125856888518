// SPDX-License-Identifier: Apache-2.0
// Translates the texts of functions that belong to no class with Q_OBJECT.
#pragma once

#include <QString>

namespace sline::widgets {

/// Returns the text in the interface's language, plural forms chosen by `n` where it is not
/// negative. lupdate files calls outside of classes under the namespace, which is the context this
/// looks in; `comment` tells equal texts of different meaning apart.
QString tr(const char* text, const char* comment = nullptr, int n = -1);

}  // namespace sline::widgets
