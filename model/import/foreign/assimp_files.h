// SPDX-License-Identifier: Apache-2.0
// Restricts the files that assimp may see.
#pragma once

#include <assimp/IOSystem.hpp>

#include "model/import/source/source.h"

namespace sline::model {

/// Shows assimp one file that is in memory and those to which it may refer: files in its folder or
/// below (fileInFolder). No other file can be opened, and none written.
class AssimpFiles : public Assimp::IOSystem {
 public:
  /// `source` must outlive this object.
  explicit AssimpFiles(const Source& source) : m_source(source) {}

  bool Exists(const char* name) const override;
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* mode) override;
  void Close(Assimp::IOStream* stream) override;

 private:
  const Source& m_source;
};

}  // namespace sline::model
