// The steppers a system can be integrated with, as one variant in the order of ode::Method: the
// place where a method becomes a type.
#pragma once

#include <variant>

#include "sim/ode/abm4.h"
#include "sim/ode/exponential_rk4.h"
#include "sim/ode/runge_kutta.h"
#include "sim/ode/solver_settings.h"
#include "sim/ode/system.h"
#include "sim/ode/tableau.h"

namespace rotorbench::ode {

template <class System, class... More>
using StepperVariant =
    std::variant<RungeKutta<EulerTableau, System>, RungeKutta<Rk4Tableau, System>, Abm4<System>,
                 RungeKutta<Rk547MTableau, System>, RungeKutta<Rk546MTableau, System>,
                 RungeKutta<Rk547STableau, System>, More...>;

template <OdeSystem System>
struct StepperOf {
  using type = StepperVariant<System>;
};
template <OdeSystem System>
requires HasLinearPairs<System>
struct StepperOf<System> {
  using type = StepperVariant<System, ExponentialRk4<System>>;
};

/// Throws InputError (path "method"): the model has no linear pairs.
[[noreturn]] void refuse(Method method);

/// A fresh stepper. Throws InputError if the method is exponential and the system names no linear
/// pairs.
template <OdeSystem System>
typename StepperOf<System>::type makeStepper(Method method) {
  using Variant = typename StepperOf<System>::type;
  switch (method) {
    case Method::Euler:
      return Variant(std::in_place_index<0>);
    case Method::Rk4:
      return Variant(std::in_place_index<1>);
    case Method::Abm4:
      return Variant(std::in_place_index<2>);
    case Method::Rk547M:
      return Variant(std::in_place_index<3>);
    case Method::Rk546M:
      return Variant(std::in_place_index<4>);
    case Method::Rk547S:
      return Variant(std::in_place_index<5>);
    case Method::ExponentialRk4:
      if constexpr (HasLinearPairs<System>) return Variant(std::in_place_index<6>);
  }
  refuse(method);
}

}  // namespace rotorbench::ode
