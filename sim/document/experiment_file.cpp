#include "sim/document/experiment_file.h"

#include "sim/io/file.h"
#include "sim/io/json_document.h"
#include "sim/io/json_schema.h"

namespace rotorbench {

Experiment readExperiment(std::string_view text, const std::string& source) {
  Experiment experiment;
  readDocument(schema::ref(experiment), text, source);
  return experiment;
}

Experiment loadExperiment(const std::filesystem::path& file) {
  return readExperiment(readTextFile(file), file.string());
}

std::string writeExperiment(const Experiment& experiment) {
  return writeDocument(schema::ref(experiment));
}

void saveExperiment(const Experiment& experiment, const std::filesystem::path& file) {
  writeFileAtomically(file, writeExperiment(experiment));
}

std::string experimentJsonSchema() {
  return jsonSchema(schema::typeOf<Experiment>());
}

}  // namespace rotorbench
