// What Odeint's array_algebra is for std::array, for any state of fixed size with an index: plain
// loops over the components. Odeint's explicit Runge-Kutta steppers and their step control ask for
// the functions below.
#pragma once

#include <algorithm>
#include <cmath>

namespace rotorbench::bench {

struct LoopAlgebra {
  template <class Op, class First, class... Rest>
  static void each(Op op, First& first, Rest&... rest) {
    for (int i = 0; i < First::RowsAtCompileTime; ++i) op(first[i], rest[i]...);
  }
  // clang-format off
  template <class A, class B, class Op> static void for_each2(A& a, B& b, Op op) { each(op, a, b); }
  template <class A, class B, class C, class Op>
  static void for_each3(A& a, B& b, C& c, Op op) { each(op, a, b, c); }
  template <class A, class B, class C, class D, class Op>
  static void for_each4(A& a, B& b, C& c, D& d, Op op) { each(op, a, b, c, d); }
  template <class A, class B, class C, class D, class E, class Op>
  static void for_each5(A& a, B& b, C& c, D& d, E& e, Op op) { each(op, a, b, c, d, e); }
  template <class A, class B, class C, class D, class E, class F, class Op>
  static void for_each6(A& a, B& b, C& c, D& d, E& e, F& f, Op op) { each(op, a, b, c, d, e, f); }
  template <class A, class B, class C, class D, class E, class F, class G, class Op>
  static void for_each7(A& a, B& b, C& c, D& d, E& e, F& f, G& g, Op op) {
    each(op, a, b, c, d, e, f, g);
  }
  template <class A, class B, class C, class D, class E, class F, class G, class H, class Op>
  static void for_each8(A& a, B& b, C& c, D& d, E& e, F& f, G& g, H& h, Op op) {
    each(op, a, b, c, d, e, f, g, h);
  }
  // clang-format on
  template <class A>
  static double norm_inf(const A& a) {
    double largest = 0;
    for (int i = 0; i < A::RowsAtCompileTime; ++i) largest = std::max(largest, std::abs(a[i]));
    return largest;
  }
};

}  // namespace rotorbench::bench
