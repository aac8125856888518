// SPDX-License-Identifier: Apache-2.0
// How colours look to those who see fewer of them, and how far two are apart.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "model/base/units.h"
#include "render/raster/image.h"

namespace sline::render {

/// As on the screen; on a press without colours; to eyes without cones for long, middle or short
/// waves.
enum class Vision { normal, grey, protanopia, deuteranopia, tritanopia };
inline constexpr std::size_t visionCount = 5;
inline constexpr std::array<Vision, visionCount> visions{
    Vision::normal, Vision::grey, Vision::protanopia, Vision::deuteranopia, Vision::tritanopia};
/// "normal", "grey", "protanopia" …
const char* nameOf(Vision vision);

/// sRGB as linear light, each 0 … 1, and back, rounded.
glm::vec3 linearLightOf(const Colour& colour);
Colour colourOf(const glm::vec3& light);

/// What is seen of a colour in linear light. Grey is luminance (ITU-R BT.709); the others are
/// Machado, Oliveira, Fernandes 2009 ("A physiologically-based model for simulation of color vision
/// deficiency") at full strength.
glm::vec3 seen(const glm::vec3& light, Vision vision);
/// The whole picture so; alpha stays.
Image seen(const Image& image, Vision vision);

/// CIE L*a*b* for the white of sRGB, D65.
glm::dvec3 labOf(const glm::vec3& light);
/// The light of that colour; channels may leave 0 … 1.
glm::vec3 lightOf(const glm::dvec3& lab);
/// CIEDE2000 (Sharma, Wu, Dalal 2005): about 1 is just noticed side by side.
double colourDifference(const glm::dvec3& lab, const glm::dvec3& other);

}  // namespace sline::render
