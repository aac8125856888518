// SPDX-License-Identifier: Apache-2.0
#include "model/import/volumes/formats/netcdf_header.h"

#include <algorithm>
#include <bit>

namespace sline::model {

namespace {

constexpr bool swapNetcdf = std::endian::native != std::endian::big;

/// Returns the type for 1 … 11; a char is text.
std::optional<ScalarType> netcdfType(std::uint32_t code) {
  static constexpr ScalarType types[] = {
      ScalarType::int8,    ScalarType::uint8,   ScalarType::int16, ScalarType::int32,
      ScalarType::float32, ScalarType::float64, ScalarType::uint8, ScalarType::uint16,
      ScalarType::uint32,  ScalarType::int64,   ScalarType::uint64};
  return code >= 1 && code <= std::size(types) ? std::optional(types[code - 1]) : std::nullopt;
}
constexpr std::uint32_t charCode = 2;

class NetcdfParser {
 public:
  explicit NetcdfParser(const Source& source)
      : m_source(source), m_bytes(source.text()), m_version(std::uint8_t(source.text()[3])) {}

  Result<NetcdfHeader> parse() {
    m_at = 4;
    number();  // number of records
    for (std::uint64_t left = list(10); left > 0 && m_good; --left) {
      NetcdfDimension& dimension = m_header.dimensions.emplace_back();
      dimension.name = name();
      dimension.size = number();
    }
    attributes();
    for (std::uint64_t left = list(11); left > 0 && m_good; --left)
      variable();
    if (!m_good)
      return m_source.atByte(m_source.begin() + std::min(m_at, m_bytes.size()),
                             "its header is broken there or ends early");
    return std::move(m_header);
  }

 private:
  std::uint64_t word(std::size_t bytes) {
    if (!m_good || m_bytes.size() - m_at < bytes) {
      m_good = false;
      return 0;
    }
    const char* at = m_bytes.data() + m_at;
    m_at += bytes;
    return bytes == 8 ? loadAs<std::uint64_t>(at, swapNetcdf)
                      : loadAs<std::uint32_t>(at, swapNetcdf);
  }
  /// Reads a count, which only version 5 has in eight bytes.
  std::uint64_t number() { return word(m_version == 5 ? 8 : 4); }

  /// Reads the length of a list; its mark is 0 where the list is absent. Each entry takes some
  /// bytes.
  std::uint64_t list(std::uint64_t mark) {
    const std::uint64_t found = word(4);
    const std::uint64_t count = number();
    if ((found != mark && (found != 0 || count != 0)) || count > m_bytes.size() - m_at)
      m_good = false;
    return m_good ? count : 0;
  }

  /// Reads `size` bytes, filled up to a multiple of four.
  std::string_view padded(std::uint64_t size) {
    if (!m_good || size > m_bytes.size() - m_at) {
      m_good = false;
      return {};
    }
    const std::string_view bytes = m_bytes.substr(m_at, std::size_t(size));
    m_at = std::min(m_bytes.size(), m_at + std::size_t((size + 3) / 4 * 4));
    return bytes;
  }

  std::string name() { return std::string(padded(number())); }

  NetcdfAttributes attributes() {
    NetcdfAttributes all;
    for (std::uint64_t left = list(12); left > 0 && m_good; --left) {
      const std::string key = name();
      NetcdfValues values = typed();
      const std::uint64_t count = number();
      if (!m_good || count > m_bytes.size()) {
        m_good = false;
        break;
      }
      values.count = std::size_t(count);
      values.bytes = padded(count * sizeOf(values.type));
      all[key] = values;
    }
    return all;
  }

  NetcdfValues typed() {
    const std::uint64_t code = word(4);
    const std::optional<ScalarType> type = netcdfType(std::uint32_t(code));
    m_good = m_good && type;
    return {.isText = code == charCode, .type = type.value_or(ScalarType::uint8)};
  }

  void variable() {
    const std::string key = name();
    NetcdfVariable variable;
    std::uint64_t left = number();
    if (left > m_header.dimensions.size())
      m_good = false;
    variable.values.count = 1;
    for (; left > 0 && m_good; --left) {
      const std::uint64_t dimension = number();
      if (dimension >= m_header.dimensions.size()) {
        m_good = false;
        return;
      }
      variable.dimensions.push_back(std::size_t(dimension));
      const std::uint64_t size = m_header.dimensions[std::size_t(dimension)].size;
      const bool fits = size == 0 || variable.values.count <= (std::uint64_t(1) << 40) / size;
      variable.values.count =
          fits ? variable.values.count * std::size_t(size) : std::size_t(1) << 40;
    }
    const std::size_t count = variable.values.count;
    variable.attributes = attributes();
    variable.values = typed();
    variable.values.count = count;
    number();  // number of bytes, which some programs write wrongly
    const std::uint64_t begin = word(m_version == 1 ? 4 : 8);
    if (begin > m_bytes.size())
      m_good = false;
    if (m_good)
      variable.values.bytes = m_bytes.substr(std::size_t(begin));
    m_header.variables[key] = std::move(variable);
  }

  const Source& m_source;
  std::string_view m_bytes;
  std::uint8_t m_version;
  std::size_t m_at = 0;
  bool m_good = true;
  NetcdfHeader m_header;
};

}  // namespace

double NetcdfValues::number(std::size_t i) const {
  const std::size_t size = sizeOf(type);
  if (i >= count || i >= bytes.size() / size)
    return 0.0;
  const char* at = bytes.data() + i * size;
  if (type == ScalarType::float64)
    return loadAs<double>(at, swapNetcdf);
  return type == ScalarType::float32 ? double(loadAs<float>(at, swapNetcdf))
                                     : double(loadInteger(type, at, swapNetcdf));
}

std::string_view NetcdfVariable::text(std::string_view attribute) const {
  const auto found = attributes.find(attribute);
  return found == attributes.end() || !found->second.isText ? std::string_view()
                                                            : found->second.bytes;
}

std::vector<double> NetcdfVariable::numbers(std::string_view attribute,
                                            std::vector<double> otherwise) const {
  const auto found = attributes.find(attribute);
  if (found == attributes.end() || found->second.isText || found->second.count != otherwise.size())
    return otherwise;
  for (std::size_t i = 0; i < otherwise.size(); ++i)
    otherwise[i] = found->second.number(i);
  return otherwise;
}

Result<NetcdfHeader> readNetcdfHeader(const Source& source) {
  const std::string_view text = source.text();
  if (text.size() < 4 || !text.starts_with("CDF") || (text[3] != 1 && text[3] != 2 && text[3] != 5))
    return source.whole("is no netCDF file: it does not begin with its mark");
  return NetcdfParser(source).parse();
}

}  // namespace sline::model
