// A system whose right-hand side is a plain function, so that many test problems of one size share
// one instantiation of the solver; and settings in one line.
#pragma once

#include "sim/ode/solver.h"

namespace rotorbench::test {

template <int N>
struct FunctionSystem {
  using State = Eigen::Matrix<double, N, 1>;
  using Function = void (*)(double, const State&, State&);
  Function function;
  void operator()(double t, const State& y, State& dydt) const { function(t, y, dydt); }
};

inline ode::SolverSettings fixedStep(ode::Method method, double step) {
  ode::SolverSettings s;
  s.method = method;
  s.step = step;
  return s;
}

inline ode::SolverSettings adaptive(
    ode::Method method, double tolerance, ode::Norm norm = ode::Norm::Rms,
    ode::StepController controller = ode::StepController::Elementary) {
  ode::SolverSettings s;
  s.method = method;
  ode::ScaledErrorControl control;
  control.relativeTolerance = control.absoluteTolerance = tolerance;
  control.norm = norm;
  control.controller = controller;
  s.errorControl = control;
  return s;
}

/// An embedded method with every step equal to `step`.
inline ode::SolverSettings embeddedFixed(ode::Method method, double step) {
  ode::SolverSettings s = adaptive(method, 1e5);
  s.initialStep = s.maximumStep = step;
  return s;
}

/// Any method with steps of equal length.
inline ode::SolverSettings equalSteps(ode::Method method, double step) {
  return ode::isAdaptive(method) ? embeddedFixed(method, step) : fixedStep(method, step);
}

}  // namespace rotorbench::test
