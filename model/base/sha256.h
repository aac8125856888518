// SPDX-License-Identifier: Apache-2.0
// Computes SHA-256 (FIPS 180-4), where nobody may find out what a checksum was made of.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sline {

using Sha256 = std::array<std::uint8_t, 32>;

/// Returns the digest of the bytes.
Sha256 sha256(std::string_view bytes);

/// Returns the first bytes in hexadecimal digits, two for each; at most all 32.
std::string hexDigits(const Sha256& digest, std::size_t bytes = 32);

}  // namespace sline
