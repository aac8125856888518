// SPDX-License-Identifier: Apache-2.0
#include "widgets/figure/figure_desk.h"

#include <system_error>
#include <utility>

#include "model/figure/figure_edit.h"
#include "model/figure/figure_file.h"
#include "model/figure/figure_layout.h"
#include "model/look/opening_look.h"
#include "model/scene_file/scene_file.h"

namespace sline::widgets {

namespace {

bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code unknown;
  return !a.empty() && !b.empty() && std::filesystem::equivalent(a, b, unknown);
}

/// Reads a scene for printing, of which nothing may be missing in silence.
Result<model::SceneDocument> wholeScene(const std::filesystem::path& file) {
  Result<model::SceneDocument> document = model::readSceneFile(file);
  if (!document.ok() || document->leftOut.empty())
    return document;
  return Error{.file = file.string(),
               .reason = "something in it is at fault: " + document->leftOut.front(),
               .remedy = "Open it by itself and save it under another name"};
}

}  // namespace

FigureDesk::FigureDesk(OpenScene open) : m_open(std::move(open)) {
  const std::string name = m_open.file.filename().string();
  m_figure = model::figureOf(*m_open.scene, name);
  m_saved = m_figure;
  m_scenes[name] = m_open.scene;
  m_paths[name] = m_open.file;
}

const model::Scene* FigureDesk::sceneOfPanel(std::size_t index) const {
  for (std::size_t step = 0; step < m_figure.panels.size(); ++step) {
    const auto& inset = m_figure.panels[index].inset;
    const auto of = inset ? model::panelOfLetter(m_figure, inset->of) : std::nullopt;
    if (!of)
      break;
    index = *of;
  }
  const auto found = m_scenes.find(model::sceneOf(m_figure, m_figure.panels[index]));
  return found == m_scenes.end() ? nullptr : found->second.get();
}

Result<FigureDesk> FigureDesk::read(const OpenScene& open, const std::filesystem::path& file) {
  model::Figure figure = TRY(model::readFigure(file));
  FigureDesk desk(open);
  desk.m_scenes.clear();
  desk.m_paths.clear();
  for (const model::FigurePanel& panel : figure.panels) {
    const std::string& name = model::sceneOf(figure, panel);
    if (panel.inset || desk.m_scenes.contains(name))
      continue;
    const std::filesystem::path path = TRY(model::scenePath(file, name));
    desk.m_paths[name] = path;
    if (isSameFile(path, open.file)) {
      desk.m_scenes[name] = open.scene;
      continue;
    }
    model::SceneDocument document = TRY(wholeScene(path));
    desk.m_scenes[name] = std::make_shared<const model::Scene>(model::dressed(document.scene));
  }
  desk.m_figure = figure;
  desk.m_saved = std::move(figure);
  desk.m_file = file;
  return desk;
}

Status FigureDesk::save(const std::filesystem::path& file) {
  FigureDesk named = *this;
  named.m_scenes.clear();
  named.m_paths.clear();
  std::map<std::string, std::string> names;
  for (const auto& [old, path] : m_paths) {
    std::string now = TRY(model::sceneName(file, path));
    named.m_scenes[now] = m_scenes.at(old);
    named.m_paths[now] = path;
    names[old] = std::move(now);
  }
  const auto rename = [&names](std::string& scene) {
    if (const auto found = names.find(scene); found != names.end())
      scene = found->second;
  };
  rename(named.m_figure.scene);
  for (model::FigurePanel& panel : named.m_figure.panels)
    if (!panel.scene.empty())
      rename(panel.scene);
  TRY(model::checkFigure(named.m_figure));
  TRY(model::writeFigure(named.m_figure, file));
  named.m_saved = named.m_figure;
  named.m_file = file;
  *this = std::move(named);
  return Unit{};
}

Status FigureDesk::addScene(const std::filesystem::path& file) {
  model::SceneDocument document = TRY(wholeScene(file));
  std::string name = file.filename().string();
  while (m_scenes.contains(name) && !isSameFile(m_paths[name], file))
    name.insert(0, "_");
  const auto scene = std::make_shared<const model::Scene>(model::dressed(document.scene));
  for (model::FigurePanel panel : model::figureOf(*scene, name).panels) {
    panel.scene = name;
    m_figure = model::withPanel(m_figure, panel);
  }
  m_scenes[name] = scene;
  m_paths[name] = file;
  return Unit{};
}

bool FigureDesk::setOpenScene(std::shared_ptr<const model::Scene> scene) {
  if (*scene == *m_open.scene)
    return false;
  bool shown = false;
  for (auto& [name, held] : m_scenes)
    if (held == m_open.scene) {
      held = scene;
      shown = true;
    }
  m_open.scene = std::move(scene);
  return shown;
}

std::vector<std::filesystem::path> FigureDesk::otherFiles() const {
  std::vector<std::filesystem::path> files;
  for (const auto& [name, path] : m_paths)
    if (!path.empty() && m_scenes.at(name) != m_open.scene)
      files.push_back(path);
  return files;
}

Status FigureDesk::readAgain(const std::filesystem::path& file) {
  model::SceneDocument document = TRY(wholeScene(file));
  for (auto& [name, path] : m_paths)
    if (path == file)
      m_scenes[name] = std::make_shared<const model::Scene>(model::dressed(document.scene));
  return Unit{};
}

}  // namespace sline::widgets
