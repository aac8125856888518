// SPDX-License-Identifier: Apache-2.0
// Shortens names that are too long for their rows so that names which are alike stay apart.
#pragma once

#include <QFontMetrics>
#include <QStringList>

namespace sline::widgets {

/// Tells whether the name could be shortened to that text, in which "…" stands for what is left
/// out; the whole name is such a text, too.
bool mayStandFor(const QString& shortened, const QString& name);

/// Returns the name if it fits the width, in pixels; else with its middle left out or, where one of
/// the others could be shortened to the same text, with its end left out, or what is before the
/// word that tells it from them. Where none of these does, its middle is left out all the same.
QString elidedName(const QString& name, const QStringList& others, const QFontMetrics& metrics,
                   int width);

}  // namespace sline::widgets
