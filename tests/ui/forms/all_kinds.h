// A described document with every kind of field, for the tests of the forms. The forms know nothing
// of it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "sim/core/schema.h"

namespace rotorbench::forms_test {

enum class Method { Euler, RungeKutta4, Adams };

struct Winding {
  double resistance = 0.117;  // Ohm
  double inductance = 25e-6;  // H
  std::int64_t poles = 14;
  bool operator==(const Winding&) const = default;
};

struct Motor {
  std::string name = "M1";
  Winding winding;
  double mass = 0.05;          // kg
  double speedLimit = 1000.0;  // rad/s
  double arm = 0.225;          // m
  double friction = 2e-5;      // N m s
  std::vector<double> unused;  // not described, must not matter
  bool operator==(const Motor&) const = default;
};

struct Still {
  double density = 1.225;  // kg/m^3
  bool operator==(const Still&) const = default;
};

struct Gusty {
  double meanSpeed = 5;  // m/s
  double scale = 100;    // m
  bool operator==(const Gusty&) const = default;
};

struct Event {
  double time = 0;                    // s
  Eigen::Vector3d point = {0, 0, 1};  // m
  Method method = Method::RungeKutta4;
  bool relative = false;
  bool operator==(const Event&) const = default;
};

struct Document {
  std::string title = "Bench";
  std::string notes;
  std::string file;
  std::string channels;
  double span = 0.25;  // m
  std::int64_t steps = 10;
  bool record = true;
  Method method = Method::RungeKutta4;
  Eigen::Vector3d start = {0, 0, 1};  // m
  double low = 1;
  double high = 2;
  double tolerance = 1e-9;
  Winding winding;
  std::variant<Still, Gusty> wind;
  std::vector<Motor> motors = std::vector<Motor>(2);
  std::vector<Event> timeline = std::vector<Event>(2);
  bool operator==(const Document&) const = default;
};

}  // namespace rotorbench::forms_test

namespace rotorbench {

template <>
struct Describe<forms_test::Winding> {
  using T = forms_test::Winding;
  static void fields(schema::Builder<T>& b) {
    b.title("winding", "Winding", "Copper of one phase.");
    b.number("resistance", &T::resistance, "Phase resistance", "R_a", "Ohm")
        .range(schema::above(0), schema::upTo(100))
        .help("Of one phase, at 20 degrees.")
        .source("DJI E305 data sheet");
    b.number("inductance", &T::inductance, "Inductance", "L", "H").positive().shownIn("uH");
    b.integer("poles", &T::poles, "Poles", "p").range(schema::atLeast(2), schema::upTo(60));
  }
};

template <>
struct Describe<forms_test::Motor> {
  using T = forms_test::Motor;
  static void fields(schema::Builder<T>& b) {
    b.title("motor", "Motor", "A direct-current machine that turns one propeller.");
    b.text("name", &T::name, "Name");
    b.group("winding", &T::winding, "Winding");
    b.number("mass", &T::mass, "Mass", "m", "kg").positive().shownIn("g");
    b.number("speedLimit", &T::speedLimit, "Speed limit", "ω_max", "rad/s")
        .positive()
        .shownIn("rpm");
    b.number("arm", &T::arm, "Arm", "l", "m").positive().shownIn("cm");
    b.number("friction", &T::friction, "Viscous friction", "D", "N*m*s").notNegative();
  }
};

template <>
struct Describe<forms_test::Still> {
  using T = forms_test::Still;
  static void fields(schema::Builder<T>& b) {
    b.title("still", "Still air", "Air at rest.");
    b.number("density", &T::density, "Air density", "ρ", "kg/m^3").positive();
  }
};

template <>
struct Describe<forms_test::Gusty> {
  using T = forms_test::Gusty;
  static void fields(schema::Builder<T>& b) {
    b.title("gusty", "Gusty wind", "A mean wind with Dryden turbulence.");
    b.number("meanSpeed", &T::meanSpeed, "Mean speed", "V", "m/s").notNegative();
    b.number("scale", &T::scale, "Length scale", "L", "m").positive();
  }
};

inline std::vector<schema::Named<forms_test::Method>> methodNames() {
  using forms_test::Method;
  return {{Method::Euler, "euler", "Euler", "First order."},
          {Method::RungeKutta4, "rk4", "Runge-Kutta 4", "Fourth order."},
          {Method::Adams, "abm4", "Adams-Bashforth-Moulton", "Predictor and corrector."}};
}

template <>
struct Describe<forms_test::Event> {
  using T = forms_test::Event;
  static void fields(schema::Builder<T>& b) {
    b.title("event", "Event", "A set-point.");
    b.number("time", &T::time, "Time", "t", "s").notNegative();
    b.vector("point", &T::point, "Point", "p", "m").range(schema::atLeast(-100), schema::upTo(100));
    b.choice("method", &T::method, "Method", methodNames());
    b.boolean("relative", &T::relative, "Relative");
  }
};

template <>
struct Describe<forms_test::Document> {
  using T = forms_test::Document;
  static void fields(schema::Builder<T>& b) {
    b.title("bench", "Bench", "A document with every kind of field.");
    b.text("title", &T::title, "Title");
    b.number("span", &T::span, "Span", "b", "m")
        .range(schema::above(0), schema::upTo(2))
        .shownIn("cm")
        .help("Distance between opposite motors.")
        .source("Thesis, table 3");
    b.integer("steps", &T::steps, "Steps", "n").range(schema::atLeast(1), schema::upTo(1000));
    b.boolean("record", &T::record, "Record everything");
    b.choice("method", &T::method, "Method", methodNames());
    b.vector("start", &T::start, "Start position", "p_0", "m")
        .range(schema::atLeast(-100), schema::upTo(100));
    b.number("low", &T::low, "Lower limit", "", "1");
    b.number("high", &T::high, "Upper limit", "", "1");
    b.number("tolerance", &T::tolerance, "Tolerance", "ε", "1").positive().advanced();
    b.group("winding", &T::winding, "Winding");
    b.variant("wind", &T::wind, "Wind");
    b.list("motors", &T::motors, "Motors").items(1, 4);
    b.list("timeline", &T::timeline, "Timeline").items(0, 50).table();
    b.text("notes", &T::notes, "Notes").role(schema::TextRole::Paragraph);
    b.text("file", &T::file, "Measured file").role(schema::TextRole::FilePath);
    b.text("channels", &T::channels, "Channels").role(schema::TextRole::Channels);
    b.check([](const T& d, std::vector<Problem>& problems) {
      if (d.low > d.high) problems.push_back({"low", "the lower limit is above the upper", {}});
    });
  }
};

}  // namespace rotorbench
