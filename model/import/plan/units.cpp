// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <tuple>

#include "model/anatomy/expected_sizes.h"
#include "model/scene/known_frame.h"

namespace sline::model {

namespace {

constexpr float millimetre = 1.0f;

/// How much a unit may be mistaken: cm, inches, m, and voxels of a hundredth of a metre.
constexpr std::array<float, 8> mistakes{10.0f, 1000.0f, 25.4f, 100.0f,
                                        0.1f,  0.001f,  0.01f, 1.0f / 25.4f};

/// A structure beyond the known sizes by more than this is told even where no unit makes it right.
constexpr float farBeyond = 1.5f;

/// What is cut out of a body, all together, is as large as this if its unit is a millimetre.
constexpr Limits<float> ofABody{2.0f, 3000.0f};

/// Sets the length of a part's unit, from what its file says, and where it says so.
void ownUnit(Part& part, const ImportOptions& options, bool ofSlicer) {
  std::string& reason = part.provenance.unitReason;
  part.unit = part.frame == Frame::file ? millimetre : part.raw.millimetresPerUnit;
  if (part.frame == Frame::file) {
    const bool told = !part.raw.unitReason.empty() && part.raw.millimetresPerUnit == millimetre;
    reason = told ? part.raw.unitReason : "coordinates left as they are";
  } else if (part.choice.unit || options.unit) {
    part.unit = part.choice.unit ? *part.choice.unit : *options.unit;
    reason = chosenReason;
    part.provenance.unitEvidence = Evidence::settled;
  } else if (!part.raw.unitReason.empty()) {
    reason = part.raw.unitReason;
  } else {
    reason = ofSlicer ? "scene of Slicer: millimetres" : "no unit in the file: millimetres assumed";
  }
}

/// Lengths that files are written in, the likeliest first.
constexpr std::array<float, 5> usual{millimetre, 10.0f, 1000.0f, 25.4f, 0.001f};

/// Returns the place of the length among the usual ones; their number for any other.
int oddness(float millimetres) {
  const auto found = std::find_if(usual.begin(), usual.end(), [millimetres](float each) {
    return std::abs(millimetres / each - 1.0f) < 1e-3f;
  });
  return int(found - usual.begin());
}

/// Keeps the first two of the usual lengths, or the first two of others where none is usual.
void keepLikely(std::vector<float>& units) {
  constexpr std::size_t most = 2;
  if (oddness(units.front()) < int(usual.size()))
    std::erase_if(units, [](float unit) { return oddness(unit) == int(usual.size()); });
  units.resize(std::min(units.size(), most));
}

/// Returns the length without what rounding has left of a product.
float rounded(float millimetres) {
  const float steps = millimetres < millimetre ? 1e7f : 1e4f;
  return std::round(millimetres * steps) / steps;
}

std::string shortText(float value) {
  std::ostringstream text;
  text.precision(3);
  text << value;
  return value >= 1000.0f ? std::to_string(std::lround(value)) : text.str();
}

/// A structure whose name tells how large it is.
struct NamedSize {
  std::size_t part = 0;
  float extent = 0.0f;  ///< mm, by the unit that was decided
  Limits<float> expected;
};

using NamedSizes = std::vector<NamedSize>;

std::size_t fitting(const NamedSizes& sizes, float factor) {
  return std::size_t(std::count_if(sizes.begin(), sizes.end(), [factor](const NamedSize& size) {
    return size.expected.contain(size.extent * factor);
  }));
}

bool isFarBeyond(const NamedSize& size) {
  return size.extent < size.expected.low / farBeyond ||
         size.extent > size.expected.high * farBeyond;
}

/// Returns what speaks against the unit; nothing where most sizes are right, or no other unit makes
/// clearly more of them right.
std::optional<UnitDoubt> doubtOf(const NamedSizes& sizes, float unit) {
  if (sizes.empty())
    return std::nullopt;
  UnitDoubt doubt{.named = sizes.size(), .fitting = fitting(sizes, 1.0f), .unit = unit};
  std::size_t best = 0;
  for (const float factor : mistakes)
    best = std::max(best, fitting(sizes, factor));
  if (best >= 2 * doubt.fitting + 1) {
    for (const float factor : mistakes)
      if (fitting(sizes, factor) == best)
        doubt.units.push_back(rounded(unit * factor));
    std::stable_sort(doubt.units.begin(), doubt.units.end(),
                     [](float a, float b) { return oddness(a) < oddness(b); });
    keepLikely(doubt.units);
    doubt.fittingThen = best;
  } else if (doubt.fitting > 0 || !std::all_of(sizes.begin(), sizes.end(), isFarBeyond)) {
    return std::nullopt;
  }
  return doubt;
}

class UnitDecision {
 public:
  UnitDecision(std::vector<Part>& parts, const Sources& sources, const ImportOptions& options,
               ImportReport& report)
      : m_parts(parts), m_sources(sources), m_options(options), m_report(report) {}

  void run() {
    // Files of one source that say the same of their unit have most likely the same one.
    std::map<std::tuple<std::size_t, std::string, float>, NamedSizes> alike;
    for (std::size_t i = 0; i < m_parts.size(); ++i) {
      Part& part = m_parts[i];
      ownUnit(part, m_options, m_sources.files[part.file].model.has_value());
      if (const auto size = namedSize(i))
        alike[{m_sources.files[part.file].source, part.provenance.unitReason, part.unit}].push_back(
            *size);
    }
    for (const auto& [of, sizes] : alike)
      if (std::optional<UnitDoubt> doubt = doubtOf(sizes, std::get<float>(of)))
        tell(std::move(*doubt), sizes,
             [this, &of = of](const Part& part) { return isAlike(part, of); });
      else
        doubtFilesOf(sizes, std::get<float>(of));
    doubtOddWholes(alike);
  }

