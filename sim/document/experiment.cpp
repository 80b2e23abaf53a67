#include "sim/document/experiment.h"

#include "sim/core/box_members.h"
#include "sim/document/kinds.h"

namespace rotorbench {

using schema::above;
using schema::atLeast;
using schema::upTo;

void Describe<OutputSettings>::fields(schema::Builder<OutputSettings>& b) {
  b.title("outputs", "Outputs",
          "What is recorded, and the chart panes shown when the experiment is opened.");
  b.number("recordInterval", &OutputSettings::recordInterval, "Record every", "", "s")
      .range(above(0), upTo(60))
      .shownIn("ms")
      .help("Interval between recorded rows; rounded to whole ticks of the experiment.");
  b.number("memoryLimit", &OutputSettings::memoryLimit, "Memory limit", "", "B")
      .range(atLeast(1e6), upTo(1e12))
      .shownIn("MB")
      .help("Memory that all recordings of one run of the experiment may take together.")
      .advanced();
  b.boolean("thinWhenFull", &OutputSettings::thinWhenFull, "Thin out when full")
      .help(
          "Near the memory limit keep every second row, then every fourth, and so on. Otherwise "
          "the run stops "
          "at the limit; what was recorded is kept.")
      .advanced();
  b.list("charts", &OutputSettings::charts, "Charts")
      .items(0, 64)
      .help("With none, the usual charts of this kind of experiment are shown.");
}

void Describe<Experiment>::fields(schema::Builder<Experiment>& b) {
  b.title("experiment", "Experiment", "Everything a run needs.");
  b.text("title", &Experiment::title, "Title")
      .help("Shown on the gallery card and in exported figures.");
  b.text("summary", &Experiment::summary, "Summary").help("One line for the gallery card.");
  b.text("notes", &Experiment::notes, "Notes").role(schema::TextRole::Paragraph);
  b.variant("setup", &Experiment::setup, "Experiment kind");
  b.group("outputs", &Experiment::outputs, "Outputs");
  b.integer("seed", &Experiment::seed, "Random seed")
      .help(
          "Every random stream of the run is derived from it: the same seed gives the same bits.");
}

template class Box<Flight>;
template class Box<MotorBench>;
template class Box<PropellerBench>;
template class Box<ThrustStand>;
template class Box<MotorSpeedRun>;
template class Box<SolverComparison>;
template class Box<BirotorMotion>;

}  // namespace rotorbench
