// The small picture on a gallery card: the experiment's vehicle drawn from its own geometry, or a
// plain chart where there is no vehicle.
#pragma once

#include <QImage>
#include <QPalette>

#include "sim/document/experiment.h"

namespace rotorbench {

/// Any thread. `size` in device-independent pixels; the image has `scale` times as many.
QImage experimentPicture(const Experiment& experiment, const QSize& size, qreal scale,
                         const QPalette& palette);

}  // namespace rotorbench
