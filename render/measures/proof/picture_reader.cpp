// SPDX-License-Identifier: Apache-2.0
#include "render/measures/proof/picture_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "model/base/parallel.h"
#include "model/base/srgb.h"
#include "model/scene/resolved_styles.h"
#include "render/labels/seen/screen.h"
#include "render/labels/seen/sight.h"
#include "render/picture/headless/headless_picture.h"

namespace sline::render {

namespace {

constexpr int cellsAcross = 280;  // along the longer side
constexpr int cellPixels = 4;
constexpr int shortestBorder = 4;  // cells
constexpr int fewestCells = 6;
constexpr int nobody = -1;

/// Tells which structure each cell shows.
struct Grid {
  int columns = 0;
  int rows = 0;
  std::vector<int> owner;
  int at(int x, int y) const {
    return owner[std::size_t(y) * std::size_t(columns) + std::size_t(x)];
  }
};

Grid gridFor(const glm::vec2& size) {
  const float longer = std::max(size.x, size.y);
  const auto cells = [longer](float side) {
    return std::max(int(std::lround(float(cellsAcross) * side / longer)), 8);
  };
  Grid grid{.columns = cells(size.x), .rows = cells(size.y), .owner = {}};
  grid.owner.assign(std::size_t(grid.columns) * std::size_t(grid.rows), nobody);
  return grid;
}

std::vector<model::ResolvedStructure> visibleOf(const model::Scene& scene) {
  const std::array<model::NodeId, 1> all{model::rootId};
  std::vector<model::ResolvedStructure> structures = model::resolvedBelow(scene, all);
  std::erase_if(structures, [](const model::ResolvedStructure& s) {
    return !s.style.visible || s.style.opacity.value() <= 0.0f ||
           s.node->mesh->triangleCount() == 0;
  });
  std::sort(structures.begin(), structures.end(),
            [](const auto& a, const auto& b) { return a.node->id < b.node->id; });
  return structures;
}

void findOwners(const ExportOrder& order, const model::Scene& scene,
                const std::vector<model::ResolvedStructure>& structures, model::MeshTrees& trees,
                Grid& grid) {
  const Screen screen(order.camera, order.page.sizeMm);
  const Sights sights(scene, trees);
  std::map<model::NodeId, int> numbers;
  for (std::size_t i = 0; i < structures.size(); ++i) {
    numbers[structures[i].node->id] = int(i);
    trees.of(structures[i].node->mesh);  // made here, so that threads only read
  }
  const glm::vec2 cell = order.page.sizeMm / glm::vec2(float(grid.columns), float(grid.rows));
  parallelFor(std::size_t(grid.rows), 1, [&](std::size_t y) {
    for (int x = 0; x < grid.columns; ++x) {
      const model::Ray ray = screen.sight(cell * glm::vec2(float(x) + 0.5f, float(y) + 0.5f));
      std::optional<Sights::SightHit> seen = sights.nearest(ray);
      if (!seen)
        for (const model::ResolvedStructure& structure : structures) {
          const auto other = sights.nearestOf(structure.node->id, ray);
          if (other && (!seen || other->hit.t < seen->hit.t))
            seen = other;
        }
      if (seen)
        grid.owner[y * std::size_t(grid.columns) + std::size_t(x)] = numbers.at(seen->structure);
    }
  });
}

/// Returns the mean of what is drawn in a cell, on white; linear light.
glm::vec3 lightOfCell(const Image& image, int x, int y) {
  glm::vec3 sum(0.0f);
  for (int row = 0; row < cellPixels; ++row)
    for (int column = 0; column < cellPixels; ++column) {
      const std::uint8_t* p =
          image.rgba.data() + (std::size_t(y * cellPixels + row) * std::size_t(image.width) +
                               std::size_t(x * cellPixels + column)) *
                                  4;
      const float alpha = float(p[3]) / 255.0f;
      for (int i = 0; i < 3; ++i)
        sum[i] += lightFromSrgb(alpha * float(p[i]) / 255.0f + 1.0f - alpha);
    }
  return sum / float(cellPixels * cellPixels);
}

/// Tells whether all four neighbours show the same structure.
bool inside(const Grid& grid, int x, int y) {
  const int own = grid.at(x, y);
  return x > 0 && y > 0 && x + 1 < grid.columns && y + 1 < grid.rows && grid.at(x - 1, y) == own &&
         grid.at(x + 1, y) == own && grid.at(x, y - 1) == own && grid.at(x, y + 1) == own;
}

struct Sum {
  glm::dvec3 light{0.0};
  int cells = 0;
};

/// Returns the borders; `place` has each owner's number among the structures that are seen.
std::vector<SharedBorder> bordersOf(const Grid& grid, const std::vector<int>& place) {
  std::map<std::pair<int, int>, int> borders;
  const auto touch = [&](int a, int b) {
    if (a == nobody || b == nobody || a == b || place[std::size_t(a)] == nobody ||
        place[std::size_t(b)] == nobody)
      return;
    ++borders[std::minmax(place[std::size_t(a)], place[std::size_t(b)])];
  };
  for (int y = 0; y < grid.rows; ++y)
    for (int x = 0; x < grid.columns; ++x) {
      if (x + 1 < grid.columns)
        touch(grid.at(x, y), grid.at(x + 1, y));
      if (y + 1 < grid.rows)
        touch(grid.at(x, y), grid.at(x, y + 1));
    }
  std::vector<SharedBorder> found;
  for (const auto& [pair, cells] : borders)
    if (cells >= shortestBorder)
      found.push_back({std::size_t(pair.first), std::size_t(pair.second),
                       double(cells) / double(std::max(grid.columns, grid.rows))});
  return found;
}

SeenPicture summedUp(const model::Scene& scene, const Grid& grid, const Image& image,
                     const std::vector<model::ResolvedStructure>& structures) {
  std::vector<Sum> inner(structures.size());
  std::vector<Sum> all(structures.size());
  for (int y = 0; y < grid.rows; ++y)
    for (int x = 0; x < grid.columns; ++x) {
      if (grid.at(x, y) == nobody)
        continue;
      const glm::dvec3 light(lightOfCell(image, x, y));
      const auto add = [&](Sum& sum) {
        sum.light += light;
        ++sum.cells;
      };
      add(all[std::size_t(grid.at(x, y))]);
      if (inside(grid, x, y))
        add(inner[std::size_t(grid.at(x, y))]);
    }
  SeenPicture seen;
  std::vector<int> place(structures.size(), nobody);
  for (std::size_t i = 0; i < structures.size(); ++i) {
    if (all[i].cells < fewestCells)
      continue;
    const Sum& sum = inner[i].cells > 0 ? inner[i] : all[i];
    const model::ResolvedStyle& style = structures[i].style;
    place[i] = int(seen.structures.size());
    seen.structures.push_back(
        {.id = structures[i].node->id,
         .share = double(all[i].cells) / double(grid.columns * grid.rows),
         .light = glm::vec3(sum.light / double(sum.cells)),
         .gamma = style.gamma.value(),
         .coloured = style.gamma.value() > 3.0f || style.fill == model::Fill::tint,
         .colour = style.colour,
         .locked = scene.isLocked(structures[i].node->id)});
  }
  seen.borders = bordersOf(grid, place);
  return seen;
}

}  // namespace

struct PictureReader::Data {
  HeadlessPicture picture;
  model::MeshTrees trees;
};

PictureReader::PictureReader(std::unique_ptr<Data> data) : m_data(std::move(data)) {}
PictureReader::~PictureReader() = default;

Result<std::unique_ptr<PictureReader>> PictureReader::create() {
  HeadlessPicture picture = TRY(HeadlessPicture::create());
  std::unique_ptr<Data> data(new Data{std::move(picture), {}});
  return std::unique_ptr<PictureReader>(new PictureReader(std::move(data)));
}

Result<SeenPicture> PictureReader::read(const ExportOrder& order, const model::Scene& scene) {
  const std::vector<model::ResolvedStructure> structures = visibleOf(scene);
  Grid grid = gridFor(order.page.sizeMm);
  findOwners(order, scene, structures, m_data->trees, grid);
  const Image image = TRY(m_data->picture->render(scene, order.camera,
                                                  {.width = cellPixels * grid.columns,
                                                   .height = cellPixels * grid.rows,
                                                   .environment = order.environment}));
  return summedUp(scene, grid, image, structures);
}

}  // namespace sline::render
