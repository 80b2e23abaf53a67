// The plain number behind a scalar: physics is written over any scalar (double, automatic
// differentiation), and tables need a number to find their cell.
#pragma once

namespace rotorbench {

inline double valueOf(double v) {
  return v;
}
template <class S>
double valueOf(const S& v) {
  return v.value();
}

}  // namespace rotorbench
