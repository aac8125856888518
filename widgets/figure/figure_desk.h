// SPDX-License-Identifier: Apache-2.0
// Holds a figure that is being composed: its scenes, its file, and whether it is saved.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/figure/figure.h"
#include "model/scene/scene.h"
#include "render/export/figure/figure_plan.h"

namespace sline::widgets {

/// The scene that the window has open.
struct OpenScene {
  std::shared_ptr<const model::Scene> scene;
  std::filesystem::path file;  ///< empty: never saved
};

class FigureDesk {
 public:
  /// Begins with a figure of the scene's views.
  explicit FigureDesk(OpenScene open);

  const model::Figure& figure() const { return m_figure; }
  void set(model::Figure figure) { m_figure = std::move(figure); }
  const render::FigureScenes& scenes() const { return m_scenes; }
  /// Returns the scene that the panel shows, also of an inset; null where it has none.
  const model::Scene* sceneOfPanel(std::size_t index) const;
  /// Tells whether there is work that no file has.
  bool modified() const { return m_figure != m_saved; }
  const std::filesystem::path& file() const { return m_file; }

  /// Reads a figure and the scenes that it names; the open one is taken as it is in the window. It
  /// takes long and may run on any thread.
  static Result<FigureDesk> read(const OpenScene& open, const std::filesystem::path& file);
  /// Writes the figure; scenes are named from its folder, in which or below which they must lie.
  Status save(const std::filesystem::path& file);
  /// Takes the scene that the window has open as it is now; returns false where no panel could show
  /// it or it is the same.
  bool setOpenScene(std::shared_ptr<const model::Scene> scene);
  /// Returns the scene files that panels show, without that which the window has open.
  std::vector<std::filesystem::path> otherFiles() const;
  /// Reads the scene file again. It takes long.
  Status readAgain(const std::filesystem::path& file);
  /// Adds a panel of each view of another scene file. It takes long.
  Status addScene(const std::filesystem::path& file);

 private:
  OpenScene m_open;
  model::Figure m_figure;
  model::Figure m_saved;
  std::filesystem::path m_file;
  render::FigureScenes m_scenes;
  std::map<std::string, std::filesystem::path> m_paths;  ///< of the scenes' files
};

}  // namespace sline::widgets
