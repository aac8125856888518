// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "widgets/session/document.h"

class QWidget;

namespace sline::widgets {

/// Asks what to do with files of several patients: which files belong to which is shown, by their
/// names alone. The answer goes to the question; `cancelled` is called where there is none.
void askAboutPatients(
    QWidget& window, const PatientQuestion& question,
    const std::function<void()>& cancelled = [] {});

}  // namespace sline::widgets
