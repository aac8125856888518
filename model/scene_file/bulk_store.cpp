// SPDX-License-Identifier: Apache-2.0
#include "model/scene_file/bulk_store.h"

#include <type_traits>

#include "model/scene_file/fingerprint.h"
#include "model/scene_file/journal_records.h"
#include "model/scene_file/mesh_codec.h"
#include "model/scene_file/paint_codec.h"
#include "model/scene_file/scan_codec.h"

namespace sline::model {

namespace {
constexpr char meshKind = 'M';
constexpr char voxelKind = 'V';
constexpr char paintKind = 'P';

template <class Items>
std::string sumOf(const Items& items) {
  using Item = std::remove_cvref_t<decltype(items[0])>;
  const Fingerprint sum =
      fingerprintOf({reinterpret_cast<const char*>(items.data()), items.size() * sizeof(Item)});
  return std::to_string(items.size()) + "-" + std::to_string(sum.crc);
}

std::string keyOf(const BulkItem& item) {
  if (const auto* mesh = std::get_if<MeshPtr>(&item))
    return "m" + sumOf((*mesh)->positions()) + "-" + sumOf((*mesh)->triangles());
  if (const auto* paint = std::get_if<PaintPtr>(&item))
    return "p" + sumOf(**paint);
  return "v" + sumOf(*std::get<VoxelsPtr>(item));
}

/// Returns the letter of the item's kind and its bytes.
std::pair<char, std::string> encoded(const BulkItem& item) {
  if (const auto* mesh = std::get_if<MeshPtr>(&item))
    return {meshKind, encodedMesh(**mesh)};
  if (const auto* paint = std::get_if<PaintPtr>(&item))
    return {paintKind, encodedPaint(**paint)};
  return {voxelKind, encodedVoxels(*std::get<VoxelsPtr>(item))};
}

std::string payloadOf(const std::string& key, const BulkItem& item) {
  const auto [kind, bytes] = encoded(item);
  std::string payload(1, kind);
  appendNumber(payload, std::uint32_t(key.size()));
  return payload + key + bytes;
}

/// Returns null where the bytes are no such item.
BulkItem itemFrom(char kind, std::string_view bytes) {
  if (kind == meshKind)
    if (Result<Mesh> mesh = decodedMesh(bytes); mesh.ok())
      return std::make_shared<const Mesh>(std::move(*mesh));
  if (kind == voxelKind)
    if (Result<std::vector<std::int16_t>> voxels = decodedVoxels(bytes); voxels.ok())
      return std::make_shared<const std::vector<std::int16_t>>(std::move(*voxels));
  if (kind == paintKind)
    if (Result<Paint> paint = decodedPaint(bytes); paint.ok())
      return std::make_shared<const Paint>(std::move(*paint));
  return MeshPtr();
}
}  // namespace

const std::string& BulkKeys::remembered(const BulkItem& item) {
  const auto [place, fresh] = m_keys.try_emplace(item);
  if (fresh) {
    place->second = keyOf(item);
    m_fresh.emplace_back(place->second, item);
  }
  return place->second;
}

const std::string& BulkKeys::of(const MeshPtr& mesh) {
  return remembered(mesh);
}

const std::string& BulkKeys::of(const VoxelsPtr& voxels) {
  return remembered(voxels);
}

const std::string& BulkKeys::of(const PaintPtr& paint) {
  return remembered(paint);
}

Result<BulkStore> BulkStore::create(const std::filesystem::path& file) {
  std::unique_ptr<AppendedFile> made = TRY(AppendedFile::create(file));
  TRY(made->add(journalMagic));
  return BulkStore(std::move(made));
}

void BulkStore::want(const std::string& key, const BulkItem& item) {
  if (m_known.insert(key).second)
    m_wanted.emplace_back(key, item);
}

Status BulkStore::write(std::chrono::milliseconds atMost) {
  const auto end = std::chrono::steady_clock::now() + atMost;
  while (!m_wanted.empty()) {
    const auto& [key, item] = m_wanted.front();
    TRY(m_file->add(recordOf(payloadOf(key, item))));
    m_wanted.pop_front();
    if (std::chrono::steady_clock::now() >= end)
      break;
  }
  return Unit{};
}

Bulk bulkFrom(std::string_view bytes) {
  Bulk bulk;
  RecordReader records(bytes);
  while (auto payload = records.nextWhole()) {
    const char kind = payload->front();
    payload->remove_prefix(1);
    const auto length = takeNumber(*payload);
    const auto key = length ? takeBytes(*payload, *length) : std::nullopt;
    const BulkItem item = key ? itemFrom(kind, *payload) : BulkItem();
    if (std::visit([](const auto& pointer) { return pointer != nullptr; }, item))
      bulk.insert_or_assign(std::string(*key), item);
  }
  return bulk;
}

Bulk bulkOf(const Scene& scene) {
  Bulk bulk;
  for (const MeshPtr& mesh : meshesOf(scene))
    bulk[keyOf(mesh)] = mesh;
  for (const Node& node : scene.nodes())
    if (node.paint)
      bulk[keyOf(node.paint)] = node.paint;
  for (const Scan& scan : scene.scans())
    bulk[keyOf(scan.voxels)] = scan.voxels;
  return bulk;
}

}  // namespace sline::model
