// SPDX-License-Identifier: Apache-2.0
#include "model/import/plan/views_and_annotations.h"

#include <utility>

#include "model/import/naming/names.h"

namespace sline::model {

namespace {

class Furnisher {
 public:
  Furnisher(BuiltScene built, const Sources& sources, const ImportOptions& options)
      : m_built(std::move(built)), m_sources(sources), m_options(options) {}

  FurnishedScene run() {
    for (Fiducial fiducial : m_sources.fiducials) {
      fiducial.frame = m_options.frame.value_or(fiducial.frame);
      add(fiducial);
    }
    for (std::size_t i = 0; i < m_sources.sources.size(); ++i)
      if (const auto& scene = m_sources.sources[i].scene)
        addScene(*scene, i);
    std::vector<std::string> names;
    for (const View& view : m_views)
      names.push_back(view.name);
    tellApart(names, m_viewCut);
    for (std::size_t i = 0; i < names.size(); ++i)
      m_views[i].name = names[i];
    m_built.scene.setViews(std::move(m_views));
    return {std::move(m_built.scene), m_cut};
  }

 private:
  /// Returns what of a text may be shown, and `other` where nothing is left of it.
  std::string shown(const std::string& text, const char* other) {
    if (m_options.keepFileNames || text.empty() || mayBeShown(text))
      return text;
    ++m_cut;
    std::string left = shownFileName(text);
    return left.empty() ? other : left;
  }

  std::optional<AnnotationId> add(const Fiducial& fiducial) {
    Annotation annotation = annotationOf(fiducial);
    annotation.text = shown(annotation.text, "point");
    if (annotationFault(annotation))  // beyond what a float holds
      return std::nullopt;
    return m_built.scene.appendAnnotation(std::move(annotation));
  }

  void addScene(const SlicerScene& scene, std::size_t source) {
    std::vector<std::optional<AnnotationId>> ids;
    ids.reserve(scene.fiducials.size());
    for (const Fiducial& fiducial : scene.fiducials)
      ids.push_back(add(fiducial));
    for (const SlicerView& saved : scene.views) {
      View view{.name = shown(saved.name, "view"), .camera = saved.camera};
      m_viewCut.push_back(view.name != saved.name && view.name != "view");
      if (!saved.groups.empty() || !saved.models.empty())
        view.looks = looks(saved, source);
      if (!saved.fiducials.empty()) {
        view.annotations.emplace();
        for (std::size_t i = 0; i < ids.size(); ++i)
          if (saved.fiducials[i] && ids[i])
            view.annotations->push_back(*ids[i]);
      }
      m_views.push_back(std::move(view));
    }
  }

  std::vector<Look> looks(const SlicerView& saved, std::size_t source) const {
    std::vector<Look> looks;
    for (std::size_t group = 0; group < saved.groups.size(); ++group)
      if (const auto found = m_built.groups.find({source, group}); found != m_built.groups.end())
        looks.push_back({.node = found->second, .style = saved.groups[group]});
    for (std::size_t file = 0; file < m_sources.files.size(); ++file) {
      const SourceFile& from = m_sources.files[file];
      if (from.source != source || !from.model)
        continue;
      for (const NodeId node : m_built.nodesOfFile[file])
        looks.push_back({.node = node, .style = saved.models[*from.model]});
    }
    return looks;
  }

  BuiltScene m_built;
  const Sources& m_sources;
  const ImportOptions& m_options;
  std::size_t m_cut = 0;
  std::vector<View> m_views;
  std::vector<bool> m_viewCut;  ///< words were left out of its name
};

}  // namespace

FurnishedScene withViewsAndAnnotations(BuiltScene built, const Sources& sources,
                                       const ImportOptions& options) {
  return Furnisher(std::move(built), sources, options).run();
}

}  // namespace sline::model
