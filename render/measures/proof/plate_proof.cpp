// SPDX-License-Identifier: Apache-2.0
#include "render/measures/proof/plate_proof.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numeric>

#include "model/base/parallel.h"
#include "model/geometry/mesh_trees.h"
#include "model/scene/visible_structures.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::render {

namespace {

constexpr int pixelsPerRay = 8;

/// Tells whether a structure hides what is behind it: what is nothing but lines does not.
bool hidesWhatIsBehind(const model::ResolvedStyle& style) {
  return style.fill != model::Fill::none && style.opacity.value() > 0.3f;
}

struct SolidBody {
  model::BvhPtr tree;
  bool asked = false;
};

std::vector<SolidBody> solidBodies(const model::Scene& scene,
                                   std::span<const model::NodeId> subject) {
  std::vector<SolidBody> bodies;
  for (const model::VisibleStructure& each : model::visibleStructures(scene)) {
    const bool asked = std::find(subject.begin(), subject.end(), each.node->id) != subject.end();
    if (asked || hidesWhatIsBehind(each.style))
      bodies.push_back({model::treeOf(each.node->mesh), asked});
  }
  return bodies;
}

/// Returns the ray through a place in the picture, from −1 to 1 across and upwards.
model::Ray rayThrough(const model::Camera& camera, float across, float up, float aspect) {
  const model::CameraFrame frame = model::cameraFrame(camera);
  if (camera.projection == model::Projection::orthographic) {
    const float half = 0.5f * camera.heightMm;
    return {camera.eye + half * aspect * across * frame.right + half * up * frame.up, -frame.back};
  }
  const float half = std::tan(0.5f * glm::radians(camera.fovyDegrees));
  return {camera.eye,
          glm::normalize(half * aspect * across * frame.right + half * up * frame.up - frame.back)};
}

/// Returns the share of the subject's own silhouette that no filled structure of the context hides.
double subjectSeenFrom(const model::Camera& camera, const std::vector<SolidBody>& bodies, int width,
                       int height) {
  std::vector<int> own(std::size_t(height / pixelsPerRay), 0);
  std::vector<int> seen(own.size(), 0);
  const float aspect = float(width) / float(height);
  parallelFor(own.size(), 4, [&](std::size_t row) {
    const int y = int(row) * pixelsPerRay + pixelsPerRay / 2;
    for (int x = pixelsPerRay / 2; x < width; x += pixelsPerRay) {
      model::Ray ray = rayThrough(camera, 2.0f * float(x) / float(width) - 1.0f,
                                  1.0f - 2.0f * float(y) / float(height), aspect);
      float subject = std::numeric_limits<float>::infinity();
      float context = subject;
      for (const SolidBody& body : bodies) {
        float& nearest = body.asked ? subject : context;
        ray.farthest = nearest;
        if (const auto hit = body.tree->nearest(ray))
          nearest = std::min(nearest, hit->t);
      }
      own[row] += std::isfinite(subject);
      seen[row] += std::isfinite(subject) && subject <= context;
    }
  });
  const int all = std::accumulate(own.begin(), own.end(), 0);
  return all > 0 ? double(std::accumulate(seen.begin(), seen.end(), 0)) / double(all) : 0.0;
}

}  // namespace

bool PlateProof::holds() const {
  return subjectSeen >= leastSubjectSeen && ink <= mostInk && coloured >= leastColoured;
}

PlateProof plateProof(const model::Scene& scene, const model::Camera& camera,
                      std::span<const model::NodeId> subject, const Image& picture) {
  PlateProof proof;
  proof.subjectSeen =
      subjectSeenFrom(camera, solidBodies(scene, subject), picture.width, picture.height);
  const double each = 1.0 / double(picture.width * picture.height);
  for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
    const auto [low, high] =
        std::minmax({picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]});
    constexpr int dark = 85;
    constexpr int hue = 20;
    proof.ink += high < dark ? each : 0.0;
    proof.coloured += high - low >= hue ? each : 0.0;
  }
  return proof;
}

Result<PlateProof> plateProof(const model::Scene& scene, const model::Camera& camera,
                              std::span<const model::NodeId> subject, float aspect) {
  const auto picture = TRY(HeadlessPicture::create());
  const int width = std::max(pixelsPerRay, int(std::lround(float(plateHeight) * aspect)));
  const Image image = TRY(picture->render(scene, camera, {.width = width, .height = plateHeight}));
  return plateProof(scene, camera, subject, image);
}

}  // namespace sline::render
