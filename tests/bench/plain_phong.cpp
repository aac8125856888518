// SPDX-License-Identifier: Apache-2.0
#include "tests/bench/plain_phong.h"

#include "model/scene/visible_structures.h"
#include "render/drawn/picture_view.h"
#include "render/drawn/prepared_surface.h"
#include "render/drawn/surface_fill.h"
#include "render/gpu/draw_queue.h"

namespace sline::bench {

using render::passes::SurfaceGeometry;

Result<std::unique_ptr<PlainPhong>> PlainPhong::create(int width, int height) {
  using render::gpu::Texture;
  using render::gpu::TextureFormat;
  std::unique_ptr<PlainPhong> phong(new PlainPhong);
  auto device = render::gpu::Device::create();
  if (!device)
    return device.error();
  phong->m_device = std::move(*device);
  auto pass = render::passes::PlainPhongPass::create(phong->m_device->dialect());
  if (!pass)
    return pass.error();
  phong->m_pass = std::move(*pass);
  const render::gpu::TextureSize size{width, height};
  phong->m_colour = std::make_unique<Texture>(TextureFormat::rgba8, size, "plain Phong");
  phong->m_depth = std::make_unique<Texture>(TextureFormat::depth32f, size, "plain Phong depth");
  auto target =
      render::gpu::Target::create({{phong->m_colour.get()}, phong->m_depth.get()}, "plain Phong");
  if (!target)
    return target.error();
  phong->m_target = std::move(*target);
  return phong;
}

SurfaceGeometry& PlainPhong::geometryOf(const model::Node& node) {
  std::unique_ptr<SurfaceGeometry>& made = m_geometry[node.mesh];
  if (made)
    return *made;
  const model::SurfacePtr surface = render::pictureSurface(node.mesh, node.provenance);
  const auto positions = surface->mesh->positions();
  std::vector<render::passes::SurfaceVertex> vertices(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i)
    vertices[i] = {positions[i], render::passes::packedNormal(surface->normals[i])};
  made = std::make_unique<SurfaceGeometry>(vertices, "plain Phong");
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t triangle : surface->clusters.triangles)
    for (const std::uint32_t vertex : surface->mesh->triangles()[triangle])
      indices.push_back(vertex);
  made->setTriangles(indices);
  return *made;
}

void PlainPhong::draw(const model::Scene& scene, const model::Camera& camera) {
  const render::PictureView view(camera, scene.visibleBounds(), m_target->size().width,
                                 m_target->size().height);
  m_device->clear(*m_target,
                  {.colour = render::backgroundColour(render::Background::white), .depth = 1.0f});
  render::gpu::DrawQueue queue(m_device->software());
  for (const model::VisibleStructure& structure : model::visibleStructures(scene)) {
    const SurfaceGeometry& geometry = geometryOf(*structure.node);
    m_pass->draw(*m_device, *m_target, {view.viewProjection(), view.eyeVector()}, geometry,
                 render::rgb(structure.style.colour));
    queue.addTriangles(geometry.indexCount());
  }
  m_device->finish();
}

}  // namespace sline::bench
