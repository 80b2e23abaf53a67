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

Figure& FigureGroup::add(const char* key, const char* label, const char* symbol, double value,
                         const char* unit, const char* shown, Sentence formula,
                         const char* source) {
  sheet_.figures.push_back({key_ + "." + key,
                            title_,
                            label,
                            symbol,
                            value,
                            unit,
                            shown,
                            std::move(formula),
                            source,
                            {}});
  return sheet_.figures.back();
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
