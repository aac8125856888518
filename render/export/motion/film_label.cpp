// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/film_label.h"

#include <map>
#include <utility>

namespace sline::render {

std::vector<FilmLabel> filmLabels(std::vector<LabelRequest>& frames) {
  std::map<model::AnnotationId, FilmLabel> all;
  for (std::size_t t = 0; t < frames.size(); ++t)
    for (LabelItem& item : frames[t].items) {
      FilmLabel& label = all[item.id];
      label.id = item.id;
      label.items.resize(frames.size());
      label.there.resize(frames.size());
      label.items[t] = &item;
      label.there[t] = true;
    }
  std::vector<FilmLabel> labels;
  labels.reserve(all.size());
  for (auto& [id, label] : all)
    labels.push_back(std::move(label));
  return labels;
}

}  // namespace sline::render
