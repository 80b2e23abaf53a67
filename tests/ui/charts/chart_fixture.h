// Recordings made for chart tests: values that a person can work out in the head.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "sim/core/recording.h"
#include "ui/charts/run_set.h"

namespace rotorbench::fixture {

/// Channels of a small aircraft: rotor1..4.thrust [N], position.x [m], error [m].
inline std::vector<Channel> channels() {
  std::vector<Channel> all{{"time", "s", "Simulated time"}};
  for (int i = 1; i <= 4; ++i)
    all.push_back({"rotor" + std::to_string(i) + ".thrust", "N", "Thrust"});
  all.push_back({"position.x", "m", "North"});
  all.push_back({"error", "m", "Distance from the set-point"});
  return all;
}

/// At time t: rotor i has thrust i + t, position.x = -2 t, error = 10^(-t).
inline void appendRow(Recording& recording, double t) {
  const double row[] = {t, 1 + t, 2 + t, 3 + t, 4 + t, -2 * t, std::pow(10.0, -t)};
  recording.append(row);
}

/// `rows` rows from 0 to `end` seconds.
inline std::shared_ptr<Recording> ramp(int rows, double end = 10, bool finish = true) {
  auto recording = std::make_shared<Recording>(channels());
  for (int i = 0; i < rows; ++i) appendRow(*recording, end * i / (rows - 1));
  recording->publish();
  if (finish) recording->finish();
  return recording;
}

inline ChartRun run(const QString& id, std::shared_ptr<const Recording> recording,
                    const QColor& color = QColor(0, 114, 178)) {
  return {id, QStringLiteral("Run ") + id, color, std::move(recording), true};
}

}  // namespace rotorbench::fixture
