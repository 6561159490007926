# What the libraries and the executable need, all from Debian 12; docs/building.md
# lists the purpose of each.
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenCV REQUIRED COMPONENTS core imgproc imgcodecs calib3d aruco dnn)
find_package(OpenMesh REQUIRED)
find_package(embree 3 REQUIRED)
find_package(Ceres 2.1 REQUIRED)
find_package(nlohmann_json REQUIRED)
# lib3mf has neither a CMake package nor, in Debian, its headers on the path.
find_library(LIB3MF_LIBRARY 3MF REQUIRED)
find_path(LIB3MF_INCLUDE_DIR Model/COM/NMR_DLLInterfaces.h PATH_SUFFIXES lib3mf
          REQUIRED)
# What the protocols of benchmarks read and search with; linked by name.
find_library(MATIO_LIBRARY matio REQUIRED)
find_library(TINYXML2_LIBRARY tinyxml2 REQUIRED)
find_path(NANOFLANN_INCLUDE_DIR nanoflann.hpp REQUIRED)
