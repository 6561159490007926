// MATLAB files for tests.
#pragma once

#include <matio.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace octacut {

class MatWriter {
 public:
  explicit MatWriter(const std::string& path)
      : file_(Mat_CreateVer(path.c_str(), nullptr, MAT_FT_MAT5)) {
    if (file_ == nullptr) {
      throw std::runtime_error(path);
    }
  }
  ~MatWriter() { Mat_Close(file_); }
  MatWriter(const MatWriter&) = delete;
  MatWriter& operator=(const MatWriter&) = delete;

  void Doubles(const char* name,
               std::vector<size_t> size,
               std::vector<double> values) {
    Write(Mat_VarCreate(name,
                        MAT_C_DOUBLE,
                        MAT_T_DOUBLE,
                        static_cast<int>(size.size()),
                        size.data(),
                        values.data(),
                        0));
  }
  void Logicals(const char* name,
                std::vector<size_t> size,
                std::vector<uint8_t> values) {
    Write(Mat_VarCreate(name,
                        MAT_C_UINT8,
                        MAT_T_UINT8,
                        static_cast<int>(size.size()),
                        size.data(),
                        values.data(),
                        MAT_F_LOGICAL));
  }

 private:
  void Write(matvar_t* variable) {
    Mat_VarWrite(file_, variable, MAT_COMPRESSION_ZLIB);
    Mat_VarFree(variable);
  }

  mat_t* file_;
};

}  // namespace octacut
