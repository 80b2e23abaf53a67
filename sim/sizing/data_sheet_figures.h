// What follows from a data sheet: the constants of the drive, the hover of the vehicle it carries,
// full throttle and how fast the drive answers. Every figure has its formula; steady points come
// from DriveTrain.
#pragma once

#include <vector>

#include "sim/sizing/data_sheet.h"
#include "sim/sizing/figure.h"

namespace rotorbench {

/// The sheet must satisfy its schema. Figures of the hover are NaN where the drive cannot carry the
/// vehicle.
FigureSheet figuresOf(const DataSheet& sheet);

/// Steady points over the throttle for a chart, with the hover point beside.
struct ThrottleCurve {
  struct Point {
    double throttle, thrust, current, speed;  ///< of one motor: 1, N, A, rad/s
  };
  std::vector<Point> points;
  std::vector<Point> hover;  ///< one, or none where the drive cannot carry the vehicle
};
ThrottleCurve throttleCurve(const DataSheet& sheet, int points = 61);

/// T^1.5/sqrt(2 rho A)/P: ideal power of a hovering disc over the power it takes; 1 at most for any
/// real propeller.
double figureOfMerit(double thrust, double shaftPower, double radius, double density);

}  // namespace rotorbench
