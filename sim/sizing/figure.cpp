#include "sim/sizing/figure.h"

#include <cmath>
#include <stdexcept>

#include "sim/core/units.h"

namespace rotorbench {

const Figure& FigureSheet::at(const std::string& key) const {
  for (const auto& figure : figures) {
    if (figure.key == key) return figure;
  }
  throw std::out_of_range("no figure " + key);
}

std::string figureNumber(const Figure& figure, const NumberWriter& write) {
  constexpr int kDigits = 4;
  return write(fromSi(figure.value, unitFactor(figure.unit, figure.shownUnit)), kDigits);
}

std::string figureText(const Figure& figure, const NumberWriter& write) {
  const std::string number = figureNumber(figure, write);
  if (std::isnan(figure.value) || figure.shownUnit == "1") return number;
  return number + " " + figure.shownUnit;
}

}  // namespace rotorbench
