// Which solver integrates the equations of motion and how: the parameters of sim/ode, described
// once for files, forms and help. Times in s. Methods: J. R. Dormand and P. J. Prince, "A family of
// embedded Runge-Kutta formulae", J. Comput. Appl. Math. 6 (1980) 19-26; E. Hairer, S. P. Norsett
// and G. Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (Springer 1993); S. M. Cox
// and P. C. Matthews, "Exponential time differencing for stiff systems", J. Comput. Phys. 176
// (2002) 430-455.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <variant>

#include "sim/core/schema.h"

namespace rotorbench::ode {

enum class Method { Euler, Rk4, Abm4, Rk547M, Rk546M, Rk547S, ExponentialRk4 };

/// What files hold, what a person reads, and what each method is.
struct MethodInfo {
  Method method;
  std::string_view key;
  std::string_view name;
  std::string_view help;
  bool adaptive;  ///< embedded pair: chooses its own step from an error estimate
};

/// All methods in the order of the enumeration.
inline constexpr std::array<MethodInfo, 7> kMethods{{
    {Method::Euler, "euler", "Euler", "First order, one evaluation a step.", false},
    {Method::Rk4, "rk4", "RK4", "Classic Runge-Kutta, fourth order, four evaluations a step.",
     false},
    {Method::Abm4, "abm4", "ABM4",
     "Adams-Bashforth-Moulton, fourth order, predict-evaluate-correct-evaluate: two evaluations a "
     "step after three RK4 steps.",
     false},
    {Method::Rk547M, "rk547m", "RK5(4)7M",
     "Dormand-Prince pair of ode45 and dopri5, fifth order with error estimate.", true},
    {Method::Rk546M, "rk546m", "RK5(4)6M",
     "Dormand-Prince pair with six stages, fifth order with error estimate.", true},
    {Method::Rk547S, "rk547s", "RK5(4)7S",
     "Dormand-Prince pair with the wider stability region, fifth order with error estimate.", true},
    {Method::ExponentialRk4, "exponential-rk4", "Exponential RK4",
     "Fourth order; the linear speed-current pair of each motor is solved exactly, the rest as by "
     "RK4.",
     false},
}};

constexpr const MethodInfo& info(Method m) {
  return kMethods[static_cast<std::size_t>(m)];
}
constexpr std::string_view name(Method m) {
  return info(m).name;
}
constexpr std::string_view key(Method m) {
  return info(m).key;
}
constexpr bool isAdaptive(Method m) {
  return info(m).adaptive;
}

/// Norm of the (scaled) local error vector.
enum class Norm { Rms, Euclidean, Maximum };

/// How the next step follows from the error: the last one only, or the last two.
enum class StepController { Elementary, ProportionalIntegral };

/// The modern error control: each component's error is divided by absolute + relative *
/// |component|, and the norm of the quotients must not exceed 1 (Hairer, Norsett, Wanner, eqs.
/// II.4.10-4.13).
struct ScaledErrorControl {
  double relativeTolerance = 1e-6;
  double absoluteTolerance = 1e-9;
  Norm norm = Norm::Rms;
  StepController controller = StepController::ProportionalIntegral;
  double safety = 0.9;
  double keptChange = 0.05;   ///< a step is kept where it would change by less
  double shrinkLimit = 0.2;   ///< smallest ratio of two successive steps
  double growthLimit = 10.0;  ///< largest ratio of two successive steps
  bool operator==(const ScaledErrorControl&) const = default;
};

/// The 2014 thesis' control, eq. (1.50): h_new = 0.9 h (tolerance / |e|)^(1/5) after every step,
/// accepted or not, without a limit on growth; the first step tried is the whole span. Printed with
/// the maximum norm; its published step counts come from the Euclidean norm.
struct ThesisErrorControl {
  double tolerance = 1e-3;
  Norm norm = Norm::Euclidean;
  bool operator==(const ThesisErrorControl&) const = default;
};

struct SolverSettings {
  Method method = Method::Rk4;
  double step = 1e-3;  ///< s; step of the fixed-step methods
  std::variant<ScaledErrorControl, ThesisErrorControl> errorControl{};
  double initialStep = 0;  ///< s; 0: chosen from the derivatives
  double minimumStep = 0;  ///< s; a smaller step is a failure; 0: the resolution of time itself
  double maximumStep = 0;  ///< s; 0: no limit
  std::int64_t maximumSteps = 10'000'000;  ///< steps, rejected ones included, in one advance
  bool operator==(const SolverSettings&) const = default;
};

}  // namespace rotorbench::ode

namespace rotorbench {

template <>
struct Describe<ode::ScaledErrorControl> {
  static void fields(schema::Builder<ode::ScaledErrorControl>& b);
};
template <>
struct Describe<ode::ThesisErrorControl> {
  static void fields(schema::Builder<ode::ThesisErrorControl>& b);
};
template <>
struct Describe<ode::SolverSettings> {
  static void fields(schema::Builder<ode::SolverSettings>& b);
};

}  // namespace rotorbench
