// SPDX-License-Identifier: Apache-2.0
// Decides what each frame of a film shows, before anything is drawn.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "model/camera/camera_flight.h"
#include "model/edit/blend.h"
#include "render/export/motion/film_options.h"
#include "render/export/motion/turntable.h"
#include "render/export/order/export_order.h"

namespace sline::render {

int filmFrames(const FilmOptions& options);

struct FilmFrame {
  model::Scene scene;
  model::Camera camera;
  std::string viewName;  ///< as ExportOrder::viewName
  bool moving = false;   ///< the camera is on its way
  /// A tour rests at that view, counted from 0. Where a tour does not rest it flies.
  std::optional<std::size_t> rest = {};
  model::ViewWords words = {};  ///< as ExportOrder::words
  /// Of a tour: the view whose name and words those are, counted from 0.
  std::optional<std::size_t> view = {};
};

/// What is said from one time of a film to another, seconds.
struct FilmCue {
  double begin = 0.0;
  double end = 0.0;
  model::ViewWords words;
};

class Film {
 public:
  /// Creates the film. The error says what it lacks: views for a tour, time for its rests. `share`
  /// is as for Turntable.
  static Result<Film> create(const ExportOrder& order, const glm::vec2& share = glm::vec2(1.0f));

  int frames() const { return m_frames; }
  int framesPerSecond() const { return m_framesPerSecond; }
  /// Returns what `filmSize` returns.
  glm::ivec2 size() const { return m_size; }
  /// Tells whether the first frame follows the last like any other: no frame is doubled.
  bool loops() const { return std::holds_alternative<Turn>(m_motion); }
  /// Tells whether it goes from view to view, and rests at each.
  bool tours() const { return std::holds_alternative<Tour>(m_motion); }
  FilmFrame at(int frame) const;
  /// Returns what is said in the film, in its order: in a tour each view's words, for as long as
  /// its frames have its name.
  std::vector<FilmCue> cues() const;

 private:
  struct Turn {
    model::Scene scene;
    Turntable table;
  };
  struct Leg {
    model::SceneBlend blend;
    model::CameraFlight flight;
  };
  struct Said {
    std::string name;
    model::ViewWords words;
  };
  struct Tour {
    std::vector<Leg> legs;
    std::vector<double> rests;   ///< how long it rests at each view, seconds
    std::vector<double> leaves;  ///< when each leg begins, seconds
    double way = 0.0;            ///< seconds between two views
    std::vector<Said> said;      ///< by each view
    FilmFrame first;
    /// Returns the view, where the film rests there.
    std::optional<std::size_t> restAt(std::size_t view) const;
  };
  struct Sweep {
    model::Scene scene;
    model::Camera camera;
    std::string viewName;
    model::ViewWords words;
    std::vector<model::NodeId> swept;
    double hold = 0.0;  ///< of all frames, at either end
  };
  Film() = default;
  static Result<Tour> tourOf(const ExportOrder& order);
  static Result<Sweep> sweepOf(const ExportOrder& order);
  FilmFrame atTime(const Tour& tour, double seconds) const;
  FilmFrame atPart(const Sweep& sweep, double part) const;

  std::variant<std::monostate, Turn, Tour, Sweep> m_motion;
  int m_frames = 0;
  int m_framesPerSecond = 0;
  glm::ivec2 m_size{0};
};

}  // namespace sline::render
