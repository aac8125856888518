// SPDX-License-Identifier: Apache-2.0
#include "model/import/slicer/annotations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec4.hpp>

#include "model/import/slicer/files_and_transforms.h"

namespace sline::model {

namespace {

/// Limits the fiducials, because many nodes may refer to one file.
constexpr std::size_t mostFiducials = 100'000;

bool isFull(const SlicerScene& result) {
  return result.fiducials.size() >= mostFiducials;
}

std::optional<Colour> colourIn(const XmlNode& display, const char* attribute) {
  const auto rgb = numbers(display.attribute(attribute).value(), 3);
  if (!rgb)
    return std::nullopt;
  const auto channel = [](double value) {
    return std::uint8_t(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
  };
  return Colour{channel((*rgb)[0]), channel((*rgb)[1]), channel((*rgb)[2])};
}

class FiducialReader {
 public:
  FiducialReader(const SlicerDocument& document, SlicerScene& result)
      : m_document(document),
        m_result(result),
        m_transforms(document.nodes, document.file.filename().string(), result.warnings) {}

  void read() {
    for (const char* tag : {"AnnotationFiducials", "AnnotationRuler"})
      for (const XmlNode& node : m_document.scene.children(tag))
        annotation(node, std::string_view(tag) == "AnnotationRuler" ? AnnotationKind::distance
                                                                    : AnnotationKind::pin);
    for (const char* tag : {"MarkupsFiducial", "MarkupsLine"})
      for (const XmlNode& node : m_document.scene.children(tag))
        markups(node);
    for (const char* tag : {"MarkupsAngle", "MarkupsCurve", "MarkupsClosedCurve", "MarkupsPlane",
                            "MarkupsROI", "AnnotationROI"})
      if (m_document.scene.child(tag))
        warn(std::string("nodes of kind ") + tag +
             " were left out: only points and lines come over");
    if (isFull(m_result))
      warn("the scene has more than " + std::to_string(mostFiducials) +
           " fiducials; the rest was left out");
  }

 private:
  void warn(std::string reason) {
    m_result.warnings.push_back({m_document.file.filename().string(), std::move(reason)});
  }

  void annotation(const XmlNode& node, AnnotationKind kind) {
    Fiducial fiducial{.kind = kind, .text = node.attribute("name").value()};
    // The points are "x y z|x y z", RAS.
    std::string_view rest = node.attribute("ctrlPtsCoord").value();
    while (!rest.empty() && fiducial.places.size() <= anchorCount(kind)) {
      const std::string_view one = rest.substr(0, rest.find('|'));
      rest.remove_prefix(std::min(rest.size(), one.size() + 1));
      if (const auto place = numbers(one, 3))
        fiducial.places.emplace_back((*place)[0], (*place)[1], (*place)[2]);
    }
    if (fiducial.places.size() != anchorCount(kind)) {
      warn("\"" + fiducial.text + "\" has no place that could be read; it was left out");
      return;
    }
    fiducial.selected = numbers(node.attribute("ctrlPtsSelected").value(), 1) !=
                        std::optional(std::vector<double>{0.0});
    fiducial.locked = flag(node, "locked", false);
    add(node, std::move(fiducial), m_transforms.above(node, node.attribute("name").value()));
  }

  void markups(const XmlNode& node) {
    const std::string name = node.attribute("name").value();
    const XmlNode storage = m_document.nodes.referred(node, "storage");
    const std::string written = storage.attribute("fileName").value();
    if (written.empty()) {
      warn("the markups \"" + name + "\" refer to no file; they were left out");
      return;
    }
    const auto file = fileOfSlicer(m_document.file, written, m_result.warnings);
    if (!file)
      return;
    Result<Fiducials> read = isFiducialFile(*file)
                                 ? readFiducials(*file, {.fileBytes = std::uint64_t(64) << 20})
                                 : Error{.reason = "files of this kind are not supported"};
    if (!read) {
      Error error = read.error();
      error.file.clear();
      m_result.warnings.push_back({file->filename().string(), error.text()});
      return;
    }
    const auto toWorld = m_transforms.above(node, name);
    for (Fiducial& fiducial : read->items) {
      if (fiducial.kind == AnnotationKind::distance && !name.empty())
        fiducial.text = name;
      fiducial.locked = fiducial.locked || flag(node, "locked", false);
      add(node, std::move(fiducial), toWorld);
    }
  }

  void add(const XmlNode& node, Fiducial fiducial, const std::optional<glm::dmat4>& toWorld) {
    if (isFull(m_result))
      return;
    const XmlNode display = m_document.nodes.referred(node, "display");
    if (const auto colour = colourIn(display, fiducial.selected ? "selectedColor" : "color"))
      fiducial.colour = colour;
    fiducial.visible = fiducial.visible && slicerShows(m_document.nodes, node);
    if (toWorld) {
      const double turn = fiducial.frame == Frame::ras ? 1.0 : -1.0;
      for (glm::dvec3& place : fiducial.places)
        place = glm::dvec3(*toWorld * glm::dvec4(turn * place.x, turn * place.y, place.z, 1.0));
      fiducial.frame = Frame::ras;
    }
    m_result.fiducials.push_back(std::move(fiducial));
    m_result.fiducialIds.emplace_back(node.attribute("id").value());
  }

  const SlicerDocument& m_document;
  SlicerScene& m_result;
  SlicerTransforms m_transforms;
};

}  // namespace

bool slicerShows(const SlicerNodes& nodes, const XmlNode& node) {
  return flag(node, "visible", true) && flag(nodes.referred(node, "display"), "visibility", true);
}

void readSlicerFiducials(const SlicerDocument& document, SlicerScene& result) {
  FiducialReader(document, result).read();
}

}  // namespace sline::model
