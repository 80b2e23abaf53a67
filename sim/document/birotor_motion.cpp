#include "sim/document/birotor_motion.h"

namespace rotorbench {

void Describe<BirotorMotion>::fields(schema::Builder<BirotorMotion>& b) {
  b.title("birotor", "Birotor motion",
          "Two rotors on a bar in a plane, moved by constant forces with one solver.",
          "Thesis 2014, chapter 2");
  b.variant("plant", &BirotorMotion::plant, "Birotor");
  b.group("solver", &BirotorMotion::solver, "Solver");
  b.number("sampleInterval", &BirotorMotion::sampleInterval, "Sample interval", "h", "s")
      .range(schema::atLeast(1e-9), schema::upTo(10))
      .shownIn("ms")
      .help(
          "The solver ends a step at every sample instant; recorded rows are a multiple of it "
          "apart.");
  b.number("duration", &BirotorMotion::duration, "Duration", "T", "s")
      .range(schema::above(0), schema::upTo(36000));
  b.check([](const BirotorMotion& m, std::vector<Problem>& problems) {
    if (m.solver.method == ode::Method::ExponentialRk4) {
      problems.push_back({"solver.method", "Exponential RK4 needs motors, and a birotor has none",
                          "choose another method"});
    }
  });
}

}  // namespace rotorbench