 private:
  template <class Alike>
  bool isAlike(const Part& part, const Alike& of) const {
    return part.provenance.unitReason == std::get<std::string>(of) &&
           part.unit == std::get<float>(of) &&
           m_sources.files[part.file].source == std::get<std::size_t>(of);
  }

  bool isSettled(const Part& part) const {
    return part.raw.molecule || part.frame == Frame::file || part.choice.unit || m_options.unit;
  }

  std::optional<NamedSize> namedSize(std::size_t index) {
    const Part& part = m_parts[index];
    if (part.raw.molecule || part.raw.positions.empty())
      return std::nullopt;
    const std::optional<Limits<float>> expected = m_expected.of(part.name);
    if (!expected)
      return std::nullopt;
    Box box;
    for (const glm::vec3& p : part.raw.positions)
      box.add(p);
    const glm::vec3 size = box.size();
    if (!(std::min({size.x, size.y, size.z}) > 0.0f))
      m_report.warnings.push_back(
          {part.provenance.file, "\"" + part.name + "\" is flat: it has no extent in a direction"});
    if (isSettled(part))
      return std::nullopt;
    return NamedSize{index, std::max({size.x, size.y, size.z}) * part.unit, *expected};
  }

  /// Doubts single files among others whose sizes are right. A volume's unit holds for all of it,
  /// and what a scanner wrote is in millimetres: a small piece is then a small piece.
  void doubtFilesOf(const NamedSizes& sizes, float unit) {
    std::map<std::size_t, NamedSizes> byFile;
    for (const NamedSize& size : sizes)
      if (m_parts[size.part].raw.unitReason.empty())
        byFile[m_parts[size.part].file].push_back(size);
    for (const auto& [file, own] : byFile)
      if (std::optional<UnitDoubt> doubt = doubtOf(own, unit)) {
        doubt->file = m_parts[own.front().part].provenance.file;
        tell(std::move(*doubt), own, [file = file](const Part& part) { return part.file == file; });
      }
  }

  /// Doubts millimetres that were only assumed of files that together are as large as no body's
  /// parts are, where no name says that they may be.
  template <class NamesOfSources>
  void doubtOddWholes(const NamesOfSources& alike) {
    std::map<std::size_t, std::pair<Box, std::vector<Part*>>> wholes;
    for (Part& part : m_parts) {
      const auto& file = m_sources.files[part.file];
      if (part.raw.molecule || isSettled(part) || !part.raw.unitReason.empty() || file.model ||
          !isSure(part.provenance.unitEvidence))
        continue;
      auto& [box, parts] = wholes[file.source];
      parts.push_back(&part);
      for (const glm::vec3& p : part.raw.positions)
        box.add(part.unit * p);
    }
    for (const auto& [of, sizes] : alike)
      if (fitting(sizes, 1.0f) > 0)
        wholes.erase(std::get<std::size_t>(of));
    for (const auto& [source, whole] : wholes)
      if (const glm::vec3 size = whole.first.size();
          !ofABody.contain(std::max({size.x, size.y, size.z})))
        for (Part* part : whole.second)
          part->provenance.unitEvidence = Evidence::assumed;
  }

  /// Tells whether nobody needs to be asked for the unit: a person or the file has stated it.
  bool isStated(const Part& part) const {
    return isSettled(part) || isUnitStated(part.raw.unitReason);
  }

  template <class Of>
  void tell(UnitDoubt doubt, const NamedSizes& sizes, const Of& isOf) {
    const auto wrong = std::find_if(sizes.begin(), sizes.end(), [](const NamedSize& size) {
      return !size.expected.contain(size.extent);
    });
    doubt.name = m_parts[wrong->part].name;
    doubt.extent = wrong->extent;
    doubt.expected = wrong->expected;
    if (isStated(m_parts[wrong->part])) {
      doubt.stated = m_parts[wrong->part].raw.unitReason;
      m_report.warnings.push_back({doubt.file, doubt.text()});
      return;
    }
    for (Part& part : m_parts)
      if (isOf(part) && !isSettled(part) && isSure(part.provenance.unitEvidence)) {
        part.provenance.unitEvidence = Evidence::conflict;
        part.provenance.unitReason += "; sizes are not those of what is named";
      }
    m_report.warnings.push_back({doubt.file, doubt.text()});
    m_report.unitDoubts.push_back(std::move(doubt));
  }

  std::vector<Part>& m_parts;
  const Sources& m_sources;
  const ImportOptions& m_options;
  ImportReport& m_report;
  ExpectedSizes m_expected;
};

}  // namespace

std::string UnitDoubt::text() const {
  const std::string sizes = shortText(extent) + " mm large, and such structures are " +
                            shortText(expected.low) + " to " + shortText(expected.high) + " mm";
  std::string told = "\"" + name + "\" is " + sizes;
  if (named > 1)
    told = std::to_string(named - fitting) + " of " + std::to_string(named) +
           " structures are not as large as their names say: " + told;
  if (!stated.empty())
    return told + "; its unit is stated (" + stated + ") and was followed";
  if (units.empty())
    return told + "; no usual unit would make it right";
  std::string lengths;
  for (std::size_t i = 0; i < units.size(); ++i)
    lengths += (i == 0 ? "" : " or ") + shortText(units[i]);
  return told + "; it would be right if the file's unit were " + lengths + " mm";
}

void decideUnits(std::vector<Part>& parts, const Sources& sources, const ImportOptions& options,
                 ImportReport& report) {
  UnitDecision(parts, sources, options, report).run();
}

}  // namespace sline::model
