// SPDX-License-Identifier: Apache-2.0
#include "render/picture/layer_painter.h"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "render/drawn/surface_fill.h"
#include "render/picture/layer_content.h"
#include "render/picture/processor_drawing.h"

namespace sline::render {

namespace {

/// Makes a pass for the device in its place.
template <class Pass>
Status make(const gpu::Device& device, std::shared_ptr<Pass>& place) {
  place = TRY(Pass::create(device.dialect()));
  return Unit{};
}

}  // namespace

Status LayerPainter::equip(const gpu::Device& device) {
  const auto all = [&device](auto&... passes) {
    Status status = Unit{};
    static_cast<void>(((status = make(device, passes)).ok() && ...));
    return status;
  };
  return all(m_surfacePass, m_wipePass, m_enlargePass, m_capPass, m_inkPass, m_resolvePass,
             m_overlayPass);
}

std::unique_ptr<LayerPainter> LayerPainter::another(const AtlasLimits& limits) const {
  auto painter = std::make_unique<LayerPainter>(limits);
  painter->m_surfacePass = m_surfacePass;
  painter->m_wipePass = m_wipePass;
  painter->m_enlargePass = m_enlargePass;
  painter->m_capPass = m_capPass;
  painter->m_inkPass = m_inkPass;
  painter->m_resolvePass = m_resolvePass;
  painter->m_overlayPass = m_overlayPass;
  return painter;
}

void LayerPainter::forget() {
  for (Layer& old : m_kept)
    m_spares.push_back(std::move(old.pixels));
  m_kept.clear();
  m_outlines.forget();
}

namespace {

std::size_t areaOf(const PixelRect& rect) {
  return std::size_t(rect.width) * std::size_t(rect.height);
}

/// Tells whether both layers show one surface in the same place.
bool showsSameSurface(const Layer& layer, const Layer& other) {
  return layer.area == other.area && layer.members.size() == 1 && other.members.size() == 1 &&
         layer.members.front().sharesSurface(other.members.front());
}

/// Has changed layers keep what is seen of their surfaces, or take it over from the layers before
/// them, as those that change a few at a time are likely to change again: while one drags a
/// slider, say. Nobody else keeps any.
void keepValues(std::vector<Layer>& layers, std::span<const std::size_t> changed,
                std::vector<Layer>& before) {
  constexpr std::size_t most = 6'000'000;  // samples, up to 24 bytes each
  if (changed.empty())
    return;
  for (Layer& layer : layers)
    layer.values.reset();
  std::size_t samples = 0;
  for (const std::size_t i : changed)
    samples += areaOf(layers[i].area) / std::size_t(layers[i].surfaceStep * layers[i].surfaceStep);
  if (samples > most)
    return;
  for (const std::size_t i : changed) {
    Layer& layer = layers[i];
    const auto same = std::find_if(before.begin(), before.end(),
                                   [&](const Layer& old) { return showsSameSurface(layer, old); });
    if (same == before.end())
      continue;
    const PreparedStructure& now = layer.members.front();
    const PreparedStructure& then = same->members.front();
    layer.values.emplace();
    if (same->values && now.sampled == then.sampled)
      layer.values = std::move(same->values);
  }
}

}  // namespace

std::vector<std::size_t> LayerPainter::reuse(std::vector<Layer>& layers, const Key& key) {
  std::vector<std::size_t> changed;
  if (key != m_key)
    forget();
  m_key = key;
  // What was hidden stays so while all that hides it is as it was.
  const bool stayHidden = std::all_of(m_kept.begin(), m_kept.end(), [&](const Layer& old) {
    return !old.sampled || std::any_of(layers.begin(), layers.end(),
                                       [&](const Layer& layer) { return layer.drawnLike(old); });
  });
  std::vector<bool> gone(m_kept.size(), true);
  for (std::size_t i = 0; i < layers.size(); ++i) {
    Layer& layer = layers[i];
    const auto same = std::find_if(m_kept.begin(), m_kept.end(), [&](const Layer& old) {
      return layer.drawnLike(old) && (stayHidden || !old.partial);
    });
    if (same != m_kept.end()) {
      gone[std::size_t(same - m_kept.begin())] = false;
      layer = std::move(*same);
      continue;
    }
    changed.push_back(i);
    // A structure of changed style is drawn anew in its old place, if that still fits.
    const auto before = std::find_if(m_kept.begin(), m_kept.end(), [&](const Layer& old) {
      return old.area == layer.area && old.members.size() == 1 && layer.members.size() == 1 &&
             old.members.front().id == layer.members.front().id;
    });
    if (before != m_kept.end())
      layer.slot = before->slot;
  }
  keepValues(layers, changed, m_kept);
  m_freshAtlas = changed.size() == layers.size();
  m_left = TileMask(key.region);
  for (std::size_t i = 0; i < m_kept.size(); ++i)
    if (gone[i]) {
      m_left.mark(m_kept[i].mask);
      m_spares.push_back(std::move(m_kept[i].pixels));
    }
  m_kept.clear();
  return changed;
}

namespace {

/// Gives layers places in which the region's squares begin at multiples of their own side: a row of
/// a square's depth is then one line of a processor's cache, and drivers fill whole blocks. Steps
/// of the surfaces begin with the region, too, and one stays empty behind each layer, because what
/// is enlarged looks at those around it.
class AlignedPlaces {
 public:
  AlignedPlaces(const PixelRect& region, int step)
      : m_region(region),
        m_side(std::lcm(passes::ResolvePass::tileSide, step)),
        m_gap(step > 1 ? step : 0) {}

