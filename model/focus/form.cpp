// SPDX-License-Identifier: Apache-2.0
#include "model/focus/form.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "model/geometry/bounding_sphere.h"

namespace sline::model {

namespace {

constexpr std::size_t samplesPerForm = 240;
/// The form is measured around every sample of this stride.
constexpr std::size_t formStride = 3;
constexpr int linesAround = 6;
/// An index itself holds a mesh three times: by the key, the form and its tree.
constexpr long holders = 3;
/// A tube's cross-section is at most this many times as wide one way as the other, and its length
/// exceeds that.
constexpr float roundest = 2.2f;
constexpr float flattest = 3.0f;
/// A wall is at most this share of the lumen behind it.
constexpr float thickestWall = 0.25f;

/// Holds the three widths of a solid around a sample: straight in from the surface, and from the
/// middle of that way the least and the most across it. The shape-diameter function (Shapira,
/// Shamir, Cohen-Or 2008) uses the first alone; tubes, sheets and lumps differ in the other two.
struct Widths {
  float in = 0.0f;
  float least = 0.0f;
  float most = 0.0f;
};

bool ofTube(const Widths& w) {
  return w.least <= flattest * w.in && w.most > roundest * std::max(w.in, w.least);
}

bool ofSheet(const Widths& w) {
  return w.least > flattest * w.in;
}

/// Returns two directions across the normal; for the mirrored normal they are mirrored except for
/// their signs.
std::array<glm::vec3, 2> across(const glm::vec3& n) {
  const glm::vec3 size = glm::abs(n);
  const glm::vec3 axis = size.x <= size.y && size.x <= size.z ? glm::vec3(1, 0, 0)
                         : size.y <= size.z                   ? glm::vec3(0, 1, 0)
                                                              : glm::vec3(0, 0, 1);
  const glm::vec3 first = glm::normalize(glm::cross(n, axis));
  return {first, glm::cross(n, first)};
}

/// Returns directions evenly around the normal, half of all: their opposites are the others.
std::array<glm::vec3, linesAround> around(const glm::vec3& normal) {
  static const auto turns = [] {
    std::array<glm::vec2, linesAround> some;
    for (int i = 0; i < linesAround; ++i) {
      const float angle = float(M_PI) * float(i) / float(linesAround);
      some[std::size_t(i)] = {std::cos(angle), std::sin(angle)};
    }
    return some;
  }();
  const auto [u, v] = across(normal);
  std::array<glm::vec3, linesAround> directions;
  for (std::size_t i = 0; i < directions.size(); ++i)
    directions[i] = turns[i].x * u + turns[i].y * v;
  return directions;
}

/// Returns how far it is from an inner point to the surface, at most `endless`.
float way(const Bvh& tree, const glm::vec3& inside, const glm::vec3& direction, float endless) {
  const std::optional<Hit> hit = tree.nearest({inside, direction, 0.0f, endless});
  return hit ? hit->t : endless;
}

/// Returns the length of the line through an inner point from surface to surface; a side without a
/// surface counts as `endless`.
float chord(const Bvh& tree, const glm::vec3& inside, const glm::vec3& direction, float endless) {
  return way(tree, inside, direction, endless) + way(tree, inside, -direction, endless);
}

/// Tells whether that line is shorter than `length`.
bool isShort(const Bvh& tree, const glm::vec3& inside, const glm::vec3& direction, float length) {
  const float one = way(tree, inside, direction, length);
  return one < length && one + way(tree, inside, -direction, length) < length;
}

/// Returns how far it is to the surface in a direction, beyond `from`.
std::optional<float> wayTo(const Form& form, const SurfaceSample& sample, float side, float from) {
  const float endless = 2.0f * form.radius;
  const std::optional<Hit> hit =
      form.tree->nearest({sample.place, side * sample.normal, from + 1e-4f * form.radius, endless});
  return hit ? std::optional(hit->t) : std::nullopt;
}

/// Tells whether a place is in a lumen: walls are near it most ways across.
bool isInLumen(const Form& form, const glm::vec3& middle, const glm::vec3& normal, float width) {
  constexpr float farthest = 3.0f;  // in widths
  constexpr int fewest = 3;         // of `linesAround`; others look along the lumen or out of it
  int bounded = 0;
  int left = linesAround;
  for (const glm::vec3& direction : around(normal)) {
    bounded += isShort(*form.tree, middle, direction, farthest * width);
    --left;
    if (bounded >= fewest || bounded + left < fewest)
      break;
  }
  return bounded >= fewest;
}

/// Tells whether a sample lies on the inner wall of a hollow structure whose wall is that thick. It
/// says nothing of the form: hollow structures count as solid (METHOD §12.5).
bool isOnInnerWall(const Form& form, const SurfaceSample& sample, float wall) {
  const std::optional<float> lumen = wayTo(form, sample, 1.0f, 0.0f);
  return lumen && wall <= thickestWall * *lumen &&
         isInLumen(form, sample.place + 0.5f * *lumen * sample.normal, sample.normal, *lumen);
}

/// Returns the width straight in through both walls of a hollow structure and its lumen, or just
/// `wall` where there is no lumen behind it.
float solidWidth(const Form& form, const SurfaceSample& sample, float wall) {
  const std::optional<float> lumenEnd = wayTo(form, sample, -1.0f, wall);
  if (!lumenEnd || wall > thickestWall * (*lumenEnd - wall))
    return wall;
  const glm::vec3 middle = sample.place - 0.5f * (wall + *lumenEnd) * sample.normal;
  if (!isInLumen(form, middle, sample.normal, *lumenEnd - wall))
    return wall;
  return wayTo(form, sample, -1.0f, *lumenEnd).value_or(*lumenEnd);
}

/// Returns the widths at a sample, or none where the surface is open: straight in there is no
/// surface to meet.
std::optional<Widths> widthsAt(const Form& form, const SurfaceSample& sample,
                               const std::optional<float>& wall) {
  if (!wall)
    return std::nullopt;
  const float in = solidWidth(form, sample, *wall);
  // Wider than this is as good as endless for `ofTube` and `ofSheet`, and sooner known.
  const float endless = std::min(2.0f * form.radius, 1.1f * roundest * flattest * in);
  Widths widths{.in = in, .least = 2.0f * endless};
  const glm::vec3 middle = sample.place - 0.5f * in * sample.normal;
  for (const glm::vec3& direction : around(sample.normal)) {
    const float width = chord(*form.tree, middle, direction, endless);
    widths.least = std::min(widths.least, width);
    widths.most = std::max(widths.most, width);
    // What is a tube remains one, whatever its other widths.
    if (ofTube(widths))
      break;
  }
  return widths;
}

}  // namespace

Form::Form(MeshPtr surface) : mesh(std::move(surface)), tree(treeOf(mesh)) {}

FormPtr formOf(const MeshPtr& mesh) {
  auto form = std::make_shared<Form>(mesh);
  form->samples = surfaceSamples(*mesh, samplesPerForm);
  form->area = surfaceArea(*mesh);
  form->radius = smallestBoundingSphere(mesh->positions()).radius;
  std::vector<float> widths;
  std::size_t asked = 0;
  std::size_t tubes = 0;
  std::size_t sheets = 0;
  for (std::size_t i = formStride / 2; i < form->samples.size(); i += formStride) {
    const SurfaceSample& sample = form->samples[i];
    const std::optional<float> wall = wayTo(*form, sample, -1.0f, 0.0f);
    if (wall && isOnInnerWall(*form, sample, *wall))
      continue;
    ++asked;
    const std::optional<Widths> at = widthsAt(*form, sample, wall);
    widths.push_back(at ? at->in : 0.0f);
    tubes += at && ofTube(*at);
    sheets += !at || ofSheet(*at);
  }
  if (asked == 0)
    return form;
  const auto middle = widths.begin() + std::ptrdiff_t(asked / 2);
  std::nth_element(widths.begin(), middle, widths.end());
  form->thickness = *middle;
  form->tube = float(tubes) / float(asked);
  form->sheet = float(sheets) / float(asked);
  return form;
}

FormPtr FormIndex::of(const MeshPtr& mesh) {
  {
    const std::lock_guard lock(m_mutex);
    if (const auto found = m_forms.find(mesh); found != m_forms.end())
      return found->second;
  }
  FormPtr form = formOf(mesh);
  const std::lock_guard lock(m_mutex);
  return m_forms.try_emplace(mesh, std::move(form)).first->second;
}

void FormIndex::trim() {
  const std::lock_guard lock(m_mutex);
  std::erase_if(m_forms, [](const auto& entry) { return entry.first.use_count() <= holders; });
}

}  // namespace sline::model
