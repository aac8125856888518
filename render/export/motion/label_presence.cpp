// SPDX-License-Identifier: Apache-2.0
#include "render/export/motion/label_presence.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "render/export/motion/film_paths.h"

namespace sline::render {

namespace {

/// Removes what is there or gone for less than `least` frames; in a film that loops, its end and
/// its beginning are neighbours.
class Blinks {
 public:
  Blinks(Presence& there, std::size_t least, bool loops)
      : m_there(there), m_least(least), m_loops(loops) {}

  void remove() {
    while (removeOne())
      continue;
  }

 private:
  /// Returns how many frames from that one on are alike.
  std::size_t run(std::size_t from) const {
    std::size_t length = 1;
    while (length < m_there.size() && (m_loops || from + length < m_there.size()) &&
           m_there[(from + length) % m_there.size()] == m_there[from])
      ++length;
    return length;
  }

  bool removeOne() {
    const std::size_t count = m_there.size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t before = (i + count - 1) % count;
      const bool begins = i == 0 && !m_loops ? true : m_there[before] != m_there[i];
      const std::size_t length = run(i);
      if (!begins || length >= m_least || length == count)
        continue;
      if (m_there[i]) {
        for (std::size_t k = 0; k < length; ++k)
          m_there[(i + k) % count] = false;
        return true;
      }
      const bool inside = m_loops || (i > 0 && i + length < count);
      if (inside) {
        for (std::size_t k = length; k < m_least && (m_loops || i + k < count); ++k)
          m_there[(i + k) % count] = false;
        return true;
      }
    }
    return false;
  }

  Presence& m_there;
  std::size_t m_least;
  bool m_loops;
};

/// Resolves conflicts between labels of all frames.
class Disputes {
 public:
  Disputes(std::vector<FilmLabel>& labels, const std::vector<LabelRequest>& frames,
           const Film& film)
      : m_labels(labels), m_frames(frames), m_film(film), m_conflicts(frames.size()) {
    for (std::size_t k = 0; k < labels.size(); ++k)
      m_index[labels[k].id] = k;
  }

  void settle() {
    for (FilmLabel& label : m_labels)
      stayForASecond(label.there, m_film);
    const std::vector<FilmLabel> wanted = m_labels;
    for (std::size_t t = 0; t < m_frames.size(); ++t)
      m_conflicts[t] = conflictsAt(t);
    while (const auto loss = cheapest())
      accept(*loss);
    for (std::size_t k = 0; k < m_labels.size(); ++k)
      bringBack(k, wanted[k].there);
  }

 private:
  using Pair = std::pair<std::size_t, std::size_t>;

  /// A label and when it would be there instead.
  struct Loss {
    std::size_t label = 0;
    Presence there;
    double worth = 0.0;  ///< conflicts less for what is lost
  };

  /// Returns conflicts of the labels that are there, by their index.
  std::vector<Pair> conflictsAt(std::size_t t) const {
    LabelRequest request = m_frames[t];
    std::erase_if(request.items,
                  [&](const LabelItem& item) { return !m_labels[m_index.at(item.id)].there[t]; });
    std::vector<Pair> pairs = labelConflicts(request);
    for (auto& [a, b] : pairs) {
      a = m_index.at(request.items[a].id);
      b = m_index.at(request.items[b].id);
    }
    return pairs;
  }

  static bool concerns(const Pair& pair, std::size_t k) {
    return pair.first == k || pair.second == k;
  }

  std::optional<Loss> cheapest() const {
    std::optional<Loss> best;
    for (std::size_t k = 0; k < m_labels.size(); ++k) {
      Presence free = m_labels[k].there;
      bool any = false;
      for (std::size_t t = 0; t < free.size(); ++t)
        for (const Pair& pair : m_conflicts[t])
          if (concerns(pair, k)) {
            free[t] = false;
            any = true;
          }
      if (!any)
        continue;
      stayForASecond(free, m_film);
      for (Loss& loss : apart(k, free))
        if (!best || loss.worth >= best->worth)
          best = std::move(loss);
    }
    return best;
  }

  /// Returns what is lost one run after the other.
  std::vector<Loss> apart(std::size_t k, const Presence& free) const {
    constexpr double hidden = 0.25;  // what a hidden label counts
    const FilmLabel& label = m_labels[k];
    const std::size_t count = free.size();
    std::vector<Loss> losses;
    for (std::size_t t = 0; t < count; ++t) {
      if (free[t] || (t > 0 && !free[t - 1]))
        continue;
      Loss loss{k, label.there, 0.0};
      double gain = 0.0;
      double price = 0.0;
      for (std::size_t s = t; s < count && !free[s]; ++s) {
        for (const Pair& pair : m_conflicts[s])
          gain += concerns(pair, k) ? 1.0 : 0.0;
        if (label.there[s])
          price += label.seen(s) ? 1.0 : hidden;
        loss.there[s] = false;
      }
      if (gain > 0.0 && price > 0.0) {
        loss.worth = gain / price;
        losses.push_back(std::move(loss));
      }
    }
    return losses;
  }

  void accept(const Loss& loss) {
    FilmLabel& label = m_labels[loss.label];
    Presence there = loss.there;
    stayForASecond(there, m_film);
    for (std::size_t t = 0; t < there.size(); ++t)
      if (there[t] != label.there[t]) {
        label.there[t] = there[t];
        m_conflicts[t] = conflictsAt(t);
      }
  }

  /// Lets the label in again where others, which have gone since, are no longer in its way.
  void bringBack(std::size_t k, const Presence& wanted) {
    FilmLabel& label = m_labels[k];
    const Presence was = label.there;
    Presence there = was;
    for (std::size_t t = 0; t < there.size(); ++t)
      if (wanted[t] && !was[t]) {
        label.there[t] = true;
        there[t] = conflictsAt(t).empty();
        label.there[t] = false;
      }
    stayForASecond(there, m_film);
    // Where runs were joined the whole is no less than before.
    for (std::size_t t = 0; t < there.size(); ++t)
      if (was[t] && !there[t])
        return;
    label.there = std::move(there);
  }

  std::vector<FilmLabel>& m_labels;
  const std::vector<LabelRequest>& m_frames;
  const Film& m_film;
  std::map<model::AnnotationId, std::size_t> m_index;
  std::vector<std::vector<Pair>> m_conflicts;  ///< of each frame
};

}  // namespace

void stayForASecond(std::vector<bool>& there, const Film& film) {
  const auto second = std::size_t(film.framesPerSecond());
  if (there.size() >= second)
    Blinks(there, second, film.loops()).remove();
}

void keepApart(std::vector<FilmLabel>& labels, const std::vector<LabelRequest>& frames,
               const Film& film) {
  Disputes(labels, frames, film).settle();
}

}  // namespace sline::render
