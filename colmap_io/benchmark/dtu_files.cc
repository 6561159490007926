#include "colmap_io/benchmark/dtu_files.h"

#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "core/base/error.h"

namespace octacut {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
  void operator()(mat_t* file) const { Mat_Close(file); }
};
struct FreeVariable {
  void operator()(matvar_t* variable) const { Mat_VarFree(variable); }
};
using MatFile = std::unique_ptr<mat_t, CloseFile>;
using MatVariable = std::unique_ptr<matvar_t, FreeVariable>;

// A numeric array as doubles, the first index fastest.
struct Array {
  std::vector<size_t> size;
  std::vector<double> values;
};

template <typename T>
void Convert(const matvar_t& variable, std::vector<double>* values) {
  const auto* data = static_cast<const T*>(variable.data);
  values->assign(data, data + values->size());
}

// Whether the class is one of numbers.
bool ConvertByClass(const matvar_t& variable, std::vector<double>* values) {
  switch (variable.class_type) {
    case MAT_C_DOUBLE:
      Convert<double>(variable, values);
      return true;
    case MAT_C_SINGLE:
      Convert<float>(variable, values);
      return true;
    case MAT_C_INT8:
      Convert<int8_t>(variable, values);
      return true;
    case MAT_C_UINT8:
      Convert<uint8_t>(variable, values);
      return true;
    case MAT_C_INT16:
      Convert<int16_t>(variable, values);
      return true;
    case MAT_C_UINT16:
      Convert<uint16_t>(variable, values);
      return true;
    case MAT_C_INT32:
      Convert<int32_t>(variable, values);
      return true;
    case MAT_C_UINT32:
      Convert<uint32_t>(variable, values);
      return true;
    default:
      return false;
  }
}

class Reader {
 public:
  explicit Reader(const fs::path& path)
      : path_(path), file_(Mat_Open(path.c_str(), MAT_ACC_RDONLY)) {
    if (!file_) {
      throw InputError(fmt::format(
          "{}: cannot be opened as a MATLAB file (.mat)", path.string()));
    }
  }

  bool Has(const char* name) const {
    return MatVariable(Mat_VarReadInfo(file_.get(), name)) != nullptr;
  }

  Array Read(const char* name) const {
    const MatVariable variable(Mat_VarRead(file_.get(), name));
    if (!variable) {
      Fail(name, "is missing or cannot be read");
    }
    Array array;
    size_t count = 1;
    for (int i = 0; i < variable->rank; ++i) {
      array.size.push_back(variable->dims[i]);
      count *= variable->dims[i];
    }
    array.values.resize(count);
    if (variable->isComplex != 0 || variable->data == nullptr ||
        variable->nbytes / static_cast<size_t>(variable->data_size) != count ||
        !ConvertByClass(*variable, &array.values)) {
      Fail(name, "must be a full array of real numbers");
    }
    for (const double value : array.values) {
      if (!std::isfinite(value)) {
        Fail(name, fmt::format("has the value {}", value));
      }
    }
    return array;
  }

  [[noreturn]] void Fail(const char* name, const std::string& problem) const {
    throw InputError(
        fmt::format("{}: variable {}: {}", path_.string(), name, problem));
  }

 private:
  fs::path path_;
  MatFile file_;
};

std::string Joined(const std::vector<fs::path>& paths) {
  std::string text;
  for (const fs::path& path : paths) {
    text.append(text.empty() ? "" : ",").append(path.string());
  }
  return text;
}

ObservabilityMask ReadMask(const Reader& reader) {
  ObservabilityMask mask;
  const Array cells = reader.Read("ObsMask");
  if (cells.size.size() != 3 || cells.values.empty()) {
    reader.Fail("ObsMask", "must have three dimensions");
  }
  std::copy(cells.size.begin(), cells.size.end(), mask.size.begin());
  mask.cells.reserve(cells.values.size());
  for (const double value : cells.values) {
    mask.cells.push_back(value != 0 ? 1 : 0);
  }
  const Array box = reader.Read("BB");
  if (box.size != std::vector<size_t>{2, 3}) {
    reader.Fail("BB", "must have 2 x 3 numbers");
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<size_t>(2 * axis);
    mask.box_min[axis] = box.values[at];
    mask.box_max[axis] = box.values[at + 1];
    if (!(mask.box_min[axis] < mask.box_max[axis])) {
      reader.Fail("BB", "the second row must be greater than the first");
    }
  }
  const Array size = reader.Read("Res");
  if (size.values.size() != 1 || !(size.values[0] > 0)) {
    reader.Fail("Res", "must be one positive number");
  }
  mask.cell_size = size.values[0];
  return mask;
}

Eigen::Vector4d ReadPlane(const Reader& reader) {
  const Array plane = reader.Read("P");
  if (plane.values.size() != 4) {
    reader.Fail("P", "must have 4 numbers");
  }
  return Eigen::Map<const Eigen::Vector4d>(plane.values.data());
}

}  // namespace

DtuCrop ReadDtuCrop(const std::vector<fs::path>& paths) {
  DtuCrop crop;
  bool has_mask = false;
  bool has_plane = false;
  for (const fs::path& path : paths) {
    const Reader reader(path);
    if (reader.Has("ObsMask") && !has_mask) {
      crop.mask = ReadMask(reader);
      has_mask = true;
    } else if (reader.Has("P") && !has_plane) {
      crop.plane = ReadPlane(reader);
      has_plane = true;
    } else {
      throw InputError(fmt::format(
          "{}: must hold the variables ObsMask, BB and Res, or P, and each of "
          "them may be given once",
          path.string()));
    }
  }
  if (!has_mask || !has_plane) {
    throw OptionError(fmt::format(
        "crop_path = {}: the protocol dtu needs the scan's {} as well",
        Joined(paths),
        has_mask ? "Plane<scan>.mat" : "ObsMask<scan>_10.mat"));
  }
  return crop;
}

}  // namespace octacut
