// What the solvers integrate: y' = f(t, y) with t in s and a state of fixed size. A system is a
// callable object; everything beyond the derivative is optional and found by concept.
//
//   struct Pendulum {
//     using State = Eigen::Matrix<double, 2, 1>;
//     void operator()(double, const State& y, State& dydt) const { dydt << y[1], -9.81 *
//     std::sin(y[0]); }
//   };
//
// A large right-hand side should be marked [[gnu::noinline]]: the solvers call it from many places,
// and the call costs nothing beside it.
#pragma once

#include <Eigen/Core>
#include <concepts>
#include <string_view>
#include <utility>

namespace rotorbench::ode {

template <class S>
concept OdeSystem = requires(S& s, double t, const typename S::State& y, typename S::State& dydt) {
  s(t, y, dydt);
  requires S::State::ColsAtCompileTime == 1 && (S::State::RowsAtCompileTime > 0);
  requires std::same_as<typename S::State::Scalar, double>;
};

/// `void afterStep(State& y)`: projects the state after every accepted step, for example normalises
/// a quaternion. It must move the state by no more than the local error: the derivative a
/// first-same-as-last method carries over is then still good to the method's own order and is not
/// computed again.
template <class S>
concept HasAfterStep = requires(S& s, typename S::State& y) {
  s.afterStep(y);
};

/// `componentName(int i)`: the name of state component i in failure messages, such as
/// "rotor1.speed".
template <class S>
concept HasComponentNames = requires(const S& s, int i) {
  { s.componentName(i) } -> std::convertible_to<std::string_view>;
};

/// Two-by-two linear parts for the exponential method: kPairs pairs of state components with
/// disjoint indices, and for each the constant matrix A in d(pair)/dt = A * pair + rest.
template <class S>
concept HasLinearPairs = requires(const S& s, int i) {
  { S::kPairs } -> std::convertible_to<int>;
  { S::pair(i) } -> std::convertible_to<std::pair<int, int>>;
  { s.linear(i) } -> std::convertible_to<Eigen::Matrix2d>;
};

}  // namespace rotorbench::ode
