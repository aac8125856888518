// SPDX-License-Identifier: Apache-2.0
// Says what the list of techniques says in the interface's language.
#pragma once

#include <QString>

#include "model/scene/style.h"

namespace sline::widgets {

/// Returns the name of the lines that the technique draws.
QString linesName(model::Technique technique);
/// Returns what a threshold means; `meaning` is that of the list of techniques.
QString thresholdMeaning(const char* meaning);

}  // namespace sline::widgets