  gpu::TextureSize size(const Layer& layer) const {
    const auto rounded = [this](int pixels) {
      return (pixels + m_gap + m_side - 1) / m_side * m_side;
    };
    const glm::ivec2 margin = marginOf(layer);
    return {rounded(margin.x + layer.area.width), rounded(margin.y + layer.area.height)};
  }
  void put(Layer& layer, const PixelRect& place) const {
    const glm::ivec2 margin = marginOf(layer);
    layer.slot = {place.x + margin.x, place.y + margin.y, layer.area.width, layer.area.height};
  }

 private:
  glm::ivec2 marginOf(const Layer& layer) const {
    const auto within = [this](int pixels) { return (pixels % m_side + m_side) % m_side; };
    return {within(layer.area.x - m_region.x), within(layer.area.y - m_region.y)};
  }

  PixelRect m_region;
  int m_side;  ///< the places' corners are multiples of it
  int m_gap;
};

}  // namespace

bool LayerPainter::place(std::vector<Layer>& layers, std::vector<std::size_t>& changed) {
  const AlignedPlaces places(m_key.region, m_key.surfaceStep);
  if (!m_freshAtlas) {
    const bool fits = std::all_of(changed.begin(), changed.end(), [&](std::size_t i) {
      if (!layers[i].slot.empty())
        return true;
      const auto place = m_atlas.add(places.size(layers[i]));
      if (place)
        places.put(layers[i], *place);
      return place.has_value();
    });
    if (fits)
      return true;
  }
  std::vector<gpu::TextureSize> sizes;
  sizes.reserve(layers.size());
  for (const Layer& layer : layers)
    sizes.push_back(places.size(layer));
  const std::vector<PixelRect> slots = m_atlas.layOut(sizes, m_key.surfaceStep);
  if (slots.size() != layers.size())
    return false;
  for (std::size_t i = 0; i < layers.size(); ++i)
    places.put(layers[i], slots[i]);
  changed.resize(layers.size());
  std::iota(changed.begin(), changed.end(), std::size_t(0));
  for (Layer& layer : layers)
    layer.uploaded = layer.onProcessor = layer.sampled = layer.covered = layer.partial = false;
  m_freshAtlas = true;
  return true;
}

LayerPainter::Canvas LayerPainter::canvas(const gpu::Target* target, const PixelRect& region,
                                          std::span<const Layer> layers,
                                          std::span<const std::size_t> changed, bool blends) {
  // A resized target belongs to another region, and one that another paint had is no longer ours.
  const bool keeps = !m_freshAtlas && target == m_target && (m_blended || !blends);
  m_blended = blends;
  TileMask wanted = keeps ? m_left : TileMask(region);
  if (keeps)
    for (const std::size_t i : changed)
      wanted.mark(layers[i].mask);
  else
    for (const Layer& layer : layers)
      wanted.mark(layer.mask);
  m_target = target;
  return {target, region, std::move(wanted), keeps};
}

std::vector<ListedLayer> listedLayers(std::span<const Layer> layers, const PixelRect& region,
                                      Background background) {
  std::vector<ListedLayer> listed;
  for (const Layer& layer : layers) {
    const PixelRect seen = intersection(layer.area, region);
    if (!layer.shows() || seen.empty())
      continue;
    listed.push_back(
        {.mask = &layer.mask,
         .layer = {.area = {seen.x - region.x, seen.y - region.y, seen.width, seen.height},
                   .offsetX = layer.slot.x - layer.area.x + region.x,
                   .offsetY = layer.slot.y - layer.area.y + region.y,
                   .ink = inkColour(layer.members.front().style, background),
                   .filled = layer.filled,
                   .inked = layer.inked,
                   .hiddenInk = layer.hiddenInk,
                   .haloed = layer.haloed}});
  }
  return listed;
}

Status LayerPainter::resolve(gpu::Device& device, Background background, const Canvas& canvas,
                             std::span<const Layer> layers) {
  const std::vector<ListedLayer> listed = listedLayers(layers, canvas.region, background);
  const TileLists lists = tileLists(listed, canvas.wanted);
  TRY(m_resolvePass->upload(lists.tiles, lists.entries));
  m_resolvePass->draw(device, *canvas.target,
                      {.colours = m_atlas.colours(),
                       .inks = m_atlas.inks(),
                       .depths = m_atlas.layerDepths(),
                       .background = backgroundColour(background),
                       .keepOthers = canvas.keeps});
  return Unit{};
}

/// Draws a little from other textures, to and fro. Drivers hold on to the textures that they last
/// drew with, a software driver for each of the batches that it has under way, so an outgrown atlas
/// would stay in memory beside the new one.
void LayerPainter::letGo(gpu::Device& device) {
  constexpr int side = 64;
  constexpr int rounds = 16;
  const gpu::Texture colours(gpu::TextureFormat::rgba8, {side, side}, "scratch");
  const gpu::Texture inks(gpu::TextureFormat::rg8, {side, side}, "scratch");
  const gpu::Texture depths(gpu::TextureFormat::depth32f, {side, side}, "scratch");
  const gpu::Texture pixels(gpu::TextureFormat::rgba8, {side, side}, "scratch");
  const gpu::Texture others(gpu::TextureFormat::rgba8, {side, side}, "scratch");
  const auto one = gpu::Target::create({{&pixels}, nullptr}, "scratch");
  const auto other = gpu::Target::create({{&others}, nullptr}, "scratch");
  if (!one.ok() || !other.ok())
    return;
  const passes::ResolveEntry entry = passes::resolveEntry({});
  const passes::ResolveTile tile = passes::resolveTile({0, 0, side, side}, {&entry, 1}, 0);
  if (!m_resolvePass->upload({&tile, 1}, {&entry, 1}))
    return;
  for (int i = 0; i < rounds; ++i)
    m_resolvePass->draw(device, i % 2 == 0 ? **one : **other,
                        {.colours = colours, .inks = inks, .depths = depths});
  device.finish();
}

Status LayerPainter::makeRoom(gpu::Device& device) {
  if (m_atlas.outgrown() && m_atlas.release())
    letGo(device);
  return m_atlas.allocate();
}

void LayerPainter::takeSpares(std::vector<Layer>& layers, std::span<const std::size_t> changed) {
  std::vector<std::size_t> order(changed.begin(), changed.end());
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return areaOf(layers[a].area) > areaOf(layers[b].area);
  });
  std::stable_sort(m_spares.begin(), m_spares.end(),
                   [](const LayerPixels& a, const LayerPixels& b) {
                     return a.depths.capacity() > b.depths.capacity();
                   });
  for (std::size_t i = 0; i < std::min(order.size(), m_spares.size()); ++i) {
    layers[order[i]].pixels = std::move(m_spares[i]);
    // What they held is another layer's, of another size: this one may show nothing, and would keep
    // it for its own.
    layers[order[i]].pixels.clear();
  }
  m_spares.clear();
}

