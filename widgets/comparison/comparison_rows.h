// SPDX-License-Identifier: Apache-2.0
// Holds the models that are compared, as rows, and the camera that all of them share: each is
// looked at from the same side and fills its pictures as much as the others.
#pragma once

#include <vector>

#include "model/camera/camera_moves.h"
#include "render/export/comparison/comparison.h"

namespace sline::widgets {

class ComparisonRows {
 public:
  /// One model of a comparison: its visible structures are drawn.
  struct Model {
    std::string name;
    model::Scene scene;
  };
  static constexpr std::size_t most = 6;

  /// Looks at the models, of which there is at least one, from the camera's direction.
  ComparisonRows(const std::vector<Model>& models, const model::Camera& camera);

  std::size_t count() const { return m_rows.size(); }
  /// Roughens the surfaces that are shown, or shows them as they are.
  void roughen(const std::optional<render::Noise>& noise);
  /// Returns what a row shows, with its camera.
  const render::ComparedModel& shown(std::size_t row) const { return m_rows[row].shown; }
  /// Returns the place about which a row's camera turns.
  const glm::vec3& pivot(std::size_t row) const { return m_rows[row].pivot; }
  /// Returns how far its camera may zoom.
  const model::ZoomEnds& ends(std::size_t row) const { return m_rows[row].ends; }
  /// Gives a row that camera and all others the like.
  void turn(std::size_t row, const model::Camera& camera);
  /// Returns what a sheet shows: each model as it is and, if its surface is roughened, that below.
  std::vector<render::ComparedModel> sheet() const;

 private:
  struct Row {
    render::ComparedModel model;  ///< as it is
    render::ComparedModel shown;  ///< the same or roughened
    glm::vec3 pivot{0.0f};
    model::ZoomEnds ends;
    glm::vec3 target{0.0f};  ///< that of the camera which shows it as large as others, LPS, mm
    float size = 1.0f;       ///< that camera's distance or height, mm
  };

  std::vector<Row> m_rows;
  bool m_rough = false;
};

}  // namespace sline::widgets
