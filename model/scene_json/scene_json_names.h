// SPDX-License-Identifier: Apache-2.0
// Lists words of scene.json that its writer and its reader share, in the order of the values they
// stand for.
#pragma once

#include <array>
#include <string_view>

namespace sline::model {

inline constexpr std::string_view formatName = "sline scene";
inline constexpr std::array<std::string_view, 4> annotationKindNames{"label", "callout", "pin",
                                                                     "distance"};
inline constexpr std::array<std::string_view, 2> projectionNames{"perspective", "orthographic"};

}  // namespace sline::model
