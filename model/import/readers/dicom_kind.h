// SPDX-License-Identifier: Apache-2.0
// Tells from the first kilobytes of a file whether it is DICOM, and which kind of object it holds.
// Nothing here needs DICOM's own reader, so that code that only sorts files does not either.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace sline::model {

inline constexpr std::string_view structureSetClass = "1.2.840.10008.5.1.4.1.1.481.3";
inline constexpr std::string_view segmentationClass = "1.2.840.10008.5.1.4.1.1.66.4";
inline constexpr std::string_view labelMapClass = "1.2.840.10008.5.1.4.1.1.66.7";

/// Returns the name of a kind of object (PS3.4 §B.5): "CT image", "RT plan"; empty for kinds not
/// listed.
std::string_view objectName(std::string_view sopClass);
/// Returns true for segmentations of both kinds and RT structure sets.
bool holdsStructures(std::string_view sopClass);
/// Returns "CT", "MR" or "PET" for the kinds with slices that make a volume of grey values; empty
/// for others.
std::string_view scannerOf(std::string_view sopClass);

/// Returns true where the first bytes of a file say DICOM: "DICM" behind a preamble of 128 bytes,
/// or no preamble and a first element of group 2 or 8.
bool beginsLikeDicom(std::string_view text);
/// Returns true for a file that says in its first bytes that it is DICOM: by "DICM" whatever it is
/// called, by a first element where it has no extension, or numbers for one.
bool mayBeDicom(const std::filesystem::path& file);
/// Returns the kind of object from the first kilobytes of a file; empty where they do not tell.
std::string sopClassOf(const std::filesystem::path& file);

}  // namespace sline::model
