// SPDX-License-Identifier: Apache-2.0
#include "model/import/dicom/structure_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <utility>

#include "model/import/contours/contour_stack.h"
#include "model/import/contours/contour_surface.h"
#include "model/import/contours/stack_sampling.h"

namespace sline::model {

namespace {

constexpr Tag roiNumber{0x3006, 0x0022};
constexpr Tag roiName{0x3006, 0x0026};
constexpr Tag displayColour{0x3006, 0x002a};
constexpr Tag geometricType{0x3006, 0x0042};
constexpr Tag slabThickness{0x3006, 0x0044};
constexpr Tag contourData{0x3006, 0x0050};
constexpr Tag referencedRoi{0x3006, 0x0084};
constexpr Tag interpretedType{0x3006, 0x00a4};

/// No contour is drawn farther from the scanner's origin, mm.
constexpr double farthestPoint = 1e5;
/// The thickness of a single slice where neither neighbours nor the file tell it, mm.
constexpr double assumedSpacing = 1.0;
/// The samples of all regions together: an export of an RT workstation needs about a third of it.
constexpr double mostSamplesOfAll = 1.2e7;
constexpr const char* enclosesNothing = "its contours enclose nothing; left out";

struct RegionOfInterest {
  std::int64_t number = 0;
  std::string name;
  std::vector<std::string> groups;
  std::optional<Colour> colour;
  std::vector<Contour> contours;
  double slab = 0.0;          ///< mm; 0: not given
  ContourStacks stacks;       ///< made from the contours, which are then released
  std::size_t notClosed = 0;  ///< points and open lines
  std::size_t broken = 0;     ///< contours with numbers that make no polygon
};

/// Returns the group in which a reader of plans looks for an RT ROI Interpreted Type (PS3.3
/// §C.8.8.8).
std::string groupOf(std::string_view type) {
  struct Row {
    std::string_view type;
    const char* group;
  };
  constexpr std::array rows = {Row{"GTV", "Targets"},
                               Row{"CTV", "Targets"},
                               Row{"PTV", "Targets"},
                               Row{"ITV", "Targets"},
                               Row{"TREATED_VOLUME", "Targets"},
                               Row{"IRRAD_VOLUME", "Targets"},
                               Row{"ORGAN", "Organs at risk"},
                               Row{"AVOIDANCE", "Organs at risk"},
                               Row{"CAVITY", "Organs at risk"},
                               Row{"EXTERNAL", "External"},
                               Row{"SUPPORT", "Devices"},
                               Row{"FIXATION", "Devices"},
                               Row{"BOLUS", "Devices"},
                               Row{"BRACHY_CHANNEL", "Devices"},
                               Row{"BRACHY_ACCESSORY", "Devices"},
                               Row{"BRACHY_SRC_APP", "Devices"},
                               Row{"BRACHY_CHNL_SHLD", "Devices"},
                               Row{"MARKER", "Markers"},
                               Row{"REGISTRATION", "Markers"},
                               Row{"ISOCENTER", "Markers"}};
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const Row& r) { return r.type == type; });
  return row == rows.end() ? std::string() : row->group;
}

