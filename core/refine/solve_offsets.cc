#include "core/refine/solve_offsets.h"

#include <ceres/ceres.h>

#include "core/base/error.h"

namespace octacut {
namespace {

constexpr int kMaxNewtonSteps = 4;
constexpr int kMaxLinearIterations = 40;

// scale * (offset - target)
class PlaceCost final : public ceres::SizedCostFunction<1, 1> {
 public:
  PlaceCost(double scale, double target) : scale_(scale), target_(target) {}
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override {
    residuals[0] = scale_ * (parameters[0][0] - target_);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      jacobians[0][0] = scale_;
    }
    return true;
  }

 private:
  double scale_;
  double target_;
};

// A linear function of some points' offsets.
class LinearCost final : public ceres::CostFunction {
 public:
  LinearCost(std::vector<double> factors, double constant)
      : factors_(std::move(factors)), constant_(constant) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->assign(factors_.size(), 1);
  }
  bool Evaluate(double const* const* parameters,
                double* residuals,
                double** jacobians) const override {
    residuals[0] = constant_;
    for (size_t i = 0; i < factors_.size(); ++i) {
      residuals[0] += factors_[i] * parameters[i][0];
      if (jacobians != nullptr && jacobians[i] != nullptr) {
        jacobians[i][0] = factors_[i];
      }
    }
    return true;
  }

 private:
  std::vector<double> factors_;
  double constant_;
};

// The weight of an offset of 0 where nothing is known, 1 / pixels: next to
// none, but the problem stays regular.
constexpr double kAnchor = 0.02;

class StopWhenCancelled final : public ceres::IterationCallback {
 public:
  explicit StopWhenCancelled(const Context& context) : context_(context) {}
  ceres::CallbackReturnType operator()(
      const ceres::IterationSummary&) override {
    return context_.IsCancelled() ? ceres::SOLVER_ABORT
                                  : ceres::SOLVER_CONTINUE;
  }

 private:
  const Context& context_;
};

class Builder {
 public:
  Builder(const OffsetProblem& input,
          const VertexCorners& neighbors,
          const SolveOffsetsOptions& options,
          std::vector<double>* offsets)
      : input_(input),
        neighbors_(neighbors),
        options_(options),
        offsets_(*offsets),
        loss_(options.outlier_scale),
        problem_(ProblemOptions()) {}

  ceres::Problem* Build() {
    for (size_t v = 0; v < offsets_.size(); ++v) {
      AddPoint(v);
      AddBendingEnergy(v);
    }
    for (const EdgeTarget& target : input_.edge_targets) {
      AddEdgeTarget(target);
    }
    return &problem_;
  }

 private:
  ceres::Problem::Options ProblemOptions() const {
    ceres::Problem::Options options;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    options.disable_all_safety_checks = true;
    return options;
  }

  void AddPoint(size_t v) {
    if (!input_.is_free[v]) {
      return;
    }
    if (input_.weights[v] > 0) {
      problem_.AddResidualBlock(
          new PlaceCost(input_.weights[v], input_.targets[v]),
          &loss_,
          &offsets_[v]);
    } else {
      problem_.AddResidualBlock(
          new PlaceCost(kAnchor, 0), nullptr, &offsets_[v]);
    }
  }

  void AddBendingEnergy(size_t v) {
    const std::span<const uint32_t> around = neighbors_.Of(v);
    if (around.empty()) {
      return;
    }
    const double scale = options_.smoothness / double(input_.spacings[v]);
    std::vector<double> factors;
    std::vector<double*> blocks;
    for (size_t i = 0; i < around.size(); ++i) {
      const uint32_t next = around[i];
      if (input_.is_free[next]) {
        factors.push_back(scale * input_.shares[neighbors_.offsets[v] + i] *
                          input_.normals[v].dot(input_.normals[next]));
        blocks.push_back(&offsets_[next]);
      }
    }
    if (input_.is_free[v]) {
      factors.push_back(-scale);
      blocks.push_back(&offsets_[v]);
    }
    if (!blocks.empty()) {
      problem_.AddResidualBlock(
          new LinearCost(std::move(factors), 0), nullptr, blocks);
    }
  }

  void AddEdgeTarget(const EdgeTarget& target) {
    std::vector<double> factors;
    std::vector<double*> blocks;
    const std::array<float, 2> shares = {1 - target.fraction, target.fraction};
    for (int i = 0; i < 2; ++i) {
      if (input_.is_free[target.points[i]]) {
        factors.push_back(double(target.weight) * shares[i]);
        blocks.push_back(&offsets_[target.points[i]]);
      }
    }
    if (!blocks.empty()) {
      problem_.AddResidualBlock(
          new LinearCost(std::move(factors),
                         -double(target.weight) * target.target),
          &loss_,
          blocks);
    }
  }

  const OffsetProblem& input_;
  const VertexCorners& neighbors_;
  const SolveOffsetsOptions& options_;
  std::vector<double>& offsets_;
  ceres::CauchyLoss loss_;
  ceres::Problem problem_;
};

ceres::Solver::Options SolverOptions(ceres::IterationCallback* callback) {
  ceres::Solver::Options options;
  // Offsets are carried some tens of edges, so few iterations do; a
  // factorisation for 150 000 vertices took minutes.
  options.linear_solver_type = ceres::CGNR;
  options.preconditioner_type = ceres::JACOBI;
  options.max_linear_solver_iterations = kMaxLinearIterations;
  options.eta = 1e-2;
  options.max_num_iterations = kMaxNewtonSteps;
  options.function_tolerance = 1e-4;
  // But for the loss the problem is linear: no damping.
  options.initial_trust_region_radius = 1e8;
  options.max_trust_region_radius = 1e12;
  // Sums of several threads would depend on their number.
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  options.callbacks.push_back(callback);
  return options;
}

}  // namespace

std::vector<double> SolveOffsets(const OffsetProblem& problem,
                                 const VertexCorners& neighbors,
                                 const SolveOffsetsOptions& options,
                                 const Context& context) {
  std::vector<double> offsets(problem.normals.size(), 0);
  Builder builder(problem, neighbors, options, &offsets);
  ceres::Problem* ceres_problem = builder.Build();
  if (ceres_problem->NumResidualBlocks() == 0) {
    return offsets;
  }
  context.ThrowIfCancelled();
  const Phase phase(context, "refinement: least squares");
  StopWhenCancelled callback(context);
  ceres::Solver::Summary summary;
  ceres::Solve(SolverOptions(&callback), ceres_problem, &summary);
  context.ThrowIfCancelled();

  if (!summary.IsSolutionUsable()) {
    throw InvariantError("refinement: " + summary.message);
  }
  return offsets;
}

}  // namespace octacut
