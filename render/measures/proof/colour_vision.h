// SPDX-License-Identifier: Apache-2.0
// Computes how colours look to people who see fewer of them, and how different two colours are.
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "model/base/units.h"
#include "render/raster/image.h"

namespace sline::render {

/// Names ways of seeing colours: as on the screen; printed without colours; with eyes that lack
/// cones for long, middle or short waves.
enum class Vision { normal, grey, protanopia, deuteranopia, tritanopia };
inline constexpr std::size_t visionCount = 5;
inline constexpr std::array<Vision, visionCount> visions{
    Vision::normal, Vision::grey, Vision::protanopia, Vision::deuteranopia, Vision::tritanopia};
/// Returns "normal", "grey", "protanopia" …
const char* nameOf(Vision vision);

/// These convert sRGB to linear light, each channel 0 … 1, and back, rounded.
glm::vec3 linearLightOf(const Colour& colour);
Colour colourOf(const glm::vec3& light);

/// Returns what is seen of a colour in linear light. Grey is luminance (ITU-R BT.709); the others
/// follow Machado, Oliveira, Fernandes 2009 ("A physiologically-based model for simulation of color
/// vision deficiency") at full strength.
glm::vec3 simulateVision(const glm::vec3& light, Vision vision);
/// Returns the whole picture as it is seen that way; alpha stays.
Image simulateVision(const Image& image, Vision vision);

/// Returns CIE L*a*b* for the white of sRGB, D65.
glm::dvec3 labOf(const glm::vec3& light);
/// Returns the light of that colour; its channels may lie outside 0 … 1.
glm::vec3 lightOf(const glm::dvec3& lab);
/// Returns CIEDE2000 (Sharma, Wu, Dalal 2005); a difference of about 1 is just noticeable side by
/// side.
double colourDifference(const glm::dvec3& lab, const glm::dvec3& other);

}  // namespace sline::render
