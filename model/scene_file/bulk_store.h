// SPDX-License-Identifier: Apache-2.0
// Keeps meshes, what is painted on them and voxels beside a journal, each once, however many states
// of the scene have it.
#pragma once

#include <chrono>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <variant>

#include "model/disk/appended_file.h"
#include "model/scene/scene.h"

namespace sline::model {

/// What scenes share by pointers, because it is large.
using BulkItem = std::variant<MeshPtr, VoxelsPtr, PaintPtr>;
/// Maps keys to items. A key is made of the item's size and checksums, so that the same item has
/// the same key in any journal and scene file.
using Bulk = std::map<std::string, BulkItem, std::less<>>;

/// Computes keys, each item's once; it holds what it has seen.
class BulkKeys {
 public:
  const std::string& of(const MeshPtr& mesh);
  const std::string& of(const VoxelsPtr& voxels);
  const std::string& of(const PaintPtr& paint);
  /// Returns the items whose keys were asked for since the last call and never before.
  std::vector<std::pair<std::string, BulkItem>> takeFresh() { return std::exchange(m_fresh, {}); }

 private:
  const std::string& remembered(const BulkItem& item);
  std::map<BulkItem, std::string> m_keys;
  std::vector<std::pair<std::string, BulkItem>> m_fresh;
};

/// The file of a journal's items, written a little at a time.
class BulkStore {
 public:
  static Result<BulkStore> create(const std::filesystem::path& file);
  /// Adds the item to those to be written, unless it is there.
  void want(const std::string& key, const BulkItem& item);
  bool complete() const { return m_wanted.empty(); }
  /// Writes items until all are written or the time is over, at least one.
  Status write(std::chrono::milliseconds atMost);
  Status sync() { return m_file->sync(); }

 private:
  explicit BulkStore(std::unique_ptr<AppendedFile> file) : m_file(std::move(file)) {}
  std::unique_ptr<AppendedFile> m_file;
  std::set<std::string> m_known;
  std::deque<std::pair<std::string, BulkItem>> m_wanted;
};

/// Returns the items of a file that are whole; nothing in it is trusted.
Bulk bulkFrom(std::string_view bytes);
/// Returns the meshes, paints and voxels of a scene.
Bulk bulkOf(const Scene& scene);

}  // namespace sline::model
