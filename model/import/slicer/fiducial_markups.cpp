// SPDX-License-Identifier: Apache-2.0
// Reads .mrk.json: 3D Slicer's markups, of which points and lines are imported.
#include <algorithm>
#include <array>
#include <cmath>

#include "model/import/slicer/fiducial_files.h"
#include "model/scene_json/json_value.h"

namespace sline::model {

namespace {

constexpr std::array<std::string_view, 4> frameNames{"LPS", "RAS", "1", "0"};

class MarkupsReader {
 public:
  MarkupsReader(const std::filesystem::path& file, const std::string& name)
      : m_file(file.string()), m_name(name) {}

  Fiducials read(const JsonValue& root) {
    JsonObject object(root);
    object.need("markups").forEach([this](const JsonValue& value) { markup(value); });
    return std::move(m_all);
  }

 private:
  void warn(std::string reason) { m_all.warnings.push_back({m_file, std::move(reason)}); }

  void markup(const JsonValue& value) {
    JsonObject object(value);
    const std::string type = object.need("type").text();
    if (type != "Fiducial" && type != "PointList" && type != "Line") {
      warn("a markup of type \"" + type + "\" was left out: only points and lines come over");
      return;
    }
    Fiducial model{.frame = Frame::lps};
    if (const auto system = object.take("coordinateSystem")) {
      const auto index = system->oneOf(frameNames);
      if (!index)
        system->fail("the coordinate system is neither LPS nor RAS");
      model.frame = index.value_or(0) % 2 == 0 ? Frame::lps : Frame::ras;
    }
    double unit = 1.0;
    if (const auto units = object.take("coordinateUnits"))
      unit = millimetres(*units);
    if (const auto locked = object.take("locked"))
      model.locked = locked->flag();
    std::optional<Colour> colours[2];
    if (const auto display = object.take("display"))
      model.visible = readDisplay(*display, colours);
    model.text = m_name;
    if (const auto name = object.take("name"))
      model.text = name->text();
    std::vector<Fiducial> points;
    if (const auto list = object.take("controlPoints"))
      list->forEach([&](const JsonValue& one) {
        if (auto point = controlPoint(one, model, unit)) {
          point->colour = colours[point->selected ? 1 : 0];
          points.push_back(std::move(*point));
        }
      });
    if (type == "Line")
      addLine(points, model.text);
    else
      std::move(points.begin(), points.end(), std::back_inserter(m_all.items));
  }

  /// Returns the length of "mm", or of a code: ["mm", "UCUM", "millimeter"].
  static double millimetres(const JsonValue& value) {
    const Json& json = value.json();
    const bool coded = json.is_array() && !json.empty();
    const JsonValue unit = coded ? JsonValue(json[0], value, std::size_t(0)) : value;
    static constexpr std::array<std::string_view, 4> names{"mm", "um", "cm", "m"};
    static constexpr std::array<double, 4> lengths{1.0, 0.001, 10.0, 1000.0};
    const auto index = unit.oneOf(names);
    if (!index)
      unit.fail("the unit is none of mm, um, cm and m");
    return lengths[index.value_or(0)];
  }

  static std::optional<Colour> colour(const JsonValue& value) {
    const glm::vec3 rgb = value.point();
    const auto channel = [](float x) {
      return std::uint8_t(std::lround(255.0f * std::clamp(x, 0.0f, 1.0f)));
    };
    return Colour{channel(rgb.x), channel(rgb.y), channel(rgb.z)};
  }

  static bool readDisplay(const JsonValue& value, std::optional<Colour> (&colours)[2]) {
    JsonObject object(value);
    if (const auto plain = object.take("color"))
      colours[0] = colour(*plain);
    if (const auto selected = object.take("selectedColor"))
      colours[1] = colour(*selected);
    const auto visible = object.take("visibility");
    return !visible || visible->flag();
  }

  /// Returns a point, or nothing where the user has not set it yet.
  static std::optional<Fiducial> controlPoint(const JsonValue& value, const Fiducial& model,
                                              double unit) {
    JsonObject object(value);
    if (const auto status = object.take("positionStatus"); status && status->text() != "defined")
      return std::nullopt;
    Fiducial point = model;
    point.places = {glm::dvec3(object.need("position").point()) * unit};
    const auto label = object.take("label");
    point.text = label ? label->text() : std::string();
    if (const auto selected = object.take("selected"))
      point.selected = selected->flag();
    if (const auto visible = object.take("visibility"))
      point.visible = visible->flag() && point.visible;
    if (const auto locked = object.take("locked"))
      point.locked = locked->flag() || point.locked;
    return point;
  }

  void addLine(const std::vector<Fiducial>& points, const std::string& name) {
    if (points.size() != 2) {
      warn("a line of " + std::to_string(points.size()) + " points was left out");
      return;
    }
    Fiducial line = points[0];
    line.kind = AnnotationKind::distance;
    line.places.push_back(points[1].places[0]);
    line.text = name;
    m_all.items.push_back(std::move(line));
  }

  std::string m_file;
  std::string m_name;
  Fiducials m_all;
};

}  // namespace

Result<Fiducials> fiducialsInMarkups(std::string_view text, const std::filesystem::path& file,
                                     const std::string& name) {
  const auto placed = [&file](Error error) {
    error.file = file.string();
    error.remedy = "Save the markups again in 3D Slicer";
    return error;
  };
  const Result<Json> json = parseJson(text);
  if (!json)
    return placed(json.error());
  JsonFault fault;
  Fiducials all = MarkupsReader(file, name).read(JsonValue(*json, fault));
  if (fault.any())
    return placed({.where = fault.where, .reason = fault.reason});
  return all;
}

}  // namespace sline::model
