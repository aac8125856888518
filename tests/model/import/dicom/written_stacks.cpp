// SPDX-License-Identifier: Apache-2.0
#include "tests/model/import/dicom/written_stacks.h"

namespace sline::test {

int pattern(int x, int y, int z) {
  return (37 * x + 101 * y + 211 * z + (x * y) % 7) % 1500 - 200;
}

std::vector<WrittenImage> stack(const WrittenImage& like) {
  std::vector<WrittenImage> slices;
  for (int z = 0; z < 5; ++z) {
    WrittenImage slice = like;
    slice.position = {-30, 20, 100 + 2.5 * z};
    slice.value = [z](int x, int y) { return pattern(x, y, z); };
    slices.push_back(slice);
  }
  return slices;
}

QByteArray plain(const WrittenImage& written) {
  return dicomFile(image(written));
}

std::vector<std::filesystem::path> files(const QTemporaryDir& folder,
                                         const std::vector<WrittenImage>& slices,
                                         const Writer& writer) {
  std::vector<std::filesystem::path> paths;
  for (std::size_t i = 0; i < slices.size(); ++i) {
    const std::size_t k =
        (2 * i) % slices.size() + (slices.size() % 2 == 0 && 2 * i >= slices.size());
    paths.push_back(put(folder, QString("IM%1.dcm").arg(k), writer(slices[k])));
  }
  return paths;
}

Result<model::GreyVolume> volumeOf(const std::vector<WrittenImage>& slices, const Writer& writer) {
  const QTemporaryDir folder;
  return model::readDicomSeries(files(folder, slices, writer), {});
}

}  // namespace sline::test