std::optional<Colour> colourIn(const DataSet& set) {
  const auto values = set.decimals(displayColour, 3);
  if (!values)
    return std::nullopt;
  std::array<std::uint8_t, 3> channels{};
  for (std::size_t i = 0; i < 3; ++i) {
    if ((*values)[i] < 0.0 || (*values)[i] > 255.0)
      return std::nullopt;
    channels[i] = std::uint8_t(std::lround((*values)[i]));
  }
  return Colour{channels[0], channels[1], channels[2]};
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

class StructureSetReader {
 public:
  StructureSetReader(const DicomFile& file, const ReadOptions& options)
      : m_file(file), m_options(options) {}

  Result<RawMeshes> read() {
    readNames();
    readTypes();
    readContours();
    const double spacing = commonSpacing();
    double samples = 0.0;
    for (RegionOfInterest& region : m_regions) {
      stack(region, spacing);
      for (const ContourStack& part : region.stacks.stacks)
        samples += samplesFor(part);
    }
    const double share = std::min(1.0, mostSamplesOfAll / std::max(samples, 1.0));
    for (RegionOfInterest& region : m_regions) {
      TRY(addSurface(region, share));
      region.stacks = {};
    }
    if (m_result.meshes.empty())
      return m_file.source().whole(nothingText(), "Export the structure set with its contours");
    return std::move(m_result);
  }

 private:
  std::string nothingText() const {
    if (m_regions.empty())
      return "the structure set names no region of interest";
    return "none of the structure set's " +
           counted(m_regions.size(), "region of interest", "regions of interest") +
           " has closed planar contours that enclose anything";
  }
  void warn(const RegionOfInterest& region, const std::string& reason) {
    m_result.warnings.push_back(m_file.source().warning("\"" + region.name + "\": " + reason));
  }

  void readNames() {
    for (const DataSet& item : m_file.data().items(structureSetRois)) {
      const std::optional<std::int64_t> number = item.integer(roiNumber);
      if (!number || m_byNumber.contains(*number))
        continue;
      RegionOfInterest region;
      region.number = *number;
      region.name = item.utf8(roiName);
      if (region.name.empty())
        region.name = "Structure " + std::to_string(*number);
      m_byNumber[*number] = m_regions.size();
      m_regions.push_back(std::move(region));
    }
  }

  RegionOfInterest* regionOf(const DataSet& item) {
    const std::optional<std::int64_t> number = item.integer(referencedRoi);
    const auto found = number ? m_byNumber.find(*number) : m_byNumber.end();
    return found == m_byNumber.end() ? nullptr : &m_regions[found->second];
  }

  void readTypes() {
    for (const DataSet& item : m_file.data().items(observations))
      if (RegionOfInterest* region = regionOf(item))
        if (std::string group = groupOf(item.text(interpretedType)); !group.empty())
          region->groups = {std::move(group)};
  }

  void readContours() {
    for (const DataSet& item : m_file.data().items(roiContours)) {
      RegionOfInterest* region = regionOf(item);
      if (!region)
        continue;
      region->colour = colourIn(item);
      for (const DataSet& contour : item.items(contourSequence))
        addContour(*region, contour);
    }
  }

  static void addContour(RegionOfInterest& region, const DataSet& item) {
    const std::string type = item.text(geometricType);
    if (type != "CLOSED_PLANAR" && type != "CLOSEDPLANAR_XOR") {
      ++region.notClosed;
      return;
    }
    if (const auto slab = item.decimal(slabThickness); slab && *slab > 0.0)
      region.slab = std::min(*slab, 1000.0);
    const auto numbers = item.decimals(contourData);
    const bool sound = numbers && numbers->size() >= 9 && numbers->size() % 3 == 0 &&
                       std::all_of(numbers->begin(), numbers->end(),
                                   [](double x) { return std::abs(x) <= farthestPoint; });
    if (!sound) {
      ++region.broken;
      return;
    }
    Contour contour;
    contour.reserve(numbers->size() / 3);
    for (std::size_t i = 0; i < numbers->size(); i += 3)
      contour.emplace_back((*numbers)[i], (*numbers)[i + 1], (*numbers)[i + 2]);
    region.contours.push_back(std::move(contour));
  }

  /// Returns the spacing of the region with the most contours: the slices of one image series lie
  /// alike.
  double commonSpacing() const {
    const auto most = std::max_element(m_regions.begin(), m_regions.end(),
                                       [](const RegionOfInterest& a, const RegionOfInterest& b) {
                                         return a.contours.size() < b.contours.size();
                                       });
    return most == m_regions.end() ? 0.0 : usualSpacing(most->contours);
  }

  void stack(RegionOfInterest& region, double spacing) {
    if (region.broken > 0)
      warn(region, counted(region.broken, "contour has", "contours have") +
                       " no three points or numbers that are none; left out");
    if (region.contours.empty()) {
      warn(region, region.notClosed > 0 ? "holds points or open lines only; left out"
                                        : "has no contour; left out");
      return;
    }
    if (region.notClosed > 0)
      warn(region,
           counted(region.notClosed, "point or open line", "points or open lines") + " left out");
    const double single = region.slab > 0.0 ? region.slab : spacing;
    region.stacks = stacksOf(region.contours, single > 0.0 ? single : assumedSpacing);
    region.contours = {};
    tellOf(region, region.stacks);
    tellOfOneSlice(region, spacing);
    if (region.stacks.stacks.empty())
      warn(region, enclosesNothing);
  }

  Status addSurface(const RegionOfInterest& region, double share) {
    if (region.stacks.stacks.empty())
      return Unit{};
    RawMesh mesh;
    for (const ContourStack& part : region.stacks.stacks)
      if (!append(mesh, surfaceOf(part, share * samplesFor(part), m_options)))
        return m_file.source().whole("makes a surface of more points than the limit allows",
                                     "Leave out structures");
    if (!m_options.goesOn())
      return m_file.source().whole("was not read to its end");
    if (mesh.triangles.empty()) {
      warn(region, enclosesNothing);
      return Unit{};
    }
    mesh.name = region.name;
    mesh.groups = region.groups;
    mesh.origin = "DICOM structure set";
    mesh.colour = region.colour;
    mesh.frame = Frame::lps;
    mesh.frameReason = "DICOM: patient coordinates";
    mesh.unitReason = dicomUnit;
    m_result.meshes.push_back(std::move(mesh));
    return Unit{};
  }

  void tellOf(const RegionOfInterest& region, const ContourStacks& stacks) {
    if (stacks.outOfPlane > 0)
      warn(region, counted(stacks.outOfPlane, "contour lies", "contours lie") +
                       " in another plane than most; left out");
    if (stacks.repeated > 0)
      warn(region, counted(stacks.repeated, "contour", "contours") + " given twice left out");
    if (stacks.missing > 0)
      warn(region, counted(stacks.missing, "slice", "slices") +
                       " without a contour between others; the surface bridges them");
    if (stacks.stacks.size() > 1)
      warn(region, "made of " + std::to_string(stacks.stacks.size()) +
                       " pieces: too many slices between them have no contour (up to " +
                       std::to_string(std::lround(stacks.widestGap)) + " mm)");
  }

  /// Says how thick what was drawn on one slice became, and what told it.
  void tellOfOneSlice(const RegionOfInterest& region, double spacing) {
    const std::vector<ContourStack>& stacks = region.stacks.stacks;
    if (stacks.size() != 1 || stacks.front().slices.size() != 1)
      return;
    std::ostringstream thickness;
    thickness << stacks.front().spacing;
    warn(region, "is drawn on one slice; made " + thickness.str() + " mm thick, " +
                     (region.slab > 0.0 ? "as the file says"
                      : spacing > 0.0   ? "as slices of other structures are"
                                        : "which nothing tells"));
  }

  bool append(RawMesh& mesh, const RawMesh& piece) const {
    if (mesh.positions.size() + piece.positions.size() > m_options.limits.vertices ||
        mesh.triangles.size() + piece.triangles.size() > m_options.limits.triangles)
      return false;
    const auto first = std::uint32_t(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), piece.positions.begin(), piece.positions.end());
    for (const auto& [a, b, c] : piece.triangles)
      mesh.triangles.push_back({first + a, first + b, first + c});
    mesh.smooth = true;
    mesh.displacement = std::max(mesh.displacement, piece.displacement);
    return true;
  }

  const DicomFile& m_file;
  const ReadOptions& m_options;
  std::vector<RegionOfInterest> m_regions;
  std::map<std::int64_t, std::size_t> m_byNumber;
  RawMeshes m_result;
};

}  // namespace

Result<RawMeshes> structureSetSurfaces(const DicomFile& file, const ReadOptions& options) {
  return StructureSetReader(file, options).read();
}

}  // namespace sline::model
