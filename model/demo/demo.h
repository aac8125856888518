// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>

#include "model/sculpting/demo_structure.h"

namespace sline::model {

/// Lists the scenes that the program models itself.
enum class DemoName { kidney, pelvis, abdomen };
inline constexpr std::array<std::string_view, 3> demoNames{"kidney", "pelvis", "abdomen"};
std::optional<DemoName> demoNamed(std::string_view name);

/// Returns "female" or "male".
std::string_view sexName(Sex sex);

/// Returns the scene from `cacheFolder` (see userCacheFolder) if this version of the program left
/// it there; otherwise models it, which takes seconds, and leaves it there. A cache that cannot be
/// read or written only costs time; an empty path means no cache.
Scene demo(DemoName name, Sex sex, const std::filesystem::path& cacheFolder);
/// Does the same as `demo` above; if `stop` is requested on the way, it returns nothing and leaves
/// nothing in the cache.
std::optional<Scene> demo(DemoName name, Sex sex, const std::filesystem::path& cacheFolder,
                          const std::stop_token& stop);

/// Returns a name for what is made of the scene and kept: another one whenever this program models
/// it otherwise.
std::string demoKey(DemoName name, Sex sex);

/// Returns the name of the scene's file in that folder.
std::string demoCacheFile(DemoName name, Sex sex);

}  // namespace sline::model