Status LayerPainter::blendOnProcessor(Background background, const Canvas& canvas,
                                      std::span<const Layer> layers, const gpu::Texture* pixels) {
  const glm::vec4 ground = backgroundColour(background);
  const PixelRect& region = canvas.region;
  const std::size_t count = areaOf(region);
  if (!canvas.keeps || m_picture.size() != count)
    m_picture.assign(count, packedColour(ground));
  for (const Layer& layer : layers)
    if (layer.shows() && (layer.pixels.area != layer.area || !layer.pixels.complete()))
      return gpu::misfit(std::as_bytes(std::span(layer.pixels.depths)).size(), layer.area);
  const std::vector<BlendLayer> blended = blendLayers(layers, background);
  blend({region, blended, canvas.wanted, ground}, m_picture);
  return pixels ? pixels->upload(std::as_bytes(std::span(m_picture)),
                                 {0, 0, region.width, region.height})
                : Status(Unit{});
}

Status LayerPainter::upload(gpu::Device& device, std::span<Layer> layers) {
  TRY(makeRoom(device));
  for (Layer& layer : layers) {
    if (!layer.onProcessor || layer.uploaded || layer.pixels.empty())
      continue;
    const LayerPixels& pixels = layer.pixels;
    if (layer.filled)
      TRY(m_atlas.colours().upload(std::as_bytes(std::span(pixels.colours)), layer.slot));
    TRY(m_atlas.inks().upload(std::as_bytes(std::span(pixels.inks)), layer.slot));
    TRY(m_atlas.layerDepths().upload(std::as_bytes(std::span(pixels.depths)), layer.slot));
    layer.uploaded = true;
  }
  return Unit{};
}

