// SPDX-License-Identifier: Apache-2.0
// Keeps the driver loaded in every test of the window.
#include <QLibrary>

namespace {

/// Keeps Mesa's software renderer loaded from before the first window to the end: it is loaded and
/// unloaded as displays come and go, and a report of what it leaks could not name it
/// (tests/leaks.supp).
const bool driverStays = [] {
  QLibrary driver(QStringLiteral(SLINE_SOFTWARE_RENDERER));
  driver.setLoadHints(QLibrary::PreventUnloadHint);
  return driver.load();
}();

}  // namespace
