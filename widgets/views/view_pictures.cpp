// SPDX-License-Identifier: Apache-2.0
#include "widgets/views/view_pictures.h"

#include <algorithm>

#include "model/edit/views.h"
#include "widgets/gamma/stage_previews.h"

namespace sline::widgets {

namespace {

/// Milliseconds after the last change, because small pictures can wait while something moves.
constexpr int restAfter = 300;
// Pictures are drawn twice as large and averaged, with lines as wide as in a print of that size.
constexpr int samples = 2;
constexpr double penWidth = 0.7;
constexpr std::size_t mostKept = 96;

/// Returns the scene without what cannot be seen: names, the views themselves, and labels, as their
/// letters would be a pixel high.
model::Scene seenAlone(model::Scene scene) {
  scene.setViews({});
  scene.setAnnotations({});
  scene.setUnread({});
  std::vector<model::Node> nodes = scene.nodes();
  for (model::Node& node : nodes) {
    node.name.clear();
    node.unread.clear();
    node.locked = false;
  }
  scene.setNodes(std::move(nodes));
  std::vector<model::Section> sections = scene.sections();
  for (model::Section& section : sections)
    section.name.clear();
  scene.setSections(std::move(sections));
  return scene;
}

}  // namespace

ViewPictures::ViewPictures(Session& session, Viewport& viewport, ViewList& list, QObject* parent)
    : QObject(parent), m_session(session), m_viewport(viewport), m_list(list) {
  m_rest.setSingleShot(true);
  m_rest.setInterval(restAfter);
  const auto restart = [this] { m_rest.start(); };
  connect(&m_rest, &QTimer::timeout, this, &ViewPictures::ask);
  connect(&session, &Session::documentChanged, this, restart);
  connect(&viewport, &Viewport::backgroundChanged, this, restart);
  connect(&viewport, &Viewport::previewed, this, &ViewPictures::took);
}

void ViewPictures::want(std::vector<int> rows, QSize size, double ratio) {
  if (rows == m_rows && size == m_size && ratio == m_ratio)
    return;
  m_rows = std::move(rows);
  m_size = size;
  m_ratio = ratio;
  m_rest.start();
}

ViewPictures::Key ViewPictures::keyOf(int row) const {
  const model::Scene& scene = m_session.scene();
  const model::View& view = scene.views()[std::size_t(row)];
  return {.scene = seenAlone(model::withViewApplied(scene, view).scene),
          .camera = view.camera,
          .environment = m_viewport.environment(),
          .size = m_size};
}

const QImage* ViewPictures::kept(const Key& key) const {
  const auto found = std::find_if(m_kept.begin(), m_kept.end(),
                                  [&key](const Kept& each) { return each.key == key; });
  return found == m_kept.end() ? nullptr : &found->image;
}

PreviewRequest::Preview ViewPictures::previewOf(int id, const Key& key) const {
  const int height = samples * key.size.height();
  const SmallLines lines = smallLines(height, m_ratio * double(samples), penWidth);
  return {.id = id,
          .scene = withSmallLines(key.scene, lines),
          .camera = key.camera,
          .settings = {.width = samples * key.size.width(),
                       .height = height,
                       .environment = key.environment},
          .samples = samples};
}

void ViewPictures::ask() {
  if (m_size.isEmpty())
    return;
  PreviewRequest request{.asker = PreviewsOf::views};
  std::map<int, Key> asked;
  for (const int row : m_rows) {
    if (row >= int(m_session.scene().views().size()))
      continue;
    Key key = keyOf(row);
    if (const QImage* image = kept(key)) {
      if (image->cacheKey() != m_list.picture(row).cacheKey())
        m_list.setPicture(row, *image);
      continue;
    }
    const bool twice = std::any_of(asked.begin(), asked.end(),
                                   [&key](const auto& each) { return each.second == key; });
    if (twice)
      continue;
    request.previews.push_back(previewOf(++m_lastId, key));
    asked.emplace(m_lastId, std::move(key));
  }
  m_asked = std::move(asked);
  m_viewport.askPreviews(std::move(request));
}

void ViewPictures::took(PreviewsOf asker, int id, const QImage& image) {
  const auto found = m_asked.find(id);
  if (asker != PreviewsOf::views || found == m_asked.end())
    return;
  ++m_drawn;
  m_kept.push_back({std::move(found->second), image});
  m_asked.erase(found);
  if (m_kept.size() > mostKept)
    m_kept.pop_front();
  for (const int row : m_rows)
    if (row < int(m_session.scene().views().size()) && keyOf(row) == m_kept.back().key)
      m_list.setPicture(row, image);
}

}  // namespace sline::widgets

#include "moc_view_pictures.cpp"
