// SPDX-License-Identifier: Apache-2.0
// Names a surface of the cerebral cortex, from the way programs call its file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace sline::model {

/// Returns "left pial surface" for "lh.pial", for "sub-01_hemi-L_pial.surf.gii" and for
/// "100307.L.pial.32k_fs_LR.surf.gii"; an empty name where the file's name does not say both.
/// `more` holds words that the file says of itself ("CortexLeft Pial"), which count like those of
/// its name.
std::string corticalName(const std::filesystem::path& file, std::string_view more = {});

/// Returns false where the name says that the surface was blown up, cut open or made a sphere.
bool isCalledAnatomical(const std::filesystem::path& file);

}  // namespace sline::model
