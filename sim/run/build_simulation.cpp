#include "sim/core/schema_tree.h"
#include "sim/document/kinds.h"
#include "sim/run/builders.h"
#include "sim/run/simulation.h"

namespace rotorbench {

std::unique_ptr<Simulation> buildSimulation(const Experiment& experiment,
                                            const std::filesystem::path& directory) {
  auto problems = schema::validate(schema::ref(experiment));
  std::erase_if(problems, [](const Problem& p) { return p.warning; });
  if (!problems.empty()) throw InputError({}, std::move(problems));
  const BuildContext context{experiment.outputs, experiment.seed, directory, Place("setup")};
  return visitAlternative([&](const auto& setup) { return build(setup, context); },
                          experiment.setup);
}

}  // namespace rotorbench
