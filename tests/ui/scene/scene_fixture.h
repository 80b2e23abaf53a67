// A vehicle and recordings made for the scene tests: the size of an F450 (225 mm arms, 9.4 inch
// propellers, plain round numbers elsewhere), and flights along given positions. Helpers that read
// pixels.
#pragma once

#include <QImage>
#include <QRect>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>

#include "sim/core/recording.h"
#include "sim/scene/scene_model.h"

namespace rotorbench {

inline SceneModel quadrotorModel(int blades = 2) {
  SceneModel model;
  model.title = "Quadrotor";
  model.bodyRadius = 0.06;
  model.fullThrust = 8;
  for (int i = 0; i < 4; ++i) {
    const double azimuth = std::numbers::pi * (0.25 + 0.5 * i);
    SceneRotor rotor;
    rotor.position = {0.225 * std::cos(azimuth), 0.225 * std::sin(azimuth), 0.02};
    rotor.axis = Eigen::Vector3d::UnitZ();
    rotor.spin = i % 2 == 0 ? 1 : -1;
    rotor.radius = 0.119;
    rotor.blades = blades;
    for (const double r : {0.015, 0.05, 0.09, 0.119}) {
      rotor.stations.push_back({r, 0.03 - 0.1 * r, std::atan(0.02 / r)});
    }
    rotor.motorRadius = 0.014;
    rotor.motorHeight = 0.025;
    model.rotors.push_back(rotor);
  }
  return model;
}

inline SceneModel birotorModel(bool elastic) {
  SceneModel model;
  model.elasticArms = elastic;
  model.fullThrust = 10;
  for (const double side : {-0.5, 0.5}) {
    SceneRotor rotor;
    rotor.position = {0, side, 0};
    rotor.axis = Eigen::Vector3d::UnitZ();
    rotor.spin = side < 0 ? 1 : -1;
    rotor.radius = 0.2;
    rotor.blades = 2;
    rotor.motorRadius = 0.03;
    rotor.motorHeight = 0.05;
    model.rotors.push_back(rotor);
  }
  return model;
}

inline std::vector<Channel> flightChannels() {
  std::vector<Channel> channels{{"time", "s", ""}};
  for (const char* axis : {"x", "y", "z"}) {
    channels.push_back({std::string("position.") + axis, "m", ""});
  }
  for (const char* part : {"w", "x", "y", "z"}) {
    channels.push_back({std::string("attitude.") + part, "1", ""});
  }
  for (int i = 1; i <= 4; ++i) {
    channels.push_back({"rotor" + std::to_string(i) + ".speed", "rad/s", ""});
    channels.push_back({"rotor" + std::to_string(i) + ".thrust", "N", ""});
  }
  for (const char* axis : {"x", "y", "z"}) {
    channels.push_back({std::string("setpoint.") + axis, "m", ""});
  }
  return channels;
}

/// A row of flightChannels(): level, every rotor at this speed with 4 N, set-point 1 m up.
inline std::vector<double> flightRow(double time, const Eigen::Vector3d& position,
                                     double speed = 600) {
  std::vector<double> row{time, position.x(), position.y(), position.z(), 1, 0, 0, 0};
  for (int i = 0; i < 4; ++i) row.insert(row.end(), {speed, 4.0});
  row.insert(row.end(), {0, 0, 1});
  return row;
}

/// A sample every 10 ms from 0 to `seconds`.
inline std::shared_ptr<Recording> flightAlong(
    const std::function<Eigen::Vector3d(double)>& position, double seconds, double speed = 600) {
  auto recording = std::make_shared<Recording>(flightChannels());
  const int rows = static_cast<int>(std::lround(100 * seconds));
  for (int k = 0; k <= rows; ++k) {
    recording->append(flightRow(0.01 * k, position(0.01 * k), speed));
  }
  recording->publish();
  recording->finish();
  return recording;
}

/// At rest in the origin until 1 s, then at `moved`.
inline std::shared_ptr<Recording> flightStep(const Eigen::Vector3d& moved, double speed = 0) {
  return flightAlong([moved](double t) { return t < 0.995 ? Eigen::Vector3d(0, 0, 0) : moved; },
                     2.0, speed);
}

inline bool isOrange(QRgb pixel) {
  return qRed(pixel) > 130 && qGreen(pixel) > 40 && qGreen(pixel) < 130 && qBlue(pixel) < 70;
}

inline bool isGreen(QRgb pixel) {
  return qGreen(pixel) > qRed(pixel) + 40 && qGreen(pixel) > qBlue(pixel) + 15;
}

inline int countPixels(const QImage& image, const std::function<bool(QRgb)>& wanted) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) count += wanted(image.pixel(x, y)) ? 1 : 0;
  }
  return count;
}

/// Middle of the wanted pixels, nothing if there are fewer than 20.
inline std::optional<QPointF> centroid(const QImage& image,
                                       const std::function<bool(QRgb)>& wanted) {
  QPointF sum;
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!wanted(image.pixel(x, y))) continue;
      sum += QPointF(x, y);
      ++count;
    }
  }
  if (count < 20) return std::nullopt;
  return sum / count;
}

inline int differingPixels(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < std::min(a.height(), b.height()); ++y) {
    for (int x = 0; x < std::min(a.width(), b.width()); ++x) {
      count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace rotorbench
