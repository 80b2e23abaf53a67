#include "ui/runs/run_colors.h"

#include <array>

namespace rotorbench {

QColor runColor(int index) {
  static constexpr std::array<QRgb, kRunColorCount> kColors{
      0xff0072b2, 0xffd55e00, 0xff009e73, 0xffcc79a7, 0xffe69f00, 0xff56b4e9, 0xff8c8c8c};
  return QColor::fromRgb(kColors.at(static_cast<std::size_t>(index) % kColors.size()));
}

}  // namespace rotorbench
