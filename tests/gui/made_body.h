// SPDX-License-Identifier: Apache-2.0
// Makes scenes in memory, as the window opens them.
#pragma once

#include "tests/gui/window_fixture.h"

namespace sline::test {

/// Returns Organs ( left kidney, right kidney, bladder ) Vessels ( aorta, left renal vein ) skin:
/// balls side by side; the groups have colours of their own.
model::Scene madeBody();
/// Returns one structure for each part of BodyParts3D if its list is here, else as many made-up
/// names; 2,234 small meshes in the groups of its first level.
model::Scene wholeBody();
/// Opens the scene; returns false if it does not open.
bool openScene(WindowFixture& f, const model::Scene& scene);

}  // namespace sline::test
