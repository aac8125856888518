// SPDX-License-Identifier: Apache-2.0
#include "tests/cli/sline_process.h"

#include <OpenImageIO/imagebuf.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <algorithm>

#include "tests/support/shapes.h"

namespace sline::test {

namespace {

Finished finished(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.start(program, arguments);
  if (!process.waitForFinished(600000)) {
    process.kill();
    process.waitForFinished();
    return {};
  }
  const bool crashed = process.exitStatus() != QProcess::NormalExit;
  return {crashed ? -1 : process.exitCode(), process.readAllStandardOutput(),
          process.readAllStandardError()};
}

}  // namespace

Finished runSline(const QStringList& arguments) {
  return finished(QStringLiteral(SLINE_PROGRAM), arguments);
}

Finished runSlineCopiedTo(const QString& folder, const QStringList& arguments) {
  const QString copy = folder + "/sline";
  if (!QFile::exists(copy) && !QFile::copy(QStringLiteral(SLINE_PROGRAM), copy))
    qFatal("cannot write %s", qPrintable(copy));
  return finished(copy, arguments);
}

Finished runSlineLed(const QString& streams, const QStringList& arguments) {
  return finished(QStringLiteral("/bin/sh"), QStringList{"-c", "exec \"$0\" \"$@\" " + streams,
                                                         QStringLiteral(SLINE_PROGRAM)} +
                                                 arguments);
}

void writeFile(const QString& file, const QByteArray& text) {
  QFile target(file);
  if (!target.open(QIODevice::WriteOnly) || target.write(text) != text.size())
    qFatal("cannot write %s", qPrintable(file));
}

void writeObj(const QString& file, const model::Mesh& mesh, const QString& group) {
  QByteArray text;
  if (!group.isEmpty())
    text += "g " + group.toUtf8() + "\n";
  for (const glm::vec3& p : mesh.positions())
    text += "v " + QByteArray::number(double(p.x), 'g', 9) + " " +
            QByteArray::number(double(p.y), 'g', 9) + " " +
            QByteArray::number(double(p.z), 'g', 9) + "\n";
  for (const model::Triangle& t : mesh.triangles())
    text += "f " + QByteArray::number(t[0] + 1) + " " + QByteArray::number(t[1] + 1) + " " +
            QByteArray::number(t[2] + 1) + "\n";
  writeFile(file, text);
}

QString writeSample(const QString& folder) {
  const QDir top(folder + "/sample");
  top.mkpath("Organs");
  top.mkpath("Vessels");
  writeObj(top.filePath("Organs/kidney.obj"), *sphere(30.0f, 4));
  const model::MeshPtr small = sphere(10.0f, 3);
  writeObj(top.filePath("Vessels/renal artery.obj"), *moved(*small, 1.0f, {60.0f, 0.0f, 0.0f}));
  writeObj(top.filePath("Vessels/renal vein.obj"), *moved(*small, 1.0f, {-60.0f, 0.0f, 0.0f}));
  return top.path();
}

QByteArray frontCamera() {
  return R"({"projection":"perspective","eye":[0,-400,0],"target":[0,0,0],"up":[0,0,1],)"
         R"("fovy_deg":30})";
}

Pixels readPicture(const QString& file) {
  OIIO::ImageSpec hints;
  hints["oiio:UnassociatedAlpha"] = 1;
  OIIO::ImageBuf buffer(file.toStdString(), 0, 0, nullptr, &hints);
  if (!buffer.read(0, 0, true, OIIO::TypeDesc::UINT8))
    return {};
  const OIIO::ImageSpec& spec = buffer.spec();
  Pixels picture{spec.width, spec.height, spec.nchannels, {}};
  picture.rgba.assign(std::size_t(4 * spec.width * spec.height), 255);
  if (spec.nchannels < 3 || !buffer.get_pixels(OIIO::ROI(0, spec.width, 0, spec.height, 0, 1, 0,
                                                         std::min(4, spec.nchannels)),
                                               OIIO::TypeDesc::UINT8, picture.rgba.data(), 4))
    return {};
  return picture;
}

PixelBox drawnBox(const Pixels& picture) {
  PixelBox box{picture.width, picture.height, -1, -1};
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      if (std::equal(picture.at(x, y), picture.at(x, y) + 4, picture.at(0, 0)))
        continue;
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x),
             std::max(box.bottom, y)};
    }
  return box.right < 0 ? PixelBox{} : box;
}

Tinted tinted(const Pixels& picture, int strong) {
  Tinted found;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const unsigned char* p = picture.at(x, y);
      const int others = std::max(p[(strong + 1) % 3], p[(strong + 2) % 3]);
      if (p[strong] < others + 60)
        continue;
      ++found.count;
      found.column += x;
    }
  if (found.count > 0)
    found.column /= found.count;
  return found;
}

}  // namespace sline::test