Result<LayerPainter::Outcome> LayerPainter::drive(gpu::Device& device, const PictureInput& input,
                                                  std::vector<Layer>& layers,
                                                  std::span<const std::size_t> driven,
                                                  Stopwatch& stopwatch) {
  TRY(upload(device, layers));
  TRY(drawSurfaces(device, input, layers, driven));
  stopwatch.pass(&device, "surface");
  if (input.isUnwanted())
    return Outcome::givenUp;
  // Hatching comes before lines, which lie on it.
  TRY(m_printedHatching.draw(device, {input.view, m_atlas, input.light}, layers, driven));
  TRY(drawInk(device, input, layers, driven));
  stopwatch.pass(&device, "ink");
  for (const std::size_t i : driven) {
    layers[i].triangles = {};
    layers[i].pixels = {};
  }
  return Outcome::painted;
}

Result<LayerPainter::Outcome> LayerPainter::paint(gpu::Device* device, const PictureInput& input,
                                                  const PixelRect& region,
                                                  const PictureCanvas& picture,
                                                  Stopwatch& stopwatch) {
  std::vector<Layer> layers = planLayers(input.shown, input.view, region, input.parts);
  for (Layer& layer : layers)
    layer.surfaceStep = input.surfaceStep;
  std::vector<std::size_t> changed =
      reuse(layers, {input.view.camera(), input.view.bounds(), input.view.size(), input.background,
                     input.light, input.keyLight, input.parts, input.surfaceStep, region});
  if (!place(layers, changed))
    return Outcome::tooLarge;
  takeSpares(layers, changed);
  completeSurfaces(input, layers, changed);
  stopwatch.pass(device, "plan");
  if (input.isUnwanted())
    return Outcome::givenUp;

  completeLayers(input, region, layers, changed, stopwatch);
  if (input.isUnwanted())
    return Outcome::givenUp;

  const auto drawn = [&](const Layer& layer) { return layer.onProcessor; };
  std::vector<std::size_t> driven;
  std::copy_if(changed.begin(), changed.end(), std::back_inserter(driven),
               [&](std::size_t i) { return !drawn(layers[i]); });
  const bool blends = input.processor && std::all_of(layers.begin(), layers.end(), drawn);
  if (!blends && !device)
    return Outcome::needsDriver;
  if (!blends) {
    auto outcome = drive(*device, input, layers, driven, stopwatch);
    if (!outcome || *outcome != Outcome::painted)
      return outcome;
  }
  const Canvas all = canvas(picture.target.get(), region, layers, changed, blends);
  TRY(blends ? blendOnProcessor(input.background, all, layers, picture.colour.get())
             : resolve(*device, input.background, all, layers));
  stopwatch.pass(device, "resolve");
  m_layersDrawn = int(std::count_if(changed.begin(), changed.end(),
                                    [&](std::size_t i) { return !layers[i].covered; }));
  for (const std::size_t i : changed)
    layers[i].drawing = ++m_drawings;
  m_kept = std::move(layers);
  m_outlines.next();
  return Outcome::painted;
}

}  // namespace sline::render
