// A made-up described document with every kind of member, for tests of the schema tree and of
// files.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/core/schema.h"

namespace rotorbench::sample {

enum class Solver { Euler, Rk4, Dopri };

struct Blade {
  double radius = 0.12;
  double twist = 0.1;
  bool operator==(const Blade&) const = default;
};

struct Rotor {
  std::string name = "rotor";
  double speed = 100;
  Eigen::Vector3d position{0.1, 0, 0};
  std::vector<Blade> blades{{}, {0.05, 0.3}};
  bool operator==(const Rotor&) const = default;
};

struct Pid {
  double kp = 1.5;
  double ki = 0;
  bool operator==(const Pid&) const = default;
};

struct Lqr {
  double weight = 2;
  int horizon = 10;
  bool operator==(const Lqr&) const = default;
};

struct Vehicle {
  double mass = 1.2;
  double diameter = 0.24003;
  std::vector<Rotor> rotors{{}, {.name = "second"}};
  bool operator==(const Vehicle&) const = default;
};

struct Document {
  std::string title = "Sample";
  Solver solver = Solver::Rk4;
  bool wind = false;
  int steps = 1000;
  std::uint64_t seed = 1;
  double gain = 0.25;
  double low = 0;
  double high = 1;
  Vehicle vehicle;
  std::variant<Pid, Lqr> controller;
  bool operator==(const Document&) const = default;
};

}  // namespace rotorbench::sample

namespace rotorbench {

template <>
struct Describe<sample::Blade> {
  static void fields(schema::Builder<sample::Blade>& b) {
    b.title("blade", "Blade section", "One section of a blade.");
    b.number("radius", &sample::Blade::radius, "Radius", "r", "m").positive().shownIn("cm");
    b.number("twist", &sample::Blade::twist, "Twist", "θ", "rad").shownIn("deg");
  }
};

template <>
struct Describe<sample::Rotor> {
  static void fields(schema::Builder<sample::Rotor>& b) {
    b.title("rotor", "Rotor", "A rotor on its motor.");
    b.text("name", &sample::Rotor::name, "Name");
    b.number("speed", &sample::Rotor::speed, "Speed", "Ω", "rad/s").notNegative().shownIn("rpm");
    b.vector("position", &sample::Rotor::position, "Position", "p", "m")
        .range(schema::atLeast(-10), schema::upTo(10));
    b.list("blades", &sample::Rotor::blades, "Blade sections").table().items(0, 20);
  }
};

template <>
struct Describe<sample::Pid> {
  static void fields(schema::Builder<sample::Pid>& b) {
    b.title("pid", "PID", "Proportional, integral, derivative.");
    b.number("kp", &sample::Pid::kp, "Proportional gain", "k_p", "1").notNegative();
    b.number("ki", &sample::Pid::ki, "Integral gain", "k_i", "1/s").notNegative();
  }
};

template <>
struct Describe<sample::Lqr> {
  static void fields(schema::Builder<sample::Lqr>& b) {
    b.title("lqr", "LQR", "Linear quadratic regulator.");
    b.number("weight", &sample::Lqr::weight, "Weight", "q", "1").positive();
    b.integer("horizon", &sample::Lqr::horizon, "Horizon")
        .range(schema::atLeast(1), schema::upTo(99));
  }
};

template <>
struct Describe<sample::Vehicle> {
  static void fields(schema::Builder<sample::Vehicle>& b) {
    b.title("vehicle", "Vehicle", "What flies.");
    b.number("mass", &sample::Vehicle::mass, "Mass", "m", "kg")
        .range(schema::above(0), schema::upTo(100))
        .source("weighed");
    b.number("diameter", &sample::Vehicle::diameter, "Diameter", "D", "m").positive().shownIn("in");
    b.list("rotors", &sample::Vehicle::rotors, "Rotors").items(1, 8);
  }
};

template <>
struct Describe<sample::Document> {
  static void fields(schema::Builder<sample::Document>& b) {
    using sample::Document;
    using sample::Solver;
    b.title("sample", "Sample", "Every kind of member.");
    b.text("title", &Document::title, "Title");
    b.choice<Solver>("solver", &Document::solver, "Solver",
                     {{Solver::Euler, "euler", "Euler", "first order"},
                      {Solver::Rk4, "rk4", "RK4", "fourth order"},
                      {Solver::Dopri, "dopri5", "RK5(4)7M", "adaptive"}});
    b.boolean("wind", &Document::wind, "Wind");
    b.integer("steps", &Document::steps, "Steps").range(schema::atLeast(1), schema::upTo(1e6));
    b.integer("seed", &Document::seed, "Seed");
    b.number("gain", &Document::gain, "Gain", "k", "1");
    b.number("low", &Document::low, "Low", "a", "s");
    b.number("high", &Document::high, "High", "b", "s").shownIn("ms");
    b.group("vehicle", &Document::vehicle, "Vehicle");
    b.variant("controller", &Document::controller, "Controller");
    b.check([](const Document& d, std::vector<Problem>& problems) {
      if (!(d.low < d.high))
        problems.push_back({"low", "low is not below high", "must be below high"});
    });
  }
};

}  // namespace rotorbench
