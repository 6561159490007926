// A synthetic scene as a COLMAP workspace with ground truth:
//   images/<view>  masks/<view>.png  sparse/0/*.bin  gt/reference.ply
// and of a turntable also background/, photographs of the set without object.
#pragma once

#include <filesystem>

#include "colmap_io/model/sparse_model.h"
#include "core/base/context.h"
#include "core/benchmark/synthetic/synthetic_scene.h"

namespace octacut {

// The file that marks a folder as an example; the report of its making.
inline constexpr const char* kExampleReportName = "example.json";

struct ExampleWorkspaceOptions {
  bool overwrite = false;  // an earlier example
  int jpeg_quality = 95;   // 1 to 100; for views named .jpg

  void Check() const;  // throws OptionError
};

// What structure from motion would have written: one camera (PINHOLE, or
// SIMPLE_RADIAL for a lens that distorts), the views' reported poses, the
// sparse points with their observations.
SparseModel ToSparseModel(const SyntheticScene& scene);

// Throws InputError for a folder that exists and is neither empty nor that of
// an example, or that holds an example, without options.overwrite.
void CheckExampleFolder(const std::filesystem::path& folder,
                        const ExampleWorkspaceOptions& options);

// Makes `folder`, or removes the folders that an earlier example consists of.
// Throws as CheckExampleFolder does.
void PrepareExampleFolder(const std::filesystem::path& folder,
                          const ExampleWorkspaceOptions& options);

// Writes the scene into a prepared folder. Throws Error when a file cannot be
// written.
void WriteExampleWorkspace(const SyntheticScene& scene,
                           const std::filesystem::path& folder,
                           const ExampleWorkspaceOptions& options,
                           const Context& context);

}  // namespace octacut
