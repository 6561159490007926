#include "plugin/commands/version.h"

#include <fmt/core.h>
#include <spdlog/version.h>

#include <Eigen/Core>

#include "plugin/report.h"

namespace octacut {
namespace {

class Version : public Command {
 public:
  void DeclareOptions(OptionManager& /*options*/) override {}

  void Run(const CommandEnvironment& environment) override {
    environment.out << fmt::format("octacut {}\n", OctacutVersion())
                    << fmt::format("Eigen {}.{}.{}\n",
                                   EIGEN_WORLD_VERSION,
                                   EIGEN_MAJOR_VERSION,
                                   EIGEN_MINOR_VERSION)
                    << fmt::format("spdlog {}.{}.{}\n",
                                   SPDLOG_VER_MAJOR,
                                   SPDLOG_VER_MINOR,
                                   SPDLOG_VER_PATCH)
                    << fmt::format("compiler {}\n", __VERSION__);
  }
};

}  // namespace

std::unique_ptr<Command> MakeVersion() { return std::make_unique<Version>(); }

}  // namespace octacut
