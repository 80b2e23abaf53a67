// Where the marks of a linear axis stand: at whole multiples of 1, 2 or 5 times a power of ten.
#pragma once

#include <array>
#include <vector>

namespace rotorbench {

/// The step between marks that divides `width`, above 0, into at most `most` parts, 1 or more.
double markStep(double width, int most);

/// The multiples of `step`, above 0, from low to high; none where no multiple lies between. An end
/// that is a multiple but for rounding counts as one, here and below.
std::vector<double> marksWithin(double low, double high, double step);

/// The multiples of `step` that low to high lies between, as close as there are: low end, high end.
std::array<double, 2> marksBeyond(double low, double high, double step);

/// Those two with all between them, finite ends given; two marks at least.
std::vector<double> marksAround(double low, double high, double step);

/// Digits behind the point that tell marks `step` apart.
int markDecimals(double step);

}  // namespace rotorbench
