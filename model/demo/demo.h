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

/// The scenes that the program models itself.
enum class DemoName { kidney, pelvis, abdomen };
inline constexpr std::array<std::string_view, 3> demoNames{"kidney", "pelvis", "abdomen"};
std::optional<DemoName> demoNamed(std::string_view name);

/// "female" or "male".
std::string_view sexName(Sex sex);

/// The scene, from `cacheFolder` (see userCacheFolder) where this version of the program left it,
/// else modelled anew, which takes seconds, and left there. A cache that cannot be read or written
/// changes nothing but the time; an empty path means no cache.
Scene demo(DemoName name, Sex sex, const std::filesystem::path& cacheFolder);
/// The same; nothing, and nothing left in the cache, where `stop` is asked for on the way.
std::optional<Scene> demo(DemoName name, Sex sex, const std::filesystem::path& cacheFolder,
                          const std::stop_token& stop);

/// Its file in that folder.
std::string demoCacheFile(DemoName name, Sex sex);

}  // namespace sline::model
