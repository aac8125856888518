// SPDX-License-Identifier: Apache-2.0
// Reads the numbers of GIFTI arrays: text, base64 and packed.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "model/import/source/source.h"
#include "model/import/source/surface_assembly.h"
#include "model/import/source/values.h"
#include "model/import/source/xml_tags.h"

namespace sline::model {

/// Describes one DataArray: pieces of the file.
struct GiftiArray {
  XmlTag tag;
  std::string_view intent;
  std::string_view data;
  std::string_view space;    ///< the space of the vertices
  std::string_view toSpace;  ///< the space to which the matrix leads
  std::string_view matrix;
};

/// Reads the numbers of an array of three columns, wherever they are.
class GiftiNumbers {
 public:
  GiftiNumbers(const Source& source, const GiftiArray& array) : m_source(source), m_array(array) {}

  Status open();
  std::size_t rows() const { return m_rows; }

  /// Calls put(row, column, values) for each number in the order of the file; `values` gives the
  /// number.
  template <class Put>
  Status each(const Put& put) {
    if (m_text)
      return eachOf(TextValues(m_array.data.data(), m_array.data.data() + m_array.data.size()),
                    put);
    const bool little = m_array.tag.attribute("Endian") != "BigEndian";
    return eachOf(BinaryValues(m_bytes.data(), m_bytes.data() + m_bytes.size(),
                               little ? std::endian::little : std::endian::big),
                  put);
  }

  ScalarType type() const { return m_type; }
  const char* place() const { return m_array.tag.begin(); }

 private:
  Status fault(const std::string& reason, std::string remedy = {}) const {
    return m_source.atLine(place(), "an array " + reason, std::move(remedy));
  }
  Status tooFew(std::uint64_t held) const {
    return fault("promises " + std::to_string(m_rows) + " × 3 numbers, more than its " +
                 std::to_string(held) + " bytes hold");
  }

  Status readShape();
  Status take(std::string bytes);
  Status unpack(const std::string& packed);
  template <class Values, class Put>
  Status eachOf(Values values, const Put& put) const {
    const std::size_t all = 3 * m_rows;
    for (std::size_t i = 0; i < all; ++i) {
      const std::size_t row = m_columnsFirst ? i % m_rows : i / 3;
      const auto column = int(m_columnsFirst ? i / m_rows : i % 3);
      if (!put(row, column, values))
        return fault("has no number as its number " + std::to_string(i + 1));
    }
    return Unit{};
  }

  const Source& m_source;
  const GiftiArray& m_array;
  ScalarType m_type = ScalarType::float32;
  std::size_t m_rows = 0;
  bool m_columnsFirst = false;
  bool m_text = false;
  std::string m_bytes;
};

}  // namespace sline::model
