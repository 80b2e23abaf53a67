// The 101 propellers of tests/data/uiuc, read once: geometry, static and in-flight coefficients.
#pragma once

#include <QFile>
#include <QStringList>
#include <QTextStream>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "sim/propulsion/blade.h"

namespace uiuc {

/// One measured point.
struct Row {
  double rpm = 0, advance = 0, thrust = 0, power = 0;  // CT and CP
};

struct Set {
  QString name;  ///< volume, propeller and static file: a propeller may have two sets
  double pitchRatio = 0;
  rotorbench::PropellerGeometry geometry;
  std::vector<Row> still;
  std::vector<std::vector<Row>> flights;
};

inline std::vector<QStringList> rowsOf(const QString& file) {
  QFile source(QStringLiteral(TEST_DATA_DIR "/uiuc/") + file);
  if (!source.open(QIODevice::ReadOnly | QIODevice::Text)) {
    throw std::runtime_error("cannot read " + source.fileName().toStdString());
  }
  QTextStream stream(&source);
  stream.readLine();
  std::vector<QStringList> rows;
  while (!stream.atEnd()) rows.push_back(stream.readLine().split(','));
  return rows;
}

inline std::vector<Set> readSets() {
  constexpr double kInch = 0.0254;
  std::vector<Set> sets;
  for (const QStringList& row : rowsOf("sets.csv")) {
    Set& set = sets.emplace_back();
    set.name = row[1] + ' ' + row[2] + ' ' + row[3];
    set.pitchRatio = row[6].toDouble();
    rotorbench::PropellerGeometry& g = set.geometry;
    g.blades = row[4].toInt();
    g.diameter = row[5].toDouble() * kInch;
    g.pitch = set.pitchRatio * g.diameter;
    g.line = row[7] == "1" ? rotorbench::BladeLine::SlowFlyer : rotorbench::BladeLine::Standard;
    g.stations.clear();
  }
  for (const QStringList& row : rowsOf("geometry.csv")) {
    sets.at(row[0].toUInt())
        .geometry.stations.push_back(
            {row[1].toDouble(), row[2].toDouble(), row[3].toDouble() * std::numbers::pi / 180});
  }
  for (const QStringList& row : rowsOf("performance.csv")) {
    Set& set = sets.at(row[0].toUInt());
    const Row point{row[2].toDouble(), row[3].toDouble(), row[4].toDouble(), row[5].toDouble()};
    const std::size_t run = row[1].toUInt();
    if (run > set.flights.size()) set.flights.resize(run);
    (run == 0 ? set.still : set.flights[run - 1]).push_back(point);
  }
  return sets;
}

}  // namespace uiuc
