// A number with its slope along one direction: the scalar with which equations written over any
// scalar give exact derivatives, one direction a pass. Eigen's AutoDiffScalar does the same with
// expression templates; over all rotors of a vehicle they cost the compiler half as much again.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace rotorbench {

class Dual {
 public:
  Dual() = default;
  Dual(double value, double slope = 0) : value_(value), slope_(slope) {}  // NOLINT: a number is one

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double slope() const { return slope_; }

  Dual operator-() const { return {-value_, -slope_}; }
  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend Dual operator+(const Dual& a, const Dual& b) {
    return {a.value_ + b.value_, a.slope_ + b.slope_};
  }
  friend Dual operator-(const Dual& a, const Dual& b) {
    return {a.value_ - b.value_, a.slope_ - b.slope_};
  }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value_ * b.value_, a.slope_ * b.value_ + a.value_ * b.slope_};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const double ratio = a.value_ / b.value_;
    return {ratio, (a.slope_ - ratio * b.slope_) / b.value_};
  }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value_ < b.value_; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value_ > b.value_; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value_ <= b.value_; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value_ >= b.value_; }
  friend bool operator==(const Dual& a, const Dual& b) { return a.value_ == b.value_; }
  friend bool operator!=(const Dual& a, const Dual& b) { return a.value_ != b.value_; }

  friend Dual abs(const Dual& a) { return a.value_ < 0 ? -a : a; }
  friend Dual sqrt(const Dual& a) {
    const double root = std::sqrt(a.value_);
    return {root, a.slope_ / (2 * root)};
  }
  friend Dual exp(const Dual& a) {
    const double e = std::exp(a.value_);
    return {e, e * a.slope_};
  }
  friend Dual log(const Dual& a) { return {std::log(a.value_), a.slope_ / a.value_}; }
  friend Dual pow(const Dual& a, double power) {
    return {std::pow(a.value_, power), power * std::pow(a.value_, power - 1) * a.slope_};
  }
  friend Dual atan2(const Dual& y, const Dual& x) {
    const double square = x.value_ * x.value_ + y.value_ * y.value_;
    return {std::atan2(y.value_, x.value_), (x.value_ * y.slope_ - y.value_ * x.slope_) / square};
  }
  friend Dual asin(const Dual& a) {
    return {std::asin(a.value_), a.slope_ / std::sqrt(1 - a.value_ * a.value_)};
  }
  friend Dual tan(const Dual& a) {
    const double t = std::tan(a.value_);
    return {t, (1 + t * t) * a.slope_};
  }
  friend Dual sin(const Dual& a) { return {std::sin(a.value_), std::cos(a.value_) * a.slope_}; }
  friend Dual cos(const Dual& a) { return {std::cos(a.value_), -std::sin(a.value_) * a.slope_}; }
  friend bool isfinite(const Dual& a) { return std::isfinite(a.value_); }

 private:
  double value_ = 0, slope_ = 0;
};

}  // namespace rotorbench

namespace Eigen {

template <>
struct NumTraits<rotorbench::Dual> : NumTraits<double> {
  using Real = rotorbench::Dual;
  using NonInteger = rotorbench::Dual;
  using Nested = rotorbench::Dual;
  using Literal = rotorbench::Dual;
  enum { RequireInitialization = 1, ReadCost = 2, AddCost = 2, MulCost = 4 };
};
template <class Operation>
struct ScalarBinaryOpTraits<rotorbench::Dual, double, Operation> {
  using ReturnType = rotorbench::Dual;
};
template <class Operation>
struct ScalarBinaryOpTraits<double, rotorbench::Dual, Operation> {
  using ReturnType = rotorbench::Dual;
};

}  // namespace Eigen
