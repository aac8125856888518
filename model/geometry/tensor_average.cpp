// SPDX-License-Identifier: Apache-2.0
#include "model/geometry/tensor_average.h"

#include "model/base/parallel.h"
#include "model/geometry/face_sums.h"

namespace sline::model {

namespace {
/// Returns how much an edge counts in one of its triangles; nothing where both corners are one
/// vertex.
Lanes halfUnlessOne(const FourFaces& faces, std::size_t corner, std::size_t next) {
  const auto half = [&](std::size_t lane) {
    return faces.vertices[lane][corner] != faces.vertices[lane][next] ? 0.5f : 0.0f;
  };
  return Lanes{half(0), half(1), half(2), half(3)};
}
}  // namespace

TensorAverage::TensorAverage(const Mesh& mesh, std::span<const glm::vec3> normals)
    : m_mesh(mesh), m_turns(foursOf(mesh.triangleCount())) {
  forFourFaces(mesh, [&](const FourFaces& faces) {
    const Corners<Vector<Lanes>> n{cornerVectors(normals, faces, 0),
                                   cornerVectors(normals, faces, 1),
                                   cornerVectors(normals, faces, 2)};
    const Corners<TangentFrame<Lanes>> frames{tangentFrame(n[0]), tangentFrame(n[1]),
                                              tangentFrame(n[2])};
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t next = (j + 1) % 3;
      m_turns[faces.number][j] = turnOf(turned(frames[j].u, n[j], n[next]), frames[next]);
    }
  });
}

void TensorAverage::step(std::vector<glm::vec3>& tensors) const {
  const std::vector<glm::vec4> sums = summedOverFaces(m_mesh, [&](const FourFaces& faces) {
    Corners<TangentTensor<Lanes>> own;
    for (std::size_t j = 0; j < 3; ++j) {
      const Vector<Lanes> tensor = cornerVectors(tensors, faces, j);
      own[j] = {tensor.x, tensor.y, tensor.z};
    }
    CornerShares shares{};
    const auto add = [&shares](std::size_t corner, const TangentTensor<Lanes>& tensor,
                               Lanes weight) {
      shares[corner][0] += weight * tensor.uu;
      shares[corner][1] += weight * tensor.uv;
      shares[corner][2] += weight * tensor.vv;
      shares[corner][3] += weight;
    };
    for (std::size_t j = 0; j < 3; ++j) {
      const std::size_t next = (j + 1) % 3;
      const Turn<Lanes>& turn = m_turns[faces.number][j];
      const Lanes weight = halfUnlessOne(faces, j, next);
      add(j, changed(own[next], turn), weight);
      add(next, changed(own[j], turn.back()), weight);
    }
    return shares;
  });
  parallelFor(tensors.size(), 8192, [&](std::size_t v) {
    tensors[v] = (tensors[v] + glm::vec3(sums[v])) / (1.0f + sums[v].w);
  });
}

}  // namespace sline::model
