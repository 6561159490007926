// Reads COLMAP sparse models, binary and text, of every version of COLMAP.
//
// Newer versions also write rigs.* and frames.*; images.* holds the composed
// poses all the same, so those are not read.
//
// Every reader throws InputError with one line that names file, field and
// value. Counts in a file are checked against what its remaining bytes can
// hold before memory is taken for them. Text is read in the C locale whatever
// the process has.
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "colmap_io/model/sparse_model.h"

namespace octacut {

// The model in a folder: its .bin files when cameras, images and points3D all
// exist as .bin, else its .txt files. Consistent as CheckSparseModel demands.
// An empty points3D.txt is a model without points.
SparseModel ReadSparseModel(const std::filesystem::path& folder);

// How many images the model has, without reading more than that takes.
uint64_t CountSparseImages(const std::filesystem::path& folder);

// One file's content from a stream opened in binary mode; `name` is what
// messages call it. Each value is checked by itself; what files say of each
// other and ids that occur twice are left to CheckSparseModel.
// Quaternions are normalized; zero ones are refused.
std::vector<SparseCamera> ReadCamerasBinary(std::istream& stream,
                                            const std::string& name);
std::vector<SparseImage> ReadImagesBinary(std::istream& stream,
                                          const std::string& name);
std::vector<SparsePoint> ReadPointsBinary(std::istream& stream,
                                          const std::string& name);
std::vector<SparseCamera> ReadCamerasText(std::istream& stream,
                                          const std::string& name);
std::vector<SparseImage> ReadImagesText(std::istream& stream,
                                        const std::string& name);
std::vector<SparsePoint> ReadPointsText(std::istream& stream,
                                        const std::string& name);

}  // namespace octacut
