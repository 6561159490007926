// Pages from what the commands have measured.
#pragma once

#include <string>
#include <vector>

#include "core/base/context.h"
#include "core/mesh/indexed_mesh.h"
#include "plugin/command.h"
#include "plugin/page/comparison_page.h"

namespace octacut {

// A mesh or a cloud for a page of `num_meshes`, without values.
PageMesh MakePageMesh(const std::string& name,
                      const IndexedMesh& mesh,
                      size_t num_meshes,
                      const Context& context);

// Adds signed distances of the mesh's vertices.
void AddDistances(const std::string& other,
                  std::vector<float> distances,
                  PageMesh* page);

// The places of the largest distances, or of the least support; at most ten,
// apart from each other by a fiftieth of `diagonal`. `values` of the vertices.
void FindDistancePlaces(const IndexedMesh& mesh,
                        const std::vector<float>& values,
                        double diagonal,
                        const Context& context,
                        PageMesh* page);
void FindUnsupportedPlaces(const IndexedMesh& mesh,
                           const std::vector<float>& values,
                           double diagonal,
                           const Context& context,
                           PageMesh* page);

// Colours of the displayed vertices from the photographs.
void PaintFromPhotographs(const IndexedMesh& mesh,
                          const std::vector<View>& views,
                          const Context& context,
                          PageMesh* page);

// "octacut COMMAND --option value ...": what the user has set.
std::string CommandLineOf(const CommandEnvironment& environment);

// Version and seed, as lines of the procedure.
std::vector<std::string> ProcedureOfRun(const CommandEnvironment& environment);

}  // namespace octacut
